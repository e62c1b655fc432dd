// SPDX-License-Identifier: MIT
#include "filters/curved/curved_chords.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "filters/apart/same_side.hpp"
#include "filters/step_frame.hpp"
#include "geometry/arc_bulge.hpp"
#include "geometry/kind_traits.hpp"
#include "geometry/vector.hpp"
#include "numbers/doubles/pack.hpp"

namespace touchstone::filters {
namespace {

using Index = std::size_t;
using Ends = numbers::Pack<2>;  // at t = 0 and at t = 1
using EndsVector = geometry::Vector<Ends>;

// A corner X of a body that turns leaves its chord, the straight motion between the ends of its path, by at most 0.55
// d^2 |X|, where d is the distance of the quaternions q0 / |q0| and q1 / |q1|, with d^2 <= 2: see geometry::kArcBulge.
// With L the largest coordinate of X, |X| <= 1.7321 L.
//
// Here the lengths differ: |q1| = (1 + r) |q0|, and |q1 - q0|^2 / |q0|^2, which is (1 + r) d^2 + r^2, stands for d^2:
// it is not less but by a relative r. At the time t the body is where quaternions of length 1 are at t', with |t' - t|
// <= r / 4, up to second order. The chord moves by 2 d |X| at most, and by r d |X| / 2 from t to t': that is at most
// 0.866 r d L <= 0.008 d^2 L + 24 r^2 L. The lengths' squares are within kMostStretch of each other, relatively: r <
// 2^-40, and 24 r^2 < 2^-75.
constexpr double kBulge = geometry::kArcBulge * 1.7321 + 0.017;  // 0.008, and 0.009 for the rounding of d^2
constexpr double kMostDistance = 1;
constexpr double kMostStretch = 0x1p-40;

// The ends, with e = 2^-53 and n = |q|^2. An entry of M(q) is at most n, and off by 3 e n. A coordinate of M(q) X sums
// 3 of them times a coordinate, at most n |X| in all: off by 9 e n L for the entries and 3 e n |X| for the products and
// sums, 14.2 e n L together. n is off by 3 e n, its inverse by 4 e relatively, the product by 5 e: 8.7 e L. Positions
// relative to the origin are rounded once: with P the largest, e P, and the sum e (1.8 L + P). In all 25 e L + 2 e P
// along an axis, and 44 e L + 3.5 e P in length. The rest is for 24 r^2, terms of second order, and the rounding of the
// bound.
constexpr double kTurnedError = 46 * 0x1p-53;
constexpr double kPositionError = 4 * 0x1p-53;

// Then nothing underflows by more than the rest above allows, and nothing overflows.
constexpr double kLeastSquare = 0x1p-500, kGreatestSquare = 0x1p500;
constexpr double kLeastLength = 0x1p-300, kGreatestLength = 0x1p300;

/// A body's rotation at both ends, and how far it leaves the chords of points with coordinates up to 1.
struct Turns {
  std::array<EndsVector, 3> rows = {};
  Ends per_square = {};
  EndsVector position = {};
  double bulge = 0;
};

EndsVector ends_of(const Vec3& start, const Vec3& end) noexcept {
  return {{numbers::pack(start.x, end.x), numbers::pack(start.y, end.y), numbers::pack(start.z, end.z)}};
}

double largest(const EndsVector& x) noexcept {
  const Ends both = larger(larger(magnitude(x[0]), magnitude(x[1])), magnitude(x[2]));
  return std::max(both.v[0], both.v[1]);
}

double square(double x) noexcept { return x * x; }

/// False where the body turns too far, or the quaternions differ in length.
bool make_turns(const RigidMotion& motion, const EndsVector& origin, Turns& turns) noexcept {
  const auto& a = motion.q0;
  const auto& b = motion.q1;
  const Ends w = numbers::pack(a[0], b[0]), x = numbers::pack(a[1], b[1]), y = numbers::pack(a[2], b[2]),
             z = numbers::pack(a[3], b[3]);
  const Ends ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const Ends n = (ww + xx) + (yy + zz);
  const double n0 = n.v[0], n1 = n.v[1];
  if (!(n0 >= kLeastSquare && n0 <= kGreatestSquare && std::fabs(n1 - n0) <= kMostStretch * n0)) return false;
  turns.per_square = numbers::pack(1 / n0, 1 / n1);
  const double apart = (square(b[0] - a[0]) + square(b[1] - a[1])) + (square(b[2] - a[2]) + square(b[3] - a[3]));
  const double distance = apart * turns.per_square.v[0];
  if (!(distance <= kMostDistance)) return false;
  turns.bulge = kBulge * distance + kTurnedError;
  const Ends xy = x * y, xz = x * z, yz = y * z, wx = w * x, wy = w * y, wz = w * z;
  turns.rows = {{{{(ww + xx) - (yy + zz), 2.0 * (xy - wz), 2.0 * (xz + wy)}},
                 {{2.0 * (xy + wz), (ww + yy) - (xx + zz), 2.0 * (yz - wx)}},
                 {{2.0 * (xz - wy), 2.0 * (yz + wx), (ww + zz) - (xx + yy)}}}};
  turns.position = ends_of(motion.p0, motion.p1) - origin;
  return true;
}

/// What the chords of one element need.
struct Side {
  int motion = CurvedCorner::kOnCurve;
  Turns turns;
  double reach = 0;     ///< no coordinate of a body point is larger
  double position = 0;  ///< no coordinate of a position, or of a point of a curve, is larger
};

/// False where its corners are of two bodies, or a curve bends.
bool make_side(const CurvedQuery& query, Index first, Index last, const EndsVector& origin, Side& side) noexcept {
  side.motion = query.corners[first].motion;
  for (Index i = first; i < last; ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.motion != side.motion) return false;
    if (corner.motion == CurvedCorner::kOnCurve && corner.control_points > 2) return false;
  }
  if (side.motion == CurvedCorner::kOnCurve) return true;
  if (!make_turns(query.motions[static_cast<Index>(side.motion)], origin, side.turns)) return false;
  side.position = largest(side.turns.position);
  return true;
}

EndsVector position_of(const CurvedCorner& corner, const EndsVector& origin, Side& side) noexcept {
  if (side.motion == CurvedCorner::kOnCurve) {
    const EndsVector x = ends_of(corner.points[0], corner.points[corner.control_points > 1 ? 1 : 0]) - origin;
    side.position = std::max(side.position, largest(x));
    return x;
  }
  const Vec3& point = corner.points[0];
  side.reach = std::max({side.reach, std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
  EndsVector x;
  for (Index k = 0; k < 3; ++k) {
    const EndsVector& row = side.turns.rows[k];
    x[k] = side.turns.per_square * ((point.x * row[0] + point.y * row[1]) + point.z * row[2]) + side.turns.position[k];
  }
  return x;
}

}  // namespace

Chords chords_of(const CurvedQuery& query) noexcept {
  Chords chords;
  const Index second = geometry::corners_of_first(query.kind);
  const int leader =
      query.corners[0].motion != CurvedCorner::kOnCurve ? query.corners[0].motion : query.corners[second].motion;
  if (leader == CurvedCorner::kOnCurve) return chords;
  const RigidMotion& leading = query.motions[static_cast<Index>(leader)];
  const EndsVector origin = ends_of(leading.p0, leading.p1);
  std::array<Side, 2> sides;
  if (!make_side(query, 0, second, origin, sides[0]) || !make_side(query, second, 4, origin, sides[1])) return chords;
  chords.query.kind = query.kind;
  for (Index i = 0; i < 4; ++i) {
    const EndsVector x = position_of(query.corners[i], origin, sides[i < second ? 0 : 1]);
    chords.query.start[i] = {x[0].v[0], x[1].v[0], x[2].v[0]};
    chords.query.end[i] = {x[0].v[1], x[1].v[1], x[2].v[1]};
  }
  double length = 0;
  for (const Side& side : sides) {
    chords.deviation += side.turns.bulge * side.reach + kPositionError * side.position;
    length += side.reach + side.position;
  }
  chords.known = length >= kLeastLength && length <= kGreatestLength;
  return chords;
}

bool chords_certainly_farther(const CurvedQuery& query, const Separation& separation) noexcept {
  if (!has_cubic(query.kind)) return false;
  const Chords chords = chords_of(query);
  // The sum is rounded.
  constexpr double kRounded = 1 + 0x1p-50;
  return chords.known &&
         clear_all_along(chords.query, {kRounded * (separation.distance + chords.deviation), separation.metric});
}

}  // namespace touchstone::filters
