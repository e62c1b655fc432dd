// Axis-aligned boxes around elements, the common currency of the broad phases.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include <touchstone/query.hpp>

namespace touchstone::broad_phase {

/// Closed; bounds are coordinates of corners, so nothing is rounded.
struct Box {
  std::array<double, 3> low;
  std::array<double, 3> high;
};

/// A box with nothing in it, for `extend`.
Box empty_box() noexcept;
void extend(Box& box, const Vec3& corner) noexcept;
bool overlap(const Box& a, const Box& b) noexcept;

/// Takes the numbers of two boxes.
using PairConsumer = std::function<void(std::uint32_t, std::uint32_t)>;

}  // namespace touchstone::broad_phase
