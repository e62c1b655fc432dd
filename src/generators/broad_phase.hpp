// Which boxes overlap: a uniform grid, near-linear in the number of boxes when they are of similar size.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <touchstone/query.hpp>

namespace touchstone::generators {

/// Closed; bounds are coordinates of corners, so nothing is rounded.
struct Box {
  std::array<double, 3> low;
  std::array<double, 3> high;
};

/// A box with nothing in it, for `extend`.
Box empty_box() noexcept;
void extend(Box& box, const Vec3& corner) noexcept;
bool overlap(const Box& a, const Box& b) noexcept;

using PairConsumer = std::function<void(std::uint32_t, std::uint32_t)>;

/// Calls found(i, j) once for each i < j whose boxes overlap, and for no other pair; in an order that depends on the
/// boxes only.
void for_each_overlap(const std::vector<Box>& boxes, const PairConsumer& found);

/// The same for box i of `a` and box j of `b`.
void for_each_overlap(const std::vector<Box>& a, const std::vector<Box>& b, const PairConsumer& found);

}  // namespace touchstone::generators
