// Where corners on curves can be at all during a step. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>

#include "geometry/vector.hpp"

namespace touchstone::filters {

/// Points that have all positions of the corners in their convex hull, corner by corner: the control points of a Bezier
/// curve, rational for a body that turns.
struct CurvedPaths {
  struct Path {
    std::array<geometry::Vector<double>, 4> points;
    std::size_t count = 0;
  };
  bool known = false;  ///< false where nothing is known: the other members then mean nothing
  std::array<Path, 4> corners;
  double size = 0;   ///< no coordinate here, of a body point or of a position is larger
  double error = 0;  ///< no coordinate here is farther than this from the true one
};

/// @param query  valid
CurvedPaths curved_paths(const CurvedQuery& query) noexcept;

/// Whether some direction certainly separates the two elements all over the step.
bool certainly_apart(const CurvedQuery& query) noexcept;

/// Whether some direction shows that they are farther than a separation from each other all over the step.
bool certainly_farther(const CurvedQuery& query, const Separation& separation) noexcept;

}  // namespace touchstone::filters
