// Where the corners of a curved query are, over doubles or over intervals, and how fast bodies turn.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <touchstone/curved_query.hpp>

#include "geometry/vector.hpp"

namespace touchstone::baselines {

/// The square of a number; for intervals it is less wide than the product.
inline double square(double x) { return x * x; }

/// A bound on the angular speed of q(t) = (1 - t) q0 + t q1 over the step: 2 |q0 ^ q1| / |q(t)|^2, where the wedge's
/// length is that of the part of q1 across q0 times |q0|, at the least |q(t)|.
double angular_speed(const RigidMotion& motion);

/// The corners of a query, with quaternions scaled to ordinary length and lengths times 2^-exponent.
class CurvedCorners {
 public:
  explicit CurvedCorners(const CurvedQuery& query);

  int exponent() const { return exponent_; }
  const CurvedQuery& query() const { return query_; }  ///< the scaled one

  /// Corner i at time t, which is a number of type N.
  template <class N>
  geometry::Vector<N> at(std::size_t i, const N& t) const {
    const CurvedCorner& corner = query_.corners[i];
    if (corner.motion == CurvedCorner::kOnCurve) return on_curve(corner, t);
    return on_body(query_.motions[static_cast<std::size_t>(corner.motion)], corner.points[0], t);
  }

 private:
  template <class N>
  static N between(double start, double end, const N& t) {
    return N(start) + N(end - start) * t;
  }

  template <class N>
  static geometry::Vector<N> on_body(const RigidMotion& motion, const Vec3& point, const N& t) {
    std::array<N, 4> q;
    for (std::size_t k = 0; k < 4; ++k) q[k] = between(motion.q0[k], motion.q1[k], t);
    const N ww = square(q[0]), xx = square(q[1]), yy = square(q[2]), zz = square(q[3]);
    const N length = (ww + xx) + (yy + zz);
    const auto twice = [](const N& x) { return N(2) * x; };
    const N x(point.x), y(point.y), z(point.z);
    const N turned_x =
        ((ww + xx) - (yy + zz)) * x + twice(q[1] * q[2] - q[0] * q[3]) * y + twice(q[1] * q[3] + q[0] * q[2]) * z;
    const N turned_y =
        twice(q[1] * q[2] + q[0] * q[3]) * x + ((ww + yy) - (xx + zz)) * y + twice(q[2] * q[3] - q[0] * q[1]) * z;
    const N turned_z =
        twice(q[1] * q[3] - q[0] * q[2]) * x + twice(q[2] * q[3] + q[0] * q[1]) * y + ((ww + zz) - (xx + yy)) * z;
    return {{turned_x / length + between(motion.p0.x, motion.p1.x, t),
             turned_y / length + between(motion.p0.y, motion.p1.y, t),
             turned_z / length + between(motion.p0.z, motion.p1.z, t)}};
  }

  /// By de Casteljau's algorithm.
  template <class N>
  static geometry::Vector<N> on_curve(const CurvedCorner& corner, const N& t) {
    std::array<geometry::Vector<N>, 4> points;
    for (std::size_t k = 0; k < points.size(); ++k) {
      points[k] = {{N(corner.points[k].x), N(corner.points[k].y), N(corner.points[k].z)}};
    }
    for (auto count = static_cast<std::size_t>(corner.control_points); count > 1; --count) {
      for (std::size_t k = 0; k + 1 < count; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          points[k][axis] = points[k][axis] + (points[k + 1][axis] - points[k][axis]) * t;
        }
      }
    }
    return points[0];
  }

  CurvedQuery query_;
  int exponent_ = 0;
};

}  // namespace touchstone::baselines
