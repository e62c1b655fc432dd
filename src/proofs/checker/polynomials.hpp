// Polynomials with integer coefficients, for touchstone-check: their signs over an interval, and divisibility.
// SPDX-License-Identifier: MIT
#pragma once

#include "checker/input.hpp"

namespace checker {

/// Coefficient i belongs to t^i. The last ones may be zero; all of them count for the Bernstein coefficients.
using Polynomial = std::vector<mpz_class>;
using Vector = std::array<Polynomial, 3>;

/// Reads the words from `first` on, `step` apart, as the coefficients of a polynomial.
inline std::vector<Number> read_coefficients(const Words& words, std::size_t first, std::size_t step,
                                             const Lines& lines) {
  lines.require(words.size() - first <= step * kMostCoefficients,
                "a polynomial has too many coefficients: at most 33 are read");
  std::vector<Number> numbers;
  numbers.reserve(words.size() / step);
  for (std::size_t i = first; i < words.size(); i += step) read_number(words[i], numbers.emplace_back(), lines);
  return numbers;
}
/// Polynomials with these coefficients, all multiplied by one power of two that makes them integers.
template <std::size_t kCount>
std::array<Polynomial, kCount> polynomials_of(const std::array<std::vector<Number>, kCount>& numbers) {
  long low = std::numeric_limits<long>::max();
  for (const auto& of_one : numbers) {
    for (const Number& x : of_one) low = std::min(low, x.e);
  }
  std::array<Polynomial, kCount> all;
  for (std::size_t p = 0; p < kCount; ++p) {
    all[p].reserve(numbers[p].size());
    for (const Number& x : numbers[p]) all[p].emplace_back(x.m << static_cast<unsigned long>(x.e - low));
  }
  return all;
}
inline Polynomial polynomial_of(const std::vector<Number>& numbers) {
  return polynomials_of(std::array<std::vector<Number>, 1>{numbers})[0];
}

/// sum += factor p
inline void add(Polynomial& sum, const Polynomial& p, const mpz_class& factor) {
  if (sum.size() < p.size()) sum.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) mpz_addmul(sum[i].get_mpz_t(), p[i].get_mpz_t(), factor.get_mpz_t());
}
/// sum += p q
inline void add_product(Polynomial& sum, const Polynomial& p, const Polynomial& q) {
  if (p.empty() || q.empty()) return;
  if (sum.size() < p.size() + q.size() - 1) sum.resize(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      mpz_addmul(sum[i + j].get_mpz_t(), p[i].get_mpz_t(), q[j].get_mpz_t());
    }
  }
}
inline Polynomial product(const Polynomial& p, const Polynomial& q) {
  Polynomial result;
  add_product(result, p, q);
  return result;
}
inline Polynomial difference(Polynomial p, const Polynomial& q) {
  if (p.size() < q.size()) p.resize(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) p[i] -= q[i];
  return p;
}
inline Polynomial dot(const Vector& a, const Vector& b) {
  Polynomial sum;
  for (std::size_t k = 0; k < 3; ++k) add_product(sum, a[k], b[k]);
  return sum;
}

/// The times from low / 2^shift on that are (width / 2^shift) s later, for s in [0, 1].
struct Interval {
  mpz_class low, width;
  unsigned long shift;
  Interval(const Number& from, const Number& to) {
    const long e = std::min({from.e, to.e, 0L});
    low = from.m << static_cast<unsigned long>(from.e - e);
    width = (to.m << static_cast<unsigned long>(to.e - e)) - low;
    shift = static_cast<unsigned long>(-e);
  }
};

/// The Bernstein coefficients b_i of p over the interval, times C(d, i) 2^(shift d), for p with d + 1 coefficients.
/// These factors are positive, so the signs are right. With p(low + s width) = sum c_j s^j and 1 = (1 - s) + s, p is
/// the sum of the c_j s^j ((1 - s) + s)^(d - j). This is a polynomial of s and 1 - s: s^i (1 - s)^(d - i) has the
/// coefficient sum over j <= i of C(d - j, i - j) c_j, which is C(d, i) b_i.
inline Polynomial bernstein(const Polynomial& p, const Interval& on) {
  const std::size_t size = p.size();
  Polynomial b(size);
  for (std::size_t k = 0; k < size; ++k) {  // by Horner's scheme: b times low + width s, and the next coefficient
    for (std::size_t i = k; i > 0; --i) {
      b[i] *= on.low;
      mpz_addmul(b[i].get_mpz_t(), b[i - 1].get_mpz_t(), on.width.get_mpz_t());
    }
    b[0] *= on.low;
    b[0] += p[size - 1 - k] << (on.shift * k);
  }
  // Also by Horner's scheme: the first k coefficients are those of a polynomial of 1 - s and s, times (1 - s) + s.
  for (std::size_t k = 1; k < size; ++k) {
    for (std::size_t i = k; i > 0; --i) b[i] += b[i - 1];
  }
  return b;
}

/// Whether all of the Bernstein coefficients have this sign. From the index `zeros_from` on they may also be zero.
inline bool have_sign(const Polynomial& bernstein, int sign, std::size_t zeros_from) {
  for (std::size_t i = 0; i < bernstein.size(); ++i) {
    const int s = sgn(bernstein[i]);
    if (s != sign && (s != 0 || i < zeros_from)) return false;
  }
  return !bernstein.empty();
}
constexpr std::size_t kNoZeros = std::numeric_limits<std::size_t>::max();

/// Divides the coefficients, which are not all zero, by their greatest common factor.
inline void remove_factor(Polynomial& p) {
  mpz_class factor;
  for (const mpz_class& c : p) factor = gcd(factor, c);
  for (mpz_class& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), factor.get_mpz_t());
}
/// Whether g divides p, over the rational numbers. g has no common factor, and its leading coefficient is not zero. So
/// the quotient has integer coefficients, by Gauss's lemma.
inline bool divides(const Polynomial& g, Polynomial p) {
  for (; p.size() >= g.size(); p.pop_back()) {
    mpz_class& top = p.back();
    if (!mpz_divisible_p(top.get_mpz_t(), g.back().get_mpz_t())) return false;
    mpz_divexact(top.get_mpz_t(), top.get_mpz_t(), g.back().get_mpz_t());
    for (std::size_t i = 0; i + 1 < g.size(); ++i) p[p.size() - g.size() + i] -= top * g[i];
  }
  return std::all_of(p.begin(), p.end(), [](const mpz_class& c) { return c == 0; });
}

}  // namespace checker
