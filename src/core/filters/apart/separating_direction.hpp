// A plane that moves evenly and keeps two elements apart during the whole step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "filters/step_frame.hpp"

namespace touchstone::filters {

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

/// The least distance along a direction between the two elements over the step, where one is above the other all along;
/// negative or zero where they may touch. The true distance is at most `error` away. NaN where a projection is not
/// finite, or may underflow.
struct Gap {
  double value;
  double error;
};
Gap gap_along(const RelativeCorners& corners, const Vector& direction) noexcept;

/// True proves that d . x is smaller for one element than for the other at all times in [0, 1]: no contact. Any
/// direction is sound, finite or not.
bool separates(const RelativeCorners& corners, const Vector& direction) noexcept;

/// True proves that the distance of the elements is greater than the separation at all times in [0, 1].
bool separates_by(const RelativeCorners& corners, const Vector& direction, const Separation& separation) noexcept;

/// Whether the direction between the closest points at mid-step separates the elements of a valid query.
bool separated(const Query& query) noexcept;

/// Directions that often separate, from the positions at mid-step. They are only a hint: any direction is sound.
Vector between_closest_points(const RelativeCorners& corners, Kind kind) noexcept;
Vector normal_at_mid_step(const RelativeCorners& corners, Kind kind) noexcept;
Vector between_centres(const RelativeCorners& corners) noexcept;

}  // namespace touchstone::filters
