// Rational roots of polynomials with coefficients of few bits. Degenerate input mostly touches at such times: a
// fraction of small integers costs less to find than a bracket, and all signs there are exact at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "numbers/integers/small_int.hpp"
#include "numbers/roots/polynomial.hpp"

namespace touchstone::numbers {

/// n / d in lowest terms with 0 <= n <= d.
struct SmallFraction {
  std::int64_t n, d;
};

/// Whether all |c| < 2^38. Only then this file speaks of a cubic.
inline bool has_few_bits(const Polynomial<SmallInt, 3>& p) noexcept {
  constexpr std::int64_t kLimit = std::int64_t{1} << 38;
  for (const SmallInt c : p.c) {
    if (c.value() <= -kLimit || c.value() >= kLimit) return false;
  }
  return true;
}

/// p / (d t - n), where that divides a polynomial of degree 1 to 3. By Gauss's lemma the quotient a has integer
/// coefficients then: d a2 = p3, d a1 = p2 + n a2, d a0 = p1 + n a1 and 0 = p0 + n a0. With n <= d each sum below is at
/// most the sum of the |c| up to it, so that there is room.
inline std::optional<Polynomial<SmallInt, 3>> divided(const Polynomial<SmallInt, 3>& p,
                                                      const SmallFraction& root) noexcept {
  Polynomial<SmallInt, 3> quotient = {};
  std::int64_t carried = 0;
  for (int i = 3; i > 0; --i) {
    const std::int64_t sum = p[i].value() + root.n * carried;
    carried = sum / root.d;
    if (carried * root.d != sum) return std::nullopt;
    quotient[i - 1] = SmallInt::integer(carried);
  }
  if (p[0].value() + root.n * carried != 0) return std::nullopt;
  return quotient;
}

/// The square root of an integer that is a square below 2^90. In doubles it is off by less than 2^-51 of itself, below
/// 2^-6, and so rounds to it.
inline std::optional<std::int64_t> exact_root(const FixedInt<2>& square) noexcept {
  constexpr double kGreatest = 0x1p90;
  const double size = to_double(square);
  if (!(size >= 0 && size < kGreatest)) return std::nullopt;
  const auto root = FixedInt<1>::integer(static_cast<std::int64_t>(std::nearbyint(std::sqrt(size))));
  if (!(root * root - square).is_zero()) return std::nullopt;
  return static_cast<std::int64_t>(root.limb(0));
}

/// The rational root of a cubic of few bits in (0, 1) that is near t, if there is one: its denominator divides p3, so
/// that p3 times the root is an integer.
inline std::optional<SmallFraction> rational_root_near(const Polynomial<SmallInt, 3>& p, double t) noexcept {
  constexpr double kNear = 0x1p-10;
  const std::int64_t leading = std::abs(p[3].value());
  const double numerator = t * static_cast<double>(leading), nearest = std::nearbyint(numerator);
  if (!(std::fabs(numerator - nearest) < kNear && nearest > 0 && nearest < static_cast<double>(leading))) {
    return std::nullopt;
  }
  const auto n = static_cast<std::int64_t>(nearest);
  const std::int64_t divisor = std::gcd(n, leading);
  return SmallFraction{n / divisor, leading / divisor};
}

}  // namespace touchstone::numbers
