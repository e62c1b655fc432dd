// The unit of the rounding bounds of a simulation.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace touchstone::sim {

/// The distance from 1 to the next double, 2^-52: twice the greatest relative error of one rounding.
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace touchstone::sim
