// SPDX-License-Identifier: MIT
#include "rods/joint.hpp"

#include <Eigen/Geometry>

#include "rods/frames.hpp"

// First derivatives: Bergou et al. 2010, section 4.3. Second derivatives follow by differentiating them once more along
// frames that are carried by the shortest rotation, and symmetrising: carrying directly from the point of evaluation
// differs from carrying along a path by half the solid angle between them, which is antisymmetric.
namespace touchstone::sim {
namespace {

using Matrix3 = Eigen::Matrix3d;

Matrix3 cross_matrix(const Vector3& v) {
  Matrix3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Matrix3 symmetric_outer(const Vector3& a, const Vector3& b) { return a * b.transpose() + b * a.transpose(); }

/// Adds a matrix of derivatives with respect to the edge vectors e = p1 - p0 and f = p2 - p1.
void add_edge_blocks(double weight, const Matrix3& ee, const Matrix3& ef, const Matrix3& ff, JointMatrix& sum) {
  const Matrix3 fe = ef.transpose();
  sum.block<3, 3>(0, 0) += weight * ee;
  sum.block<3, 3>(0, 4) += weight * (ef - ee);
  sum.block<3, 3>(4, 0) += weight * (fe - ee);
  sum.block<3, 3>(0, 8) -= weight * ef;
  sum.block<3, 3>(8, 0) -= weight * fe;
  sum.block<3, 3>(4, 4) += weight * (ee - ef - fe + ff);
  sum.block<3, 3>(4, 8) += weight * (ef - ff);
  sum.block<3, 3>(8, 4) += weight * (fe - ff);
  sum.block<3, 3>(8, 8) += weight * ff;
}

/// Adds mixed derivatives with respect to the edge vectors and the angle in row `angle`.
void add_angle_blocks(double weight, const Vector3& by_e, const Vector3& by_f, int angle, JointMatrix& sum) {
  JointVector column = JointVector::Zero();
  column.segment<3>(0) = -weight * by_e;
  column.segment<3>(4) = weight * (by_e - by_f);
  column.segment<3>(8) = weight * by_f;
  sum.col(angle) += column;
  sum.row(angle) += column.transpose();
}

}  // namespace

JointStrain::JointStrain(const Vector3& p0, const Vector3& p1, const Vector3& p2, const Vector3& de, const Vector3& df,
                         double angle_e, double angle_f, double reference_twist) {
  measure(p0, p1, p2);
  set_frames(turned(de, te_, angle_e), turned(df, tf_, angle_f));
  twist_ = angle_f - angle_e + reference_twist;
}

JointStrain::JointStrain(const Vector3& p0, const Vector3& p1, const Vector3& p2, const Vector3& de) : aligned_(true) {
  measure(p0, p1, p2);
  set_frames(de, parallel_transport(de, te_, tf_));
  twist_ = 0;
}

void JointStrain::measure(const Vector3& p0, const Vector3& p1, const Vector3& p2) {
  const Vector3 e = p1 - p0, f = p2 - p1;
  length_e_ = e.norm();
  length_f_ = f.norm();
  te_ = e / length_e_;
  tf_ = f / length_f_;
  chi_ = 1 + te_.dot(tf_);
  kb_ = (2 / chi_) * te_.cross(tf_);
}

void JointStrain::set_frames(const Vector3& m1e, const Vector3& m1f) {
  m1e_ = m1e;
  m2e_ = te_.cross(m1e_);
  m1f_ = m1f;
  m2f_ = tf_.cross(m1f_);
  t_ = (te_ + tf_) / chi_;
  d1_ = (m1e_ + m1f_) / chi_;
  d2_ = (m2e_ + m2f_) / chi_;
  kappa1_ = 0.5 * kb_.dot(m2e_ + m2f_);
  kappa2_ = -0.5 * kb_.dot(m1e_ + m1f_);
}

void JointStrain::gradients(JointVector& kappa1, JointVector& kappa2, JointVector& twist) const {
  const Vector3 k1e = (-kappa1_ * t_ + tf_.cross(d2_)) / length_e_;
  const Vector3 k1f = (-kappa1_ * t_ - te_.cross(d2_)) / length_f_;
  const Vector3 k2e = (-kappa2_ * t_ - tf_.cross(d1_)) / length_e_;
  const Vector3 k2f = (-kappa2_ * t_ + te_.cross(d1_)) / length_f_;
  const Vector3 me = 0.5 / length_e_ * kb_, mf = 0.5 / length_f_ * kb_;
  kappa1 << -k1e, -0.5 * kb_.dot(m1e_), k1e - k1f, -0.5 * kb_.dot(m1f_), k1f;
  kappa2 << -k2e, -0.5 * kb_.dot(m2e_), k2e - k2f, -0.5 * kb_.dot(m2f_), k2f;
  twist << -me, -1, me - mf, 1, mf;
  if (!aligned_) return;
  // Frames that were carried along would twist by m and measure another kappa: this one is kappa1 - tan(m / 2) kappa2
  // and kappa2 + tan(m / 2) kappa1 of theirs. There are no angles.
  kappa1 -= 0.5 * kappa2_ * twist;
  kappa2 += 0.5 * kappa1_ * twist;
  kappa1[3] = kappa1[7] = kappa2[3] = kappa2[7] = 0;
  twist.setZero();
}

void JointStrain::add_hessians(double w1, double w2, double w3, JointMatrix& sum) const {
  if (aligned_) w3 = 0.5 * (w2 * kappa1_ - w1 * kappa2_);
  const Matrix3 tt = t_ * t_.transpose();
  const Matrix3 across_e = Matrix3::Identity() - te_ * te_.transpose();
  const Matrix3 across_f = Matrix3::Identity() - tf_ * tf_.transpose();
  const Matrix3 skewed = Matrix3::Identity() + te_ * tf_.transpose();
  const double ee = 1 / (length_e_ * length_e_), ff = 1 / (length_f_ * length_f_), ef = 1 / (length_e_ * length_f_);
  const auto add_curvature = [&](double w, double kappa, double sign, const Vector3& d, const Vector3& me,
                                 const Vector3& mf) {
    const Vector3 tf_d = sign * tf_.cross(d), te_d = sign * te_.cross(d);
    const Matrix3 by_ee = ee * (2 * kappa * tt - symmetric_outer(tf_d, t_) - kappa / chi_ * across_e +
                                sign * 0.25 * symmetric_outer(kb_, me));
    const Matrix3 by_ff = ff * (2 * kappa * tt + symmetric_outer(te_d, t_) - kappa / chi_ * across_f +
                                sign * 0.25 * symmetric_outer(kb_, mf));
    const Matrix3 by_ef = ef * (2 * kappa * tt - tf_d * t_.transpose() + t_ * te_d.transpose() - kappa / chi_ * skewed -
                                sign * cross_matrix(d));
    add_edge_blocks(w, by_ee, by_ef, by_ff, sum);
  };
  add_curvature(w1, kappa1_, 1, d2_, m2e_, m2f_);
  add_curvature(w2, kappa2_, -1, d1_, m1e_, m1f_);
  sum(3, 3) += 0.5 * (-w1 * kb_.dot(m2e_) + w2 * kb_.dot(m1e_));
  sum(7, 7) += 0.5 * (-w1 * kb_.dot(m2f_) + w2 * kb_.dot(m1f_));
  // The derivative of m1 by its angle is m2, that of m2 is -m1.
  const auto add_angle = [&](const Vector3& m, double w, int angle) {
    const double half = 0.5 * kb_.dot(m);
    add_angle_blocks(w, (half * t_ - tf_.cross(m) / chi_) / length_e_, (half * t_ + te_.cross(m) / chi_) / length_f_,
                     angle, sum);
  };
  add_angle(m1e_, w1, 3);
  add_angle(m1f_, w1, 7);
  add_angle(m2e_, w2, 3);
  add_angle(m2f_, w2, 7);
  const Matrix3 twist_ee = -0.25 * ee * symmetric_outer(kb_, te_ + t_);
  const Matrix3 twist_ff = -0.25 * ff * symmetric_outer(kb_, tf_ + t_);
  const Matrix3 twist_ef = 0.5 * ef * (2 / chi_ * cross_matrix(te_) - kb_ * t_.transpose());
  add_edge_blocks(w3, twist_ee, twist_ef, twist_ff, sum);
  if (!aligned_) return;
  JointStrain carried = *this;
  carried.aligned_ = false;
  JointVector k1, k2, m;
  carried.gradients(k1, k2, m);
  const JointVector across = 0.5 * (w2 * k1 - w1 * k2);
  sum += across * m.transpose() + m * across.transpose();
  for (const int angle : {3, 7}) {
    sum.row(angle).setZero();
    sum.col(angle).setZero();
  }
}

}  // namespace touchstone::sim
