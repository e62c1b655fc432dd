// The closest points of two elements at one time, in exact arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "view/moving_corners.hpp"

namespace touchstone::view {

/// Points of the two elements, as weights of the corners. Those of each element are not negative, and their sum is 1.
struct ClosestPoints {
  std::array<Exact, 4> weights;
  Exact squared_distance;  ///< times the square of the denominator at this time
};

/// Exact points of the elements whose distance is the elements' distance within a relative 2^-200 of their size.
ClosestPoints closest_points(const MovingCorners& corners, const Exact& t);

/// The time in [0, t_max] at which the elements come closest, about: 0, t_max, a root of V or a time that is found by a
/// search with exact distances. The search may miss a short approach that is no root of V.
Exact closest_approach(const MovingCorners& corners, double t_max);

}  // namespace touchstone::view
