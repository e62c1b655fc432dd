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
/// Of a flat triangle, the first feature that holds closest points counts, in the order f0, f1, f2, f01, f12, f20.
///
/// With `names_overlap`, edges with several closest pairs have the feature `overlap`.
ClosestPair closest_pair(const DifferencePolygon& polygon, const Sublevel& sublevel, const Moment& at,
                         bool names_overlap);

}  // namespace touchstone::oracle
