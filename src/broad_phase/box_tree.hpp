// The pairs of moving boxes that overlap at some time: a tree of boxes. The time is nearly linear in the number of
// boxes, even if every box moves so fast that it passes over the places of many others.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "broad_phase/box.hpp"

namespace touchstone::broad_phase {

/// A box whose bounds move evenly from those at t = 0 to those at t = 1. A corner that is in the box at both ends, and
/// moves on a straight line, is in the box at all times.
struct MovingBox {
  Box start, end;
};

/// A box with nothing in it, for `join`.
MovingBox empty_moving_box() noexcept;

/// Extends `box` so that it contains the other box at all times.
void join(MovingBox& box, const MovingBox& other) noexcept;

/// False proves that the boxes are disjoint at all times in [0, 1].
bool meet(const MovingBox& a, const MovingBox& b) noexcept;

/// Calls found(i, j) once for each i < j whose boxes meet, and for no other pair. The order of the calls depends on the
/// boxes only.
void for_each_pair(const std::vector<MovingBox>& boxes, const PairConsumer& found);

/// The same for box i of `a` and box j of `b`.
void for_each_pair(const std::vector<MovingBox>& a, const std::vector<MovingBox>& b, const PairConsumer& found);

}  // namespace touchstone::broad_phase
