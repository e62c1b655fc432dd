// The linking number of two closed polygons, counted in exact integers. It uses no code of the simulator.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rods/system.hpp"

namespace touchstone::sim {

/// A closed polygon: its particles, in order.
using Loop = std::vector<Index>;

/// The number of signed crossings of one over the other in a projection. It is the same integer for any projection.
/// The positions are exact doubles. Fails the test when two corners and an edge fall on one line of sight.
int linking_number(const VectorX& q, const Loop& a, const Loop& b);

/// Gauss's integral over both polygons, in doubles: the same number except for rounding. For a polygon with itself it
/// is the writhe, to which neighbouring edges contribute nothing.
double gauss_integral(const VectorX& q, const Loop& a, const Loop& b);

}  // namespace touchstone::sim
