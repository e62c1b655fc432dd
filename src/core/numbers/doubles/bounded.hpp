// Doubles and double-doubles that carry a bound on their error along: what is computed with them needs no bound of its
// own (running error analysis: Higham, "Accuracy and stability of numerical algorithms", section 3.3).
//
// Nothing here needs a limit of sizes. What overflows becomes infinite or NaN, and so does its error, or no comparison
// with it holds: its sign is uncertain.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/doubles/double_double.hpp"

namespace touchstone::numbers {

/// e: a rounded sum or product is within e times its own absolute value of the true one, where nothing underflows.
constexpr double kRounding = 0x1p-53;

/// The bounds are themselves sums and products of numbers that are not negative. Each of their roundings takes at most
/// a relative e off. No bound has more than 2^12 operations in a row behind it, so that it is at most a relative 2^-41
/// too small. Sizes that enter bounds are off by some e, too. This factor makes up for all of that.
constexpr double kBoundSlack = 1 + 0x1p-40;

/// A number: the true one is within kBoundSlack error of value.
struct Bounded {
  double value = 0;
  double error = 0;

  /// 0 when uncertain.
  int sign() const noexcept { return value > kBoundSlack * error ? 1 : value < -(kBoundSlack * error) ? -1 : 0; }
};

/// More than what is lost where a product underflows, or a product inside of a bound: some 2^-1074.
constexpr double kUnderflow = 0x1p-1000;

inline Bounded operator-(const Bounded& a) noexcept { return {-a.value, a.error}; }
inline Bounded operator+(const Bounded& a, const Bounded& b) noexcept {
  const double value = a.value + b.value;
  return {value, (a.error + b.error) + kRounding * std::fabs(value)};
}
inline Bounded operator-(const Bounded& a, const Bounded& b) noexcept { return a + -b; }
inline Bounded operator*(const Bounded& a, const Bounded& b) noexcept {
  // With a = A + x and b = B + y: a b - A B = A y + x B + x y.
  const double value = a.value * b.value;
  return {value, std::fabs(a.value) * b.error + a.error * (std::fabs(b.value) + b.error) +
                     (kRounding * std::fabs(value) + kUnderflow)};
}
/// Where b may be 0, the error is infinite: its true value is within kBoundSlack times its error, which is less than 2.
inline Bounded operator/(const Bounded& a, const Bounded& b) noexcept {
  // With a = A + x and b = B + y: a / b - A / B = (x - (a / b) y) / B, and |B| is at least |b| - |y|.
  const double value = a.value / b.value;
  const double least = std::fabs(b.value) - 2 * b.error;
  const double error =
      (a.error + std::fabs(value) * b.error + kUnderflow) / least + (kRounding * std::fabs(value) + kUnderflow);
  return {value, least > 0 ? error : std::numeric_limits<double>::infinity()};
}

/// The same for double-doubles, whose low part is at most e times the high part. In a sum, the high parts add up
/// exactly. The sum of the low parts rounds, and so does what is added to it: with A and B the high parts, by at most
/// e^2 (|A| + |B|) and 2 e^2 (|A| + |B|).
constexpr double kPairSum = 4 * kRounding * kRounding;
/// In a product, the product of the high parts is exact. Two products of a high and a low part round, each by at most
/// e^2 |A B|; so do their sum, by 2 e^2 |A B|, and what is added to it, by 3 e^2 |A B|. The product of the low parts is
/// left out: e^2 |A B|. That is 8 e^2 |A B|; the rest is for the rounding of A B.
constexpr double kPairProduct = 9 * kRounding * kRounding;
/// two_product is exact for products of at least 2^-969. The parts of lesser ones are below 2^-960.
constexpr double kPairUnderflow = 0x1p-900;

struct BoundedPair {
  DoubleDouble value = {0, 0};
  double error = 0;

  int sign() const noexcept { return Bounded{value.high, error}.sign(); }
};

inline BoundedPair exact_pair(double x) noexcept { return {{x, 0}, 0}; }
inline BoundedPair operator-(const BoundedPair& a) noexcept { return {{-a.value.high, -a.value.low}, a.error}; }
inline BoundedPair operator+(const BoundedPair& a, const BoundedPair& b) noexcept {
  return {normalised(a.value + b.value),
          (a.error + b.error) + (kPairSum * (std::fabs(a.value.high) + std::fabs(b.value.high)))};
}
inline BoundedPair operator-(const BoundedPair& a, const BoundedPair& b) noexcept { return a + -b; }
inline BoundedPair operator*(const BoundedPair& a, const BoundedPair& b) noexcept {
  const DoubleDouble value = normalised(a.value * b.value);
  const double a_size = std::fabs(a.value.high), b_size = std::fabs(b.value.high);
  return {value,
          a_size * b.error + a.error * (b_size + b.error) + (kPairProduct * std::fabs(value.high) + kPairUnderflow)};
}

/// Its high part.
inline Bounded rounded(const BoundedPair& x) noexcept { return {x.value.high, std::fabs(x.value.low) + x.error}; }

/// a / b in [0, 1], b > 0, within 2^-51; NaN where that is not certain.
inline double quotient(const BoundedPair& a, const BoundedPair& b) noexcept {
  // a / b is off by at most (x + y) / (B - y), for a and b off by x and y, and a / b in [0, 1]. The rest is for 2
  // roundings.
  constexpr double kMostError = 0x1p-52;
  if (!(a.error + b.error <= kMostError * b.value.high)) return std::numeric_limits<double>::quiet_NaN();
  const double first = a.value.high / b.value.high;
  const BoundedPair rest = a - exact_pair(first) * b;
  return std::clamp(first + rest.value.high / b.value.high, 0.0, 1.0);
}

}  // namespace touchstone::numbers
