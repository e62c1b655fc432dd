// Axis-aligned boxes around elements. Both broad phases work on them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#include <touchstone/query.hpp>

namespace touchstone::broad_phase {

/// Closed; bounds are coordinates of corners, so nothing is rounded but by `grow`.
struct Box {
  std::array<double, 3> low;
  std::array<double, 3> high;
};

/// A box with nothing in it, for `extend`.
inline Box empty_box() noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

inline void extend(Box& box, const Vec3& corner) noexcept {
  const std::array<double, 3> x{corner.x, corner.y, corner.z};
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], x[k]);
    box.high[k] = std::max(box.high[k], x[k]);
  }
}

/// A bound x < infinity, or bounds side by side, less than x by one double at least: |x| 2^-52 is at least the distance
/// to the next lesser double, and the least double stands for it where that underflows. Rounding does not change an
/// order, so the difference is at most that double. Below the least double it is -infinity. In the default modes:
/// subnormal numbers must not be flushed to zero.
template <class Bound>
Bound lowered(Bound x) noexcept {
  return x - ((x < 0 ? -x : x) * 0x1p-52 + std::numeric_limits<double>::denorm_min());
}

/// Moves each side outwards by at least `margin` >= 0. Bounds are then no longer coordinates.
template <class AnyBox>
void grow(AnyBox& box, double margin) noexcept {
  if (margin == 0) return;
  for (std::size_t k = 0; k < 3; ++k) {
    // A rounded difference is at most one double away from the exact one.
    box.low[k] = lowered(box.low[k] - margin);
    box.high[k] = -lowered(-box.high[k] - margin);
  }
}

inline bool overlap(const Box& a, const Box& b) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) return false;
  }
  return true;
}

/// Called with the indices of two boxes.
using PairConsumer = std::function<void(std::uint32_t, std::uint32_t)>;

}  // namespace touchstone::broad_phase
