// SPDX-License-Identifier: MIT
#include "proofs/dense.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "numbers/integers/common_denominator.hpp"

namespace touchstone::proofs {
namespace {

/// The Bernstein coefficients b_i of p over [from, to], each multiplied by the binomial coefficient C(d, i) > 0. With
/// p(from + s (to - from)) = sum c_j s^j and 1 = (1 - s) + s, p is the sum of the c_j s^j ((1 - s) + s)^(d - j), a
/// polynomial of s and 1 - s.
Dense bernstein(const Dense& p, const Exact& from, const Exact& to) {
  Dense b = p;
  const std::size_t size = b.size();
  if (!numbers::is_zero(from)) {  // Taylor's shift by Horner's scheme
    for (std::size_t k = 1; k < size; ++k) {
      for (std::size_t i = size - 1; i >= k; --i) b[i - 1] = b[i - 1] + b[i] * from;
    }
  }
  const Exact width = to - from;
  Exact power(1);
  for (std::size_t i = 1; i < size; ++i) {
    power = power * width;
    b[i] = b[i] * power;
  }
  // Also by Horner's scheme: the first k coefficients are those of a polynomial of 1 - s and s, times (1 - s) + s.
  for (std::size_t k = 1; k < size; ++k) {
    for (std::size_t i = k; i > 0; --i) b[i] = b[i] + b[i - 1];
  }
  return b;
}

/// What doubles say about the Bernstein coefficients of a polynomial: that all have this sign or that two of them have
/// different ones, in which case the value is 0. Nothing where they are not certain.
///
/// The coefficients c_i and the interval are off by a relative 2^-51 at most. q_j is the sum of C(i, j) c_i from^(i -
/// j) over i >= j, and b_k that of C(k, j) / C(d, j) q_j width^j over j <= k. Beside 4 such errors of 2^-53 for c_i, a
/// term passes through at most 2 d roundings in q_j, 2 d + 1 with its power of the width, 2 d in its ratio of
/// binomials, and d + 2 in the product with it and the sum: 7 d + 7 <= 231 in all where d <= 32. So b_k is off by at
/// most 2^-45 times the sum of the terms' absolute values. The bound has 2^-44. Powers of the width may not underflow;
/// where a product does, it is small beside a sum that is large enough. Nor may anything overflow: no factor but the
/// coefficients is above C(32, 16) < 2^30.
std::optional<int> sign_in_doubles(const Dense& p, const Exact& exact_from, const Exact& exact_to) {
  constexpr std::size_t kMostSize = 33;
  constexpr double kBound = 0x1p-44, kLeast = 0x1p-800, kGreatest = 0x1p800;
  const double from = numbers::to_double(exact_from), to = numbers::to_double(exact_to);
  const std::size_t size = p.size();
  if (size > kMostSize || size == 0 || Exact(from) != exact_from || Exact(to) != exact_to) return std::nullopt;
  double q[kMostSize], sums[kMostSize];  // of the terms and of their absolute values
  for (std::size_t i = 0; i < size; ++i) {
    q[i] = numbers::to_double(p[i]);
    sums[i] = std::fabs(q[i]);
    const bool ordinary = sums[i] == 0 ? p[i].is_zero() : sums[i] >= kLeast && sums[i] <= kGreatest;
    if (!ordinary) return std::nullopt;
  }
  if (from > 0) {
    for (std::size_t i = 0; i + 1 < size; ++i) {
      for (std::size_t j = size - 1; j-- > i;) {
        q[j] += q[j + 1] * from;
        sums[j] += sums[j + 1] * from;
      }
    }
  }
  double power = 1;
  for (std::size_t j = 0; j < size; ++j, power *= to - from) {
    if (power < std::numeric_limits<double>::min() && from != to) return std::nullopt;
    q[j] *= power;
    sums[j] *= power;
  }
  int sign = 0;
  bool certain = true;
  for (std::size_t k = 0; k < size; ++k) {
    double b = 0, sum = 0, ratio = 1;
    for (std::size_t j = 0; j <= k; ++j) {
      b += ratio * q[j];
      sum += ratio * sums[j];
      if (j < k) ratio *= static_cast<double>(k - j) / static_cast<double>(size - 1 - j);
    }
    if (!(sum >= kLeast) || !(std::fabs(b) > kBound * sum)) {
      certain = false;
    } else if (sign == 0) {
      sign = b > 0 ? 1 : -1;
    } else if ((b > 0) != (sign > 0)) {
      return 0;
    }
  }
  return certain ? std::optional(sign) : std::nullopt;
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

Dense operator-(const Dense& p) { return Exact(-1) * p; }

Dense operator*(const Exact& factor, const Dense& p) {
  Dense product = p;
  for (Exact& c : product) c = c * factor;
  return product;
}

Dense operator*(const Dense& p, const Dense& q) {
  if (p.empty() || q.empty()) return {};
  Dense product(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] = product[i + j] + p[i] * q[j];
  }
  return product;
}

Dense scaled_by(const Dense& scale, const Dense& p) {
  return scale.size() == 1 && scale[0] == Exact(1) ? p : scale * p;
}

bool is_zero(const Dense& p) {
  return std::all_of(p.begin(), p.end(), [](const Exact& c) { return numbers::is_zero(c); });
}

Exact value(const Dense& p, const Exact& t) {
  Exact sum;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}

bool divides(const Dense& g, Dense p) {
  while (p.size() >= g.size()) {
    const Exact lead = p.back();
    const std::size_t shift = p.size() - g.size();
    if (!numbers::is_zero(lead)) {
      for (Exact& c : p) c = c * g.back();
      for (std::size_t i = 0; i < g.size(); ++i) p[shift + i] = p[shift + i] - lead * g[i];
    }
    p.pop_back();  // it is zero now
  }
  return is_zero(p);
}

void make_short_integers(std::initializer_list<Dense*> polynomials) {
  std::optional<long> least;  // power of two that divides a coefficient
  for (const Dense* p : polynomials) {
    for (const Exact& c : *p) {
      if (c.is_zero()) continue;
      int limb = 0;
      while (c.limb(limb) == 0) ++limb;
      const long power = 64L * (c.limb_exponent() + limb) + std::countr_zero(c.limb(limb));
      if (!least || power < *least) least = power;
    }
  }
  if (!least || *least == 0) return;
  const Exact factor = numbers::power_of_two(-*least);
  for (Dense* p : polynomials) {
    for (Exact& c : *p) c = c * factor;
  }
}

void remove_common_factor(std::initializer_list<Dense*> polynomials) {
  std::vector<Exact> all;
  for (const Dense* p : polynomials) all.insert(all.end(), p->begin(), p->end());
  all = numbers::without_common_factor(all);
  auto next = all.begin();
  for (Dense* p : polynomials) {
    for (Exact& c : *p) c = std::move(*next++);
  }
}

int sign_over(const Dense& p, const Exact& from, const Exact& to, Inner inner) {
  if (p.empty()) return 0;
  if (const auto sign = sign_in_doubles(p, from, to)) return *sign;
  // The first and the last coefficient are the values at the ends, which most directions that do not separate fail.
  const int first = numbers::sign_of(value(p, from));
  const auto agrees = [&](int sign) { return sign == first || (sign == 0 && inner == Inner::any_zero); };
  if (first == 0 || (p.size() > 1 && !agrees(numbers::sign_of(value(p, to))))) return 0;
  if (p.size() <= 2) return first;
  const Dense b = bernstein(p, from, to);
  return std::all_of(b.begin() + 1, b.end() - 1, [&](const Exact& c) { return agrees(numbers::sign_of(c)); }) ? first
                                                                                                              : 0;
}

bool nowhere_negative(const Dense& p, const Exact& from, const Exact& to) {
  const Dense b = bernstein(p, from, to);
  return std::all_of(b.begin(), b.end(), [](const Exact& c) { return numbers::sign_of(c) >= 0; });
}

}  // namespace touchstone::proofs
