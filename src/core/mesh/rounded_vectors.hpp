// Vectors between positions, as doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <touchstone/query.hpp>

#include "geometry/vector.hpp"

namespace touchstone::mesh {

/// Each component is off by at most 2^-53 of itself, unless it overflows.
inline geometry::Vector<double> from_to(const Vec3& a, const Vec3& b) noexcept {
  return {{b.x - a.x, b.y - a.y, b.z - a.z}};
}

/// About as long as 1, or no number: for vectors that need not be exact.
inline geometry::Vector<double> unit(const geometry::Vector<double>& x) noexcept {
  const double length = std::sqrt(geometry::dot(x, x));
  return {{x[0] / length, x[1] / length, x[2] / length}};
}

}  // namespace touchstone::mesh
