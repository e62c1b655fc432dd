// The derivatives of a time by the corners of a query at both ends of the step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/query.hpp>

namespace touchstone::geometry {

/// By the corners at t = 0, and by those at t = 1.
using EndGradients = std::array<std::array<Vec3, 4>, 2>;

}  // namespace touchstone::geometry
