// How a rigid body turns while no torque acts on it.
// SPDX-License-Identifier: MIT
#pragma once

#include "bodies/pose.hpp"

namespace touchstone::sim {

/// Moments of inertia about the centre of mass, in the body's own frame, and their inverse.
struct Inertia {
  Matrix3 moments = Matrix3::Identity();  ///< kg m^2
  Matrix3 inverse = Matrix3::Identity();
  double least = 1;  ///< the smallest principal moment

  Inertia() = default;
  explicit Inertia(const Matrix3& moments);
};

/// rad/s, of a body of this orientation with this angular momentum (kg m^2/s, in the world's frame).
Vector3 angular_velocity(const Inertia& inertia, const Quaternion& q, const Vector3& momentum);
Vector3 angular_momentum(const Inertia& inertia, const Quaternion& q, const Vector3& velocity);

/// J
double spin_energy(const Inertia& inertia, const Quaternion& q, const Vector3& momentum);

/// No less than the angle, rad, by which the body can turn in h seconds.
double most_turn(const Inertia& inertia, const Vector3& momentum, double h);

/// The orientation h seconds later. The angular momentum is what it was: it is an argument, and nothing rounds it. The
/// energy changes by rounding only, and the orientation is good to the fourth order of the inner step, which turns the
/// body by at most a twentieth of a radian.
Quaternion free_spin(const Inertia& inertia, const Quaternion& q, const Vector3& momentum, double h);

}  // namespace touchstone::sim
