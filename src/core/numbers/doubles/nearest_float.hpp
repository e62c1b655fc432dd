// The float nearest to a double.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::numbers {

/// The float nearest to x, as a double. The volatile number keeps the two conversions apart: where GCC 12 vectorises a
/// straight piece of code with both (-O3), it may drop them.
inline double nearest_float(double x) noexcept {
  const volatile auto rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

}  // namespace touchstone::numbers
