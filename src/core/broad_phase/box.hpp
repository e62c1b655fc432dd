// Axis-aligned boxes around elements. Both broad phases work on them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
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

/// The next greater double, as std::nextafter has it, without a call.
inline double next_above(double x) noexcept {
  constexpr auto kInfinity = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  const auto bits = std::bit_cast<std::uint64_t>(x);
  if (bits == kInfinity || (bits << 1) > (kInfinity << 1)) return x;  // NaN, too
  if (bits << 1 == 0) return std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(bits >> 63 != 0 ? bits - 1 : bits + 1);
}
inline double next_below(double x) noexcept { return -next_above(-x); }

/// Moves each side outwards by at least `margin` >= 0. Bounds are then no longer coordinates.
inline void grow(Box& box, double margin) noexcept {
  if (margin == 0) return;
  for (std::size_t k = 0; k < 3; ++k) {
    // A rounded difference is at most one double away from the exact one.
    box.low[k] = next_below(box.low[k] - margin);
    box.high[k] = next_above(box.high[k] + margin);
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
