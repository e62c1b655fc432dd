// Rotations and curves in doubles, for building curved queries. Exact on the lattices that the generators use.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/curved_query.hpp>

#include "families/linear_motion.hpp"
#include "seeded/rng.hpp"

namespace touchstone::families {

using Quaternion = std::array<double, 4>;  ///< {w, x, y, z}

constexpr Quaternion kNoTurn = {1, 0, 0, 0};

inline double dot(const Quaternion& a, const Quaternion& b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}
inline Quaternion operator*(double s, const Quaternion& q) { return {s * q[0], s * q[1], s * q[2], s * q[3]}; }
inline Quaternion operator+(const Quaternion& a, const Quaternion& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
Quaternion product(const Quaternion& a, const Quaternion& b);

/// M(q) X: the point turned, times |q|^2.
Vec3 turned(const Quaternion& q, const Vec3& x);

/// A turn about a coordinate axis 0, 1 or 2: by twice the angle whose tangent is s / c.
Quaternion about_axis(std::size_t axis, double c, double s);

/// Integers in [-reach, reach], not all 0.
Quaternion lattice_quaternion(seeded::Rng& rng, int reach);

/// Which element has the corner: 0 or 1.
constexpr std::size_t element_of(Kind kind, std::size_t corner) { return corner < element_sizes(kind).a ? 0 : 1; }

/// The corner at time t, in doubles. Exact where t is a small dyadic, all numbers are small integers, and body points
/// are multiples of |q(t)|^2.
Vec3 position(const CurvedQuery& query, std::size_t corner, double t);

/// Moves all of an element by a vector: its bodies' positions or its control points. A motion that both elements use is
/// moved for both.
void translate(CurvedQuery& query, std::size_t element, const Vec3& by);

using CornerWeights = std::array<double, 3>;  ///< barycentric, of one element's corners

/// Moves the second element so that the points of both with these weights meet at time t.
void meet(CurvedQuery& query, const CornerWeights& wa, const CornerWeights& wb, double t);

/// Turns all of space by the quaternion and multiplies it by |q|^2, so that integers stay integers.
void turn_space(CurvedQuery& query, const Quaternion& q);

/// Changes signs of quaternions so that no motion in use passes through q(t) = 0; a quaternion that is zero becomes
/// kNoTurn. Every motion that is valid before stays, save where products of components over- or underflow.
void make_valid(CurvedQuery& query);

/// Calls f(double&) for every length that the query reads: coordinates of body points, control points and positions.
template <typename F>
void for_each_length(CurvedQuery& query, F&& f) {
  std::array<bool, 4> used{};
  const auto each = [&](Vec3& v) {
    for (std::size_t axis = 0; axis < 3; ++axis) f(coordinate(v, axis));
  };
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    CurvedCorner& corner = query.corners[i];
    const bool on_curve = corner.motion == CurvedCorner::kOnCurve;
    if (!on_curve) used[static_cast<std::size_t>(corner.motion)] = true;
    const std::size_t points = on_curve ? static_cast<std::size_t>(corner.control_points) : 1;
    for (std::size_t k = 0; k < points; ++k) each(corner.points[k]);
  }
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    each(query.motions[m].p0);
    each(query.motions[m].p1);
  }
}

/// Calls f(RigidMotion&) for every motion that a corner names.
template <typename F>
void for_each_motion(CurvedQuery& query, F&& f) {
  std::array<bool, 4> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (query.corners[i].motion != CurvedCorner::kOnCurve)
      used[static_cast<std::size_t>(query.corners[i].motion)] = true;
  }
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (used[m]) f(query.motions[m]);
  }
}

/// Calls f(double&) for every number that the query reads: its lengths, then the components of its quaternions.
template <typename F>
void for_each_number(CurvedQuery& query, F&& f) {
  for_each_length(query, f);
  for_each_motion(query, [&](RigidMotion& motion) {
    for (double& c : motion.q0) f(c);
    for (double& c : motion.q1) f(c);
  });
}

}  // namespace touchstone::families
