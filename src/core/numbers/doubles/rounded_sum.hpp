// Sums with a known direction of rounding.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "numbers/doubles/double_double.hpp"

namespace touchstone::numbers {

/// The least double that is not below a + b. a and b are finite, and their sum does not overflow.
inline double sum_rounded_up(double a, double b) noexcept {
  const DoubleDouble exact = two_sum(a, b);
  return exact.low > 0 ? std::nextafter(exact.high, std::numeric_limits<double>::infinity()) : exact.high;
}

}  // namespace touchstone::numbers
