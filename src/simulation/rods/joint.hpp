// Curvature and twist where two segments of a cable meet, with their derivatives.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "scene/scene.hpp"

namespace touchstone::sim {

/// Coordinates of a joint, in this order: p0 (3), angle of e, p1 (3), angle of f, p2 (3).
using JointVector = Eigen::Matrix<double, 11, 1>;
using JointMatrix = Eigen::Matrix<double, 11, 11>;

/// The integrated curvature kappa (Bergou et al. 2008): the binormal kb = 2 te x tf / (1 + te . tf), of size
/// 2 tan(angle / 2), in the average of the two material frames; and the twist m, the angle between the frames.
class JointStrain {
 public:
  /// @param de, df  reference directors of the two edges
  JointStrain(const Vector3& p0, const Vector3& p1, const Vector3& p2, const Vector3& de, const Vector3& df,
              double angle_e, double angle_f, double reference_twist);

  /// The same for a cable that does not resist twist, and has no frames but a director of e to measure curvature in:
  /// the frame of f is that of e under the shortest rotation, and the twist is always 0.
  JointStrain(const Vector3& p0, const Vector3& p1, const Vector3& p2, const Vector3& de);

  double kappa1() const noexcept { return kappa1_; }
  double kappa2() const noexcept { return kappa2_; }
  double twist() const noexcept { return twist_; }

  /// Derivatives at this very place, with frames that are carried along from it by the shortest rotation.
  void gradients(JointVector& kappa1, JointVector& kappa2, JointVector& twist) const;

  /// Adds w1 * (second derivative of kappa1) + w2 * (of kappa2) + w3 * (of the twist).
  void add_hessians(double w1, double w2, double w3, JointMatrix& sum) const;

 private:
  void measure(const Vector3& p0, const Vector3& p1, const Vector3& p2);
  void set_frames(const Vector3& m1e, const Vector3& m1f);

  bool aligned_ = false;  // the frame of f follows that of e
  double length_e_, length_f_, chi_;
  Vector3 te_, tf_, kb_;
  Vector3 m1e_, m2e_, m1f_, m2f_;
  Vector3 t_, d1_, d2_;  // (te + tf) / chi, (m1e + m1f) / chi, (m2e + m2f) / chi
  double kappa1_, kappa2_, twist_;
};

}  // namespace touchstone::sim
