// Axis-aligned boxes around elements. Both broad phases work on them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include <touchstone/query.hpp>

namespace touchstone::broad_phase {

/// Closed; bounds are coordinates of corners, so nothing is rounded but by `grow`.
struct Box {
  std::array<double, 3> low;
  std::array<double, 3> high;
};

/// A box with nothing in it, for `extend`.
Box empty_box() noexcept;
void extend(Box& box, const Vec3& corner) noexcept;

/// Moves each side outwards by at least `margin` >= 0. Bounds are then no longer coordinates.
void grow(Box& box, double margin) noexcept;
bool overlap(const Box& a, const Box& b) noexcept;

/// Called with the indices of two boxes.
using PairConsumer = std::function<void(std::uint32_t, std::uint32_t)>;

}  // namespace touchstone::broad_phase
