// The pose of a rigid body: a rotation as a quaternion of length 1, and where its origin is.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>

namespace touchstone::sim {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// {w, x, y, z}, as in touchstone::RigidMotion.
using Quaternion = std::array<double, 4>;

struct Pose {
  Quaternion q{1, 0, 0, 0};
  Vector3 p = Vector3::Zero();  ///< m

  bool operator==(const Pose&) const = default;
};

double dot(const Quaternion& a, const Quaternion& b) noexcept;
Quaternion product(const Quaternion& a, const Quaternion& b) noexcept;
Quaternion conjugate(const Quaternion& q) noexcept;
Quaternion normalised(const Quaternion& q) noexcept;
Quaternion negated(const Quaternion& q) noexcept;

/// The rotation by the length of this vector about it, rad.
Quaternion rotation_by(const Vector3& turn) noexcept;

/// The shorter way from one orientation to the other as such a vector; both of length 1.
Vector3 turn_between(const Quaternion& from, const Quaternion& to) noexcept;

/// Of a quaternion of length 1.
Matrix3 matrix_of(const Quaternion& q) noexcept;
Vector3 turned(const Quaternion& q, const Vector3& x) noexcept;
Vector3 turned_back(const Quaternion& q, const Vector3& x) noexcept;

inline Vector3 placed(const Pose& pose, const Vector3& x) noexcept { return turned(pose.q, x) + pose.p; }

/// The pose at t in [0, 1] of the rigid motion between two poses (touchstone::RigidMotion).
Pose between(const Pose& start, const Pose& end, double t) noexcept;

}  // namespace touchstone::sim
