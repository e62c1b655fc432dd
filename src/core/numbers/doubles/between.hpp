// Doubles between two others.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace touchstone::numbers {

/// x0 + length (x1 - x0), within the error that FreeStep::positions states in touchstone/mesh.hpp, and between x0 and x1; exactly x1 for the
/// length 1.
inline double between(double x0, double x1, double length) noexcept {
  if (x0 == x1 || length == 1) return x1;
  const double difference = x1 - x0;
  if (!std::isfinite(difference)) return 2 * between(x0 / 2, x1 / 2, length);
  // The errors of the difference, of the product and of the sum are known, and are added to the sum: so it is rounded
  // once, but for terms of second order.
  const double x0_virtual = x1 - difference;
  const double difference_error = (x0_virtual - x0) + (x1 - (difference + x0_virtual));
  const double product = length * difference;
  const double product_error = std::fma(length, difference, -product) + length * difference_error;
  const double sum = x0 + product;
  const double product_virtual = sum - x0;
  const double sum_error = (x0 - (sum - product_virtual)) + (product - product_virtual);
  const double at = sum + (sum_error + product_error);
  return std::clamp(at, std::min(x0, x1), std::max(x0, x1));
}

}  // namespace touchstone::numbers
