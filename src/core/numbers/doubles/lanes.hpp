// What a text that is written once, for doubles and for packs of them, needs beyond arithmetic and comparisons.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace touchstone::numbers {

/// Masks are the results of comparisons: a bool, or one for each lane. `&` and `|` join them, and `mask == 0` negates.
template <class N>
struct Lanes;

template <>
struct Lanes<double> {
  using Mask = bool;
  static constexpr double all(double x) noexcept { return x; }  ///< x in every lane
  static constexpr bool every() noexcept { return true; }       ///< a mask
  static constexpr bool any(bool mask) noexcept { return mask; }

  using Axis = std::size_t;  ///< 0, 1 or 2
  /// The axis of the greatest of three sizes.
  static constexpr Axis greatest(double x, double y, double z) noexcept {
    const Axis k = x > y ? 0 : 1;
    return z > (k == 0 ? x : y) ? 2 : k;
  }
  /// A vector with its coordinates in the order axis, axis + 1, axis + 2.
  template <class Vector>
  static constexpr Vector turned(const Vector& a, Axis axis) noexcept {
    return {{a[axis], a[(axis + 1) % 3], a[(axis + 2) % 3]}};
  }
};

}  // namespace touchstone::numbers
