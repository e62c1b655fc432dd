// SPDX-License-Identifier: MIT
#include "shells/hinge.hpp"

#include <Eigen/Geometry>

#include <cmath>

// With the normals v = e x p and w = r x e and the unit vector a = e / |e|, a change of v turns theta by
// -(a x v) . dv / |v|^2, and one of w by (a x w) . dw / |w|^2, as v and w stay perpendicular to e. So the gradient is
//   by p: -|e| V,  by r: -|e| W,  by e: (p . a) V + (r . a) W   with V = v / |v|^2 and W = w / |w|^2.
// This holds everywhere, so that the second derivatives are those of the formula.
namespace touchstone::sim {
namespace {

using Matrix3 = Eigen::Matrix3d;
using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;

Matrix3 cross_matrix(const Vector3& v) {
  Matrix3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// The derivative of n / |n|^2 by n.
Matrix3 inverted(const Vector3& n, double nn) { return (Matrix3::Identity() - 2 / nn * n * n.transpose()) / nn; }

}  // namespace

HingeStrain::HingeStrain(const Vector3& x0, const Vector3& x1, const Vector3& x2, const Vector3& x3)
    : e_(x1 - x0), p_(x2 - x0), r_(x3 - x0), length_(e_.norm()) {
  along_ = e_ / length_;
  v_ = e_.cross(p_);
  w_ = r_.cross(e_);
  vv_ = v_.squaredNorm();
  ww_ = w_.squaredNorm();
  // tan(theta / 2) = sin theta / (1 + cos theta)
  bend_ = 2 * along_.dot(v_.cross(w_)) / (std::sqrt(vv_ * ww_) + v_.dot(w_));
}

Vector9 HingeStrain::angle_gradient() const {
  const Vector3 v = v_ / vv_, w = w_ / ww_;
  Vector9 g;
  g << p_.dot(along_) * v + r_.dot(along_) * w, -length_ * v, -length_ * w;
  return g;
}

HingeVector HingeStrain::gradient() const {
  const Vector9 g = (1 + 0.25 * bend_ * bend_) * angle_gradient();
  HingeVector all;
  all << -g.segment<3>(0) - g.segment<3>(3) - g.segment<3>(6), g;
  return all;
}

void HingeStrain::add_hessian(double weight, HingeMatrix& sum) const {
  const Matrix3 by_v = inverted(v_, vv_), by_w = inverted(w_, ww_);
  const Matrix3 e = cross_matrix(e_), p = cross_matrix(p_), r = cross_matrix(r_);
  const Matrix3 across = (Matrix3::Identity() - along_ * along_.transpose()) / length_;
  const Vector3 v = v_ / vv_, w = w_ / ww_;
  const double pa = p_.dot(along_), ra = r_.dot(along_);
  Matrix9 h;
  h.block<3, 3>(0, 0) = v * (across * p_).transpose() - pa * by_v * p + w * (across * r_).transpose() + ra * by_w * r;
  h.block<3, 3>(3, 0) = -v * along_.transpose() + length_ * by_v * p;
  h.block<3, 3>(6, 0) = -w * along_.transpose() - length_ * by_w * r;
  h.block<3, 3>(0, 3) = h.block<3, 3>(3, 0).transpose();
  h.block<3, 3>(0, 6) = h.block<3, 3>(6, 0).transpose();
  h.block<3, 3>(3, 3) = -length_ * by_v * e;
  h.block<3, 3>(6, 6) = length_ * by_w * e;
  h.block<3, 3>(3, 6).setZero();
  h.block<3, 3>(6, 3).setZero();
  // bend = 2 tan(theta / 2)
  const double first = 1 + 0.25 * bend_ * bend_, second = 0.5 * bend_ * first;
  const Vector9 g = angle_gradient();
  const Matrix9 own = weight * (0.5 * first * (h + h.transpose()) + second * g * g.transpose());
  sum.block<9, 9>(3, 3) += own;
  Eigen::Matrix<double, 3, 9> rows = -(own.topRows<3>() + own.middleRows<3>(3) + own.bottomRows<3>());
  sum.block<3, 9>(0, 3) += rows;
  sum.block<9, 3>(3, 0) += rows.transpose();
  sum.block<3, 3>(0, 0) -= rows.leftCols<3>() + rows.middleCols<3>(3) + rows.rightCols<3>();
}

}  // namespace touchstone::sim
