// A query's corners as exact motions: each coordinate an integer polynomial in t, of degree at most one
// for straight motion.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "oracle/algebra.hpp"

namespace touchstone::oracle {

/// One moving corner: x, y and z over t.
using Corner = std::array<Polynomial, 3>;

/// The moving corners of a query, in its order; those past corner_count(kind) are zero.
using Corners = std::array<Corner, 4>;

/// The motions in units that make every position at t = 0 and t = 1 an integer. Each axis has its own unit (a power
/// of two for doubles, the common denominator for rationals): scaling an axis is an invertible linear map of space,
/// so touching, its times and barycentric coordinates are those of the query. Distances are not.
Corners read_motion(const Query& query);
Corners read_motion(const RationalQuery& query);

/// The corners of a curved query, all multiplied by one positive polynomial in t and by one number that makes their
/// coefficients integers. Touching, its times and barycentric coordinates are those of the query.
Corners read_motion(const CurvedQuery& query);

/// A motion and a distance in the same unit. At each time the positions are in addition multiplied by the scale, which
/// is positive in [0, 1].
struct MeasuredMotion {
  Corners corners;
  Integer distance;
  Polynomial scale = Polynomial(Integer(1));
};

/// The motion and the distance in one unit for all three axes, which makes all of them integers. So the distance of
/// two elements compares with the given one as it does in the query.
MeasuredMotion read_measured_motion(const Query& query, double distance);
MeasuredMotion read_measured_motion(const RationalQuery& query, double distance);
MeasuredMotion read_measured_motion(const CurvedQuery& query, double distance);

}  // namespace touchstone::oracle
