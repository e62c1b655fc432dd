// What the files on sparse roots share: values of polynomials with sparse coefficients, from as many of their digits as
// it takes, and doubles of any exponent.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "numbers/exact_number.hpp"
#include "numbers/sparse.hpp"

namespace touchstone::numbers {

/// x 2^exponent as a sparse number.
inline Sparse sparse(double x, long exponent = 0) noexcept { return Sparse::scaled(x, -exponent); }
inline Sparse sparse(const Approximation& x) noexcept { return sparse(x.significand, x.exponent); }

// Doubles of any exponent, for hints only.
inline Approximation normalised(double x, long exponent) noexcept {
  int more = 0;
  const double significand = std::frexp(x, &more);
  return {significand, x == 0 ? 0 : exponent + more};
}
inline Approximation operator*(const Approximation& a, const Approximation& b) noexcept {
  return normalised(a.significand * b.significand, a.exponent + b.exponent);
}
inline Approximation operator/(const Approximation& a, const Approximation& b) noexcept {
  return normalised(a.significand / b.significand, a.exponent - b.exponent);
}
inline Approximation operator-(const Approximation& a) noexcept { return {-a.significand, a.exponent}; }
/// x 2^exponent as a double, for exponents of any size.
inline double scaled(const Approximation& x, long exponent) noexcept {
  constexpr long kMost = 4000;
  return std::ldexp(x.significand, static_cast<int>(std::clamp(x.exponent + exponent, -kMost, kMost)));
}
inline Approximation operator+(const Approximation& a, const Approximation& b) noexcept {
  if (a.significand == 0) return b;
  if (b.significand == 0) return a;
  const long exponent = std::max(a.exponent, b.exponent);
  return normalised(scaled(a, -exponent) + scaled(b, -exponent), exponent);
}
inline Approximation root_of(const Approximation& x) noexcept {
  const bool odd = x.exponent % 2 != 0;
  return normalised(std::sqrt(odd ? 2 * x.significand : x.significand), (odd ? x.exponent - 1 : x.exponent) / 2);
}

/// The value at x / divisor times divisor^(size - 1), in numbers of type N.
template <class N>
N value_at(const Sparse* c, int size, const Sparse& x, const Sparse& divisor) noexcept {
  const N at(x);
  N value(c[size - 1]), power(divisor);
  for (int i = size - 2; i >= 0; --i) {
    value = multiply_add(value, at, divisor.is_one() ? N(c[i]) : N(c[i]) * power);
    if (i > 0 && !divisor.is_one()) power = power * N(divisor);
  }
  return value;
}

/// The coefficients of a polynomial in x - base, for numerators x over the divisor.
template <class N>
std::array<N, 4> shifted(const Sparse* p, int size, const Sparse& base, const Sparse& divisor) noexcept {
  std::array<N, 4> c;
  for (int i = 0; i < size; ++i) c[static_cast<std::size_t>(i)] = N(p[i]);
  if (!divisor.is_one()) {
    N power(divisor);
    for (int i = size - 2; i >= 0; --i) {
      c[static_cast<std::size_t>(i)] = c[static_cast<std::size_t>(i)] * power;
      power = power * N(divisor);
    }
  }
  if (base.is_zero()) return c;
  const N by(base);
  for (int k = 0; k < size - 1; ++k) {
    for (int i = size - 2; i >= k; --i) {
      const auto at = static_cast<std::size_t>(i);
      c[at] = base.is_one() ? c[at] + c[at + 1] : multiply_add(c[at + 1], by, c[at]);
    }
  }
  return c;
}

/// The fraction n / d of small numbers that is close to x, in (0, 1], if there is one.
struct CloseFraction {
  double numerator, denominator;
};
inline std::optional<CloseFraction> small_fraction(double x) noexcept {
  constexpr double kClose = 0x1p-40, kGreatest = 1024;
  double rest = x, n0 = 0, d0 = 1, n1 = 1, d1 = 0;
  for (;;) {
    const double whole = std::floor(rest);
    const double n = whole * n1 + n0, d = whole * d1 + d0;
    if (!(d <= kGreatest)) return std::nullopt;
    if (std::fabs(n - x * d) <= kClose * d) return CloseFraction{n, d};
    n0 = n1, d0 = d1, n1 = n, d1 = d;
    rest = 1 / (rest - whole);
  }
}

// Leading digits decide most signs, and the numbers themselves the others.
using Few = Leading<6>;
using More = Leading<16>;

template <class N>
bool all_certain(const N& numbers) noexcept {
  return std::all_of(numbers.begin(), numbers.end(), [](const auto& x) { return x.sign() != 0; });
}

/// What compute(N), an array, gives for N = Few, More or Sparse, whichever is the first to know the signs of all.
template <class Compute>
auto first_certain(const Compute& compute) noexcept {
  const auto exactly = [&] { return compute(Sparse()); };
  decltype(exactly()) values;
  const auto take = [&](const auto& numbers) {
    std::transform(numbers.begin(), numbers.end(), values.begin(), [](const auto& x) { return x.value; });
    return values;
  };
  if (const auto few = compute(Few()); all_certain(few)) return take(few);
  if (const auto more = compute(More()); all_certain(more)) return take(more);
  return exactly();
}
template <class Compute>
int sign_of_any(const Compute& compute) noexcept {
  const SparseScratch::Rewind rewind;
  return first_certain([&](auto n) { return std::array{compute(n)}; })[0].sign();
}
inline int sign_of_value(const Sparse* c, int size, const Sparse& x, const Sparse& divisor) noexcept {
  return sign_of_any([&](auto n) { return value_at<decltype(n)>(c, size, x, divisor); });
}

/// The signs at low and at high, over the divisor, of a linear polynomial whose two coefficients `linear` computes in
/// numbers of some type.
template <class Linear>
std::array<int, 2> signs_of_linear(const Linear& linear, const Sparse& low, const Sparse& high,
                                   const Sparse& divisor) noexcept {
  const SparseScratch::Rewind rewind;
  const auto at_ends = first_certain([&](auto n) {
    using N = decltype(n);
    const auto c = linear(n);
    const N constant = c[0] * N(divisor);
    return std::array<N, 2>{multiply_add(c[1], N(low), constant), multiply_add(c[1], N(high), constant)};
  });
  return {at_ends[0].sign(), at_ends[1].sign()};
}

inline int actual_size(const Sparse* q, int size) noexcept {
  while (size > 0 && q[size - 1].is_zero()) --size;
  return size;
}

}  // namespace touchstone::numbers
