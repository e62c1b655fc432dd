// SPDX-License-Identifier: MIT
#include "bodies/pose.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace touchstone::sim {

double dot(const Quaternion& a, const Quaternion& b) noexcept {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

Quaternion product(const Quaternion& a, const Quaternion& b) noexcept {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Quaternion conjugate(const Quaternion& q) noexcept { return {q[0], -q[1], -q[2], -q[3]}; }

Quaternion negated(const Quaternion& q) noexcept { return {-q[0], -q[1], -q[2], -q[3]}; }

Quaternion normalised(const Quaternion& q) noexcept {
  const double length = std::sqrt(dot(q, q));
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

Quaternion rotation_by(const Vector3& turn) noexcept {
  const double angle = turn.norm();
  // sin(a / 2) / a, which is 1/2 for an angle of 0.
  const double scale = angle > 1e-8 ? std::sin(angle / 2) / angle : 0.5;
  return normalised({std::cos(angle / 2), scale * turn.x(), scale * turn.y(), scale * turn.z()});
}

Vector3 turn_between(const Quaternion& from, const Quaternion& to) noexcept {
  Quaternion by = product(to, conjugate(from));
  if (by[0] < 0) by = negated(by);
  const Vector3 axis(by[1], by[2], by[3]);
  const double sine = axis.norm();
  return sine > 1e-8 ? Vector3(2 * std::atan2(sine, by[0]) / sine * axis) : Vector3(2 * axis);
}

Matrix3 matrix_of(const Quaternion& q) noexcept {
  const double ww = q[0] * q[0], xx = q[1] * q[1], yy = q[2] * q[2], zz = q[3] * q[3];
  const double xy = 2 * q[1] * q[2], xz = 2 * q[1] * q[3], yz = 2 * q[2] * q[3];
  const double wx = 2 * q[0] * q[1], wy = 2 * q[0] * q[2], wz = 2 * q[0] * q[3];
  Matrix3 m;
  m << ww + xx - yy - zz, xy - wz, xz + wy, xy + wz, ww - xx + yy - zz, yz - wx, xz - wy, yz + wx, ww - xx - yy + zz;
  return m;
}

Vector3 turned(const Quaternion& q, const Vector3& x) noexcept { return matrix_of(q) * x; }

Vector3 turned_back(const Quaternion& q, const Vector3& x) noexcept { return matrix_of(q).transpose() * x; }

Pose between(const Pose& start, const Pose& end, double t) noexcept {
  Quaternion q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = (1 - t) * start.q[i] + t * end.q[i];
  return {normalised(q), (1 - t) * start.p + t * end.p};
}

}  // namespace touchstone::sim
