// The unit of the rounding bounds of a simulation, and the length that compares angles with coordinates.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace touchstone::sim {

/// The distance from 1 to the next double, 2^-52: twice the greatest relative error of one rounding.
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// m: the change or the error of an angle counts as that of a point at this distance from the axis.
constexpr double kLever = 0.01;

}  // namespace touchstone::sim
