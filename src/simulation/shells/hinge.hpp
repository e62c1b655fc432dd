// The bending of cloth: two triangles of a surface turn about the edge that they share (Grinspun et al. 2003, "Discrete
// shells").
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "scene/scene.hpp"

namespace touchstone::sim {

using HingeVector = Eigen::Matrix<double, 12, 1>;
using HingeMatrix = Eigen::Matrix<double, 12, 12>;

/// The triangles (p0, p1, p2) and (p1, p0, p3). The energy is 1/2 stiffness (bend - rest)^2.
struct Hinge {
  std::array<Index, 4> p{};
  double stiffness = 0;  ///< J
  double rest = 0;
  double damping = 0;  ///< s
};

/// bend = 2 tan(theta / 2), with the signed angle theta from the normal of the first triangle to that of the second. It
/// has the sign of a turn about p0 -> p1 and is infinite where the triangles fold onto each other, as the bend of a
/// cable is.
class HingeStrain {
 public:
  HingeStrain(const Vector3& x0, const Vector3& x1, const Vector3& x2, const Vector3& x3);

  double bend() const noexcept { return bend_; }
  HingeVector gradient() const;

  /// Adds `weight` times the second derivatives of bend.
  void add_hessian(double weight, HingeMatrix& sum) const;

 private:
  Eigen::Matrix<double, 9, 1> angle_gradient() const;  // by e, p, r

  Vector3 e_, p_, r_;     // x1 - x0, x2 - x0, x3 - x0
  Vector3 along_;         // e / |e|
  Vector3 v_, w_;         // e x p and r x e
  double length_, bend_;  // |e|
  double vv_, ww_;        // squares of |v| and |w|
};

}  // namespace touchstone::sim
