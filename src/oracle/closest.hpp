// The closest points of two elements at a moment: their features and weights.
// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/feature_point.hpp"
#include "oracle/sublevel.hpp"

namespace touchstone::oracle {

struct ClosestPair {
  FeaturePoint a;
  FeaturePoint b;
};

/// The closest pair that the answer is to report, at a moment at which the distance is the level: the one with the
/// lexicographically smallest weights. Degenerate elements are reduced first. A zero-length edge is its first corner.
/// A point of a flat triangle is a point of the first feature that holds it.
///
/// With `names_overlap`, edges with several closest pairs have the feature `overlap`.
ClosestPair closest_pair(const DifferencePolygon& polygon, const Sublevel& sublevel, const Moment& at,
                         bool names_overlap);

}  // namespace touchstone::oracle
