// The exact ring that decisions are made in, and conversions to doubles and text.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "numbers/integers/dyadic.hpp"

namespace touchstone::numbers {

using Exact = Dyadic;

inline int sign_of(const Exact& x) { return x.sign(); }
inline bool is_zero(const Exact& x) { return x.is_zero(); }

/// 2^exponent for any exponent.
inline Exact power_of_two(long exponent) { return Exact::power_of_two(exponent); }

/// x as significand * 2^exponent with 0.5 <= |significand| <= 1 (0 and 0 for zero), for x of any magnitude. The
/// significand's relative error is at most 2^-52.
struct Approximation {
  double significand;
  long exponent;
};
Approximation approximate(const Exact& x);

/// The double near x within a relative error of 2^-52; overflows to infinity and underflows as ldexp does.
double to_double(const Exact& x);

/// The double near numerator / denominator within a relative error of 2^-50, for operands of any magnitude; the
/// denominator is not zero. Overflows to infinity and underflows to zero as ldexp does.
double approximate_quotient(const Exact& numerator, const Exact& denominator);

/// For a person: "0", "-3", "5 * 2^-54".
std::string to_string(const Exact& x);

/// For a person, in lowest terms: "1/3", "2". The denominator is not zero.
std::string quotient_to_string(const Exact& numerator, const Exact& denominator);

}  // namespace touchstone::numbers
