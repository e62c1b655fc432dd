// Touchstone: queries whose corners do not move on straight lines: corners of bodies that turn, and on Bezier curves.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include <touchstone/query.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// A rigid motion over the step: a pose at both ends, and between them
///
///     q(t) = (1 - t) q0 + t q1    p(t) = (1 - t) p0 + t p1    x(t) = M(q(t)) X / |q(t)|^2 + p(t)
///
/// for a point X of the body. A quaternion is {w, x, y, z}. M(q) X is the vector part of q X q*, so M(q) / |q|^2 is a
/// rotation for every q that is not zero; see Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985.
/// Both poses are met exactly. Over the step the body turns about one axis, as with slerp, at a pace that differs a
/// little. q and -q are the same rotation, but they are the ends of two different turns: with q0 . q1 >= 0 the body
/// takes the shorter one.
struct RigidMotion {
  std::array<double, 4> q0 = {1, 0, 0, 0};  ///< orientation at t = 0: {w, x, y, z}, finite, not all 0, of any length
  std::array<double, 4> q1 = {1, 0, 0, 0};  ///< orientation at t = 1, not q0 times a negative number
  Vec3 p0;                                  ///< where the body's origin is at t = 0, in the unit of length
  Vec3 p1;                                  ///< where the body's origin is at t = 1

  /// How many control points the position's Bezier curve has, 2 to 4: p0, none to two of `inner`, and p1. With more
  /// than two, p(t) is on this curve, and `solve_screw` takes the motion: all else that computes refuses it.
  int control_points = 2;
  std::array<Vec3, 2> inner{};  ///< the control points between p0 and p1; the first control_points - 2 of them count
};

/// One corner: a point of a rigid body, or a point on a Bezier curve of degree 0 to 3.
struct CurvedCorner {
  static constexpr int kOnCurve = -1;  ///< the value of `motion` for a corner on a curve

  int motion = kOnCurve;         ///< the index of the body's motion in CurvedQuery::motions, 0 to 3, or kOnCurve
  int control_points = 1;        ///< for a corner on a curve: how many points count, 1 to 4
  std::array<Vec3, 4> points{};  ///< the curve's control points, or the body point X in points[0]

  /// A corner at the body's point X.
  /// @param motion  the index of the body's motion in CurvedQuery::motions, 0 to 3
  /// @param point   X, in the body's own frame
  static CurvedCorner on_body(int motion, const Vec3& point);

  /// A corner on a Bezier curve. With n + 1 control points b_i, it is at the sum of binomial(n, i) (1 - t)^(n - i) t^i
  /// b_i; see Farin, "Curves and surfaces for CAGD", section 5.1. One point is a corner at rest, two are a straight
  /// motion, three a ballistic arc.
  /// @param control_points  1 to 4 points
  /// @throws InvalidQuery  for another number of points
  static CurvedCorner on_curve(std::initializer_list<Vec3> control_points);
};

/// A query whose corners move on curves.
struct CurvedQuery {
  Kind kind = Kind::edge_edge;            ///< which elements
  std::array<CurvedCorner, 4> corners{};  ///< in the kind's order; those past corner_count(kind) are never read
  std::array<RigidMotion, 4> motions{};   ///< those that no corner names are never read

  /// An edge-edge query with all corners at rest at the origin.
  CurvedQuery() = default;
  /// A straight motion, as curves with two control points each.
  explicit CurvedQuery(const Query& query);
};

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
