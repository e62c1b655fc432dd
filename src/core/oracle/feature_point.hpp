// Where a point lies on an edge at one moment. The edge may be a point then.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/answer.hpp>

#include "oracle/moment.hpp"
#include "oracle/motion.hpp"

namespace touchstone::oracle {

/// A feature of an element, and the barycentric coordinates of a point on it.
struct FeaturePoint {
  Feature feature;
  std::array<double, 3> weights;
};

/// The names of an edge's features.
struct EdgeNames {
  Feature start;
  Feature end;
  Feature interior;
};

/// Whether two corners are at the same place.
bool coincide(const Moment& at, const Corner& P, const Corner& Q);

/// Whether P is on the closed segment XY, which may be a point.
bool is_on_segment(const Moment& at, const Corner& P, const Corner& X, const Corner& Y);

/// The sign of (Y - X) . (Q - P), for vectors known to be parallel.
CGAL::Sign relative_direction(const Moment& at, const Corner& X, const Corner& Y, const Corner& P, const Corner& Q);

/// The feature of XY that P touches, with P's weights (of X, of Y, 0). P must lie on XY. A corner wins over the
/// interior.
FeaturePoint point_on_edge(const Moment& at, const Corner& P, const Corner& X, const Corner& Y, const EdgeNames& names);

}  // namespace touchstone::oracle
