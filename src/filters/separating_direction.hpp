// A plane, moving evenly, that keeps two elements apart during the whole step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>

#include "geometry/vector.hpp"

namespace touchstone::filters {

using Vector = geometry::Vector<double>;

/// The corners of both elements at both ends of the step, relative to one of them: each coordinate is one rounded
/// subtraction of two of the query's doubles. Corners 0 .. first_count - 1 are the first element's.
struct RelativeCorners {
  std::array<Vector, 4> start;
  std::array<Vector, 4> end;
  std::size_t count;
  std::size_t first_count;
  double largest;  ///< the largest absolute coordinate
};
RelativeCorners relative_corners(const Query& query) noexcept;

/// A bound on the error of each computed projection d . (x - origin) that is finite; NaN when it may underflow.
double projection_bound(const RelativeCorners& corners, const Vector& direction) noexcept;

/// How far the two elements are apart along a direction at every time of the step, one of them always being above the
/// other: computed, off by at most `error`. NaN where a projection is not finite, or may underflow. Not positive: they may
/// touch.
struct Gap {
  double value;
  double error;
};
Gap gap_along(const RelativeCorners& corners, const Vector& direction) noexcept;

/// True proves that d . x is smaller for one element than for the other at all times in [0, 1]: no contact. Any
/// direction is sound, finite or not.
bool separates(const RelativeCorners& corners, const Vector& direction) noexcept;

/// True proves that the boxes around the two elements' paths are disjoint. Comparisons of the query's own doubles:
/// no rounding.
bool boxes_disjoint(const Query& query) noexcept;

/// Directions that often separate, from the positions at mid-step; only promising, never trusted.
Vector between_closest_points(const RelativeCorners& corners, Kind kind) noexcept;
Vector normal_at_mid_step(const RelativeCorners& corners, Kind kind) noexcept;
Vector between_centres(const RelativeCorners& corners) noexcept;

}  // namespace touchstone::filters
