// SPDX-License-Identifier: MIT
#include "proofs/dense.hpp"

#include <algorithm>

namespace touchstone::proofs {
namespace {

/// Binomial coefficient C(n, k), exact for the small n here.
double binomial(std::size_t n, std::size_t k) {
  double c = 1;
  for (std::size_t i = 0; i < k; ++i) c = c * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return c;
}

}  // namespace

Dense operator+(const Dense& p, const Dense& q) {
  Dense sum = p.size() < q.size() ? q : p;
  const Dense& shorter = p.size() < q.size() ? p : q;
  for (std::size_t i = 0; i < shorter.size(); ++i) sum[i] = sum[i] + shorter[i];
  return sum;
}

Dense operator-(const Dense& p, const Dense& q) {
  Dense difference = p;
  difference.resize(std::max(p.size(), q.size()));
  for (std::size_t i = 0; i < q.size(); ++i) difference[i] = difference[i] - q[i];
  return difference;
}

Dense operator*(const Dense& p, const Dense& q) {
  if (p.empty() || q.empty()) return {};
  Dense product(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] = product[i + j] + p[i] * q[j];
  }
  return product;
}

bool is_zero(const Dense& p) {
  return std::all_of(p.begin(), p.end(), [](const Exact& c) { return numbers::is_zero(c); });
}

Exact value(const Dense& p, const Exact& t) {
  Exact sum;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}

int sign_over(const Dense& p, const Exact& from, const Exact& to, bool open) {
  if (p.empty()) return 0;
  const std::size_t degree = p.size() - 1;
  const int first = numbers::sign_of(value(p, from));
  if (first == 0) return 0;
  // q(x) = p(from + x (to - from)): Taylor's shift by Horner's scheme, and powers of the width.
  Dense q = p;
  for (std::size_t i = 0; i < degree; ++i) {
    for (std::size_t j = degree; j-- > i;) q[j] = q[j] + q[j + 1] * from;
  }
  const Exact width = to - from;
  Exact power = width;
  for (std::size_t i = 1; i <= degree; ++i) {
    q[i] = q[i] * power;
    if (i < degree) power = power * width;
  }
  // The coefficient b_i is the sum over j <= i of C(i, j) / C(d, j) q_j. The factor d!, which is positive, makes
  // d! / C(d, j) = j! (d - j)! whole; all of these are doubles for d <= 18.
  Dense weighted = q;
  for (std::size_t j = 0; j <= degree; ++j) {
    double factor = 1;
    for (std::size_t k = 2; k <= j; ++k) factor *= static_cast<double>(k);
    for (std::size_t k = 2; k + j <= degree; ++k) factor *= static_cast<double>(k);
    weighted[j] = weighted[j] * Exact(factor);
  }
  for (std::size_t i = 1; i <= degree; ++i) {
    Exact b = weighted[0];
    for (std::size_t j = 1; j <= i; ++j) b = b + weighted[j] * Exact(binomial(i, j));
    const int sign = numbers::sign_of(b);
    if (sign != first && !(open && sign == 0)) return 0;
  }
  return first;
}

DenseVector operator-(const DenseVector& a, const DenseVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Dense dot(const DenseVector& a, const DenseVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

DenseVector cross(const DenseVector& a, const DenseVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace touchstone::proofs
