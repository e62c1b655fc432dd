// Where a point lies on an edge at one moment: by location alone, whatever the edge's shape then.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/answer.hpp>

#include "oracle/moment.hpp"
#include "oracle/motion.hpp"

namespace touchstone::oracle {

/// A part of an element with a point's barycentric coordinates on it.
struct Place {
  Feature feature;
  std::array<double, 3> weights;
};

/// What the parts of an edge are called.
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

/// The place of P on XY, where it must lie: a corner when it is at a corner. Weights are (of X, of Y, 0).
Place place_on_edge(const Moment& at, const Corner& P, const Corner& X, const Corner& Y, const EdgeNames& names);

}  // namespace touchstone::oracle
