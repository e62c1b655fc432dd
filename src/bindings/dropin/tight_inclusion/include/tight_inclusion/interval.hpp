// Touchstone's drop-in for Tight-Inclusion: dyadic numbers and intervals between them. The drop-in does not need them
// to answer; they are here for programs that use them.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <utility>

#include <tight_inclusion/config.hpp>
#include <tight_inclusion/types.hpp>

namespace ticcd {

/// a 2^b.
/// @throws touchstone::InvalidQuery  when that is 2^64 or more
std::uint64_t power(const std::uint64_t a, const std::uint8_t b);

/// 2^exponent.
/// @throws touchstone::InvalidQuery  when exponent > 63
inline std::uint64_t pow2(const std::uint8_t exponent) { return power(1, exponent); }

/// Splits n into result 2^t with an odd result, and returns t. For n = 0 the result and t are 0.
std::uint8_t reduction(const std::uint64_t n, std::uint64_t& result);

/// The number numerator / 2^denom_power. Two of them are compared by their values, exactly.
struct NumCCD {
  std::uint64_t numerator;   ///< not negative
  std::uint8_t denom_power;  ///< the denominator is two to this power

  /// A number without a value: set both members before use.
  NumCCD() {}

  /// p_numerator / 2^p_denom_power.
  NumCCD(std::uint64_t p_numerator, std::uint8_t p_denom_power) : numerator(p_numerator), denom_power(p_denom_power) {}

  /// The least multiple of 2^-62 that is not less than x, in lowest terms.
  /// @param x  0 <= x <= 1
  /// @throws touchstone::InvalidQuery  for another x
  NumCCD(Scalar x);

  ~NumCCD() {}

  /// 2^denom_power.
  /// @throws touchstone::InvalidQuery  when denom_power > 63
  std::uint64_t denominator() const { return pow2(denom_power); }

  /// The number, rounded to the nearest double where it is none.
  Scalar value() const;

  /// The same as value().
  operator double() const { return value(); }

  /// The sum, in lowest terms.
  /// @throws touchstone::InvalidQuery  when its numerator is 2^64 or more
  NumCCD operator+(const NumCCD& other) const;

  bool operator==(const NumCCD& other) const { return !(*this < other) && !(other < *this); }  ///< equal values
  bool operator!=(const NumCCD& other) const { return !(*this == other); }                     ///< other values
  bool operator<(const NumCCD& other) const;                                                   ///< less
  bool operator<=(const NumCCD& other) const { return !(other < *this); }                      ///< less or equal
  bool operator>=(const NumCCD& other) const { return !(*this < other); }                      ///< greater or equal
  bool operator>(const NumCCD& other) const { return other < *this; }                          ///< greater

  bool operator<(const Scalar other) const { return value() < other; }    ///< value() is less
  bool operator>(const Scalar other) const { return value() > other; }    ///< value() is greater
  bool operator==(const Scalar other) const { return value() == other; }  ///< value() is equal

  /// Whether num1 + num2 <= 1.
  /// @throws touchstone::InvalidQuery  when the denominators of both, in lowest terms, are 2^64 or more
  static bool is_sum_leq_1(const NumCCD& num1, const NumCCD& num2);
};

/// The interval from `lower` to `upper`, both ends included.
struct Interval {
  NumCCD lower;  ///< the lower end
  NumCCD upper;  ///< the upper end

  /// An interval without ends: set both before use.
  Interval() {}

  /// From p_lower to p_upper.
  Interval(const NumCCD& p_lower, const NumCCD& p_upper) : lower(p_lower), upper(p_upper) {}

  ~Interval() {}

  /// The lower and the upper half. They share the point in the middle.
  /// @throws touchstone::InvalidQuery  when that point has no NumCCD
  std::pair<Interval, Interval> bisect() const;

  /// Whether it shares a point with [r1, r2].
  bool overlaps(const Scalar r1, const Scalar r2) const;
};

/// A box of parameters: the time t, and the parameters u and v of a point on each element.
typedef std::array<Interval, 3> Interval3;

/// The width of the box along each parameter.
Array3 width(const Interval3& x);

}  // namespace ticcd
