// Where corners on curves can be at all during a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>

#include "geometry/vector.hpp"

namespace touchstone::filters {

/// Points that have all positions of the corners in their convex hull, corner by corner: the control points of a Bezier
/// curve, rational for a body that turns. Positions are those relative to an origin that moves with one of the
/// elements, at from + t (to - from): a plane that separates them moves with it.
struct CurvedPaths {
  struct Path {
    std::array<geometry::Vector<double>, 4> points;
    std::size_t count = 0;
  };
  bool known = false;  ///< false where nothing is known: the other members then mean nothing
  Vec3 from, to;       ///< the origin at t = 0 and t = 1
  std::array<Path, 4> corners;
  double size = 0;   ///< no coordinate here, of a body point, a control point or a position is larger
  double error = 0;  ///< no coordinate here is farther than this from the true one
};

/// @param query  valid
CurvedPaths curved_paths(const CurvedQuery& query) noexcept;

/// Whether some direction certainly separates the two elements all over the step.
bool certainly_apart(const CurvedQuery& query) noexcept;

/// Whether some direction shows that they are farther than a separation from each other all over the step.
bool certainly_farther(const CurvedQuery& query, const Separation& separation) noexcept;

}  // namespace touchstone::filters
