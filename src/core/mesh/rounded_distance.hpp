// The distance of two elements at rest, rounded up.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <touchstone/distance.hpp>

namespace touchstone::mesh {

/// The least double that the elements of a query come within at the start; infinity without one.
template <class AnyQuery>
double distance_rounded_up(const AnyQuery& query, Metric metric) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double nearest = touchstone::distance(query, 0, metric).value;
  const bool is_within = nearest == kInfinity || compare_distance(query, 0, {nearest, metric}) <= 0;
  return is_within ? nearest : std::nextafter(nearest, kInfinity);
}

}  // namespace touchstone::mesh
