// Corners that move on curves, in rationals: what doubles are compared with. It shares nothing with the library.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <gmpxx.h>

#include <touchstone/curved_query.hpp>

namespace touchstone::tests {

using RationalPoint = std::array<mpq_class, 3>;
using RationalQuaternion = std::array<mpq_class, 4>;

inline RationalPoint exact(const Vec3& x) { return {mpq_class(x.x), mpq_class(x.y), mpq_class(x.z)}; }

inline RationalQuaternion product(const RationalQuaternion& a, const RationalQuaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

inline mpq_class square(const RationalQuaternion& q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

/// The vector part of q x q*.
inline RationalPoint turned(const RationalQuaternion& q, const RationalPoint& x) {
  const RationalQuaternion result =
      product(product(q, {0, x[0], x[1], x[2]}), {q[0], mpq_class(-q[1]), mpq_class(-q[2]), mpq_class(-q[3])});
  return {result[1], result[2], result[3]};
}

/// A rigid motion in rationals. The numerator and the weight of a corner at t, both homogeneous.
struct RationalMotion {
  RationalQuaternion q0, q1;
  RationalPoint p0, p1, x;

  RationalMotion(const RigidMotion& motion, const Vec3& point)
      : p0(exact(motion.p0)), p1(exact(motion.p1)), x(exact(point)) {
    for (std::size_t i = 0; i < 4; ++i) {
      q0[i] = mpq_class(motion.q0[i]);
      q1[i] = mpq_class(motion.q1[i]);
    }
  }
  RationalQuaternion q(const mpq_class& t) const {
    RationalQuaternion result;
    for (std::size_t i = 0; i < 4; ++i) result[i] = (1 - t) * q0[i] + t * q1[i];
    return result;
  }
  mpq_class weight(const mpq_class& t) const { return square(q(t)); }
  RationalPoint numerator(const mpq_class& t) const {
    RationalPoint result = turned(q(t), x);
    for (std::size_t k = 0; k < 3; ++k) result[k] += weight(t) * ((1 - t) * p0[k] + t * p1[k]);
    return result;
  }
};

/// A corner at t in homogeneous coordinates.
struct RationalCorner {
  RationalPoint numerator;
  mpq_class weight;
};
inline RationalCorner corner_at(const CurvedQuery& query, std::size_t i, const mpq_class& t) {
  const CurvedCorner& corner = query.corners[i];
  if (corner.motion != CurvedCorner::kOnCurve) {
    const RationalMotion motion(query.motions[static_cast<std::size_t>(corner.motion)], corner.points[0]);
    return {motion.numerator(t), motion.weight(t)};
  }
  std::vector<RationalPoint> points;
  for (int k = 0; k < corner.control_points; ++k) points.push_back(exact(corner.points[static_cast<std::size_t>(k)]));
  for (std::size_t count = points.size(); count > 1; --count) {
    for (std::size_t k = 0; k + 1 < count; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        points[k][axis] = (1 - t) * points[k][axis] + t * points[k + 1][axis];
      }
    }
  }
  return {points[0], 1};
}

}  // namespace touchstone::tests
