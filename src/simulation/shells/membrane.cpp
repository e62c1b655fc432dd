// SPDX-License-Identifier: MIT
#include "shells/membrane.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <limits>

namespace touchstone::sim {
namespace {

/// phi and its derivatives by c.
struct Barrier {
  double first = 0, second = 0;
};

Barrier barrier_at(const Membrane& membrane, double c) noexcept {
  const double w = membrane.limit_width, y = (membrane.limit - c) / w, z = 1 - y, scale = membrane.limit_stiffness / w;
  if (!(y < 1)) return {};
  const double logarithm = std::log(y);
  return {scale * (z * z / y - 2 * z * logarithm), scale / w * (4 * z / y + z * z / (y * y) - 2 * logarithm)};
}

/// The eigenvalues of C are 1 + s_1 + d and 1 + s_1 - d with this d.
double half_difference(const Vector3& strains) noexcept { return std::hypot(strains[1], strains[2]); }

/// S without its negative eigenvalues.
Eigen::Matrix2d positive_part(const Eigen::Matrix2d& s) {
  const double mean = 0.5 * (s(0, 0) + s(1, 1)), half = 0.5 * (s(0, 0) - s(1, 1));
  const double d = std::hypot(half, s(0, 1));
  const double high = mean + d, low = mean - d;
  if (low >= 0) return s;
  if (high <= 0) return Eigen::Matrix2d::Zero();
  // S = high P + low (I - P) with the projection P = (S - low I) / (high - low).
  return high / (high - low) * (s - low * Eigen::Matrix2d::Identity());
}

}  // namespace

Membrane membrane_at_rest(const std::array<Index, 3>& p, const std::array<Vector3, 3>& x) {
  // Coordinates in the triangle's plane.
  const Vector3 u = x[1] - x[0], w = x[2] - x[0];
  const Vector3 along = u.normalized();
  const double across = (w - along.dot(w) * along).norm();
  Eigen::Matrix2d edges;
  edges << u.norm(), along.dot(w), 0, across;
  const Eigen::Matrix2d inverse = edges.inverse();
  Membrane membrane;
  membrane.p = p;
  membrane.weights.row(1) = inverse.row(0);
  membrane.weights.row(2) = inverse.row(1);
  membrane.weights.row(0) = -inverse.row(0) - inverse.row(1);
  return membrane;
}

MembraneStrain::MembraneStrain(const Membrane& membrane, const Vector3& x0, const Vector3& x1, const Vector3& x2)
    : membrane_(&membrane) {
  const auto& b = membrane.weights;
  const Vector3 u = x1 - x0, w = x2 - x0;  // weights sum to zero
  f1_ = b(1, 0) * u + b(2, 0) * w;
  f2_ = b(1, 1) * u + b(2, 1) * w;
}

Vector3 MembraneStrain::strains() const noexcept {
  const double c11 = f1_.squaredNorm(), c22 = f2_.squaredNorm();
  return {0.5 * (c11 + c22) - 1, 0.5 * (c11 - c22), f1_.dot(f2_)};
}

Eigen::Matrix<double, 9, 3> MembraneStrain::gradients() const noexcept {
  Eigen::Matrix<double, 9, 3> all;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double a = membrane_->weights(i, 0), b = membrane_->weights(i, 1);
    all.block<3, 1>(3 * i, 0) = a * f1_ + b * f2_;
    all.block<3, 1>(3 * i, 1) = a * f1_ - b * f2_;
    all.block<3, 1>(3 * i, 2) = a * f2_ + b * f1_;
  }
  return all;
}

void MembraneStrain::add_hessians(const Vector3& stress, bool projected, MembraneMatrix& sum) const {
  // Strains are quadratic, so that their second derivatives are constant: for corners i and j the block is
  // weights_i . S weights_j times the identity, S the second Piola-Kirchhoff stress times the area.
  Eigen::Matrix2d s;
  s << stress[0] + stress[1], stress[2], stress[2], stress[0] - stress[1];
  if (projected) s = positive_part(s);
  const Eigen::Matrix3d by_corner = membrane_->weights * s * membrane_->weights.transpose();
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      for (Eigen::Index k = 0; k < 3; ++k) sum(3 * i + k, 3 * j + k) += by_corner(i, j);
    }
  }
}

double largest_square_stretch(const Vector3& strains) noexcept { return 1 + strains[0] + half_difference(strains); }

double limit_energy(const Membrane& membrane, const Vector3& strains) noexcept {
  const double d = half_difference(strains);
  double sum = 0;
  for (const double c : {1 + strains[0] + d, 1 + strains[0] - d}) {
    const double y = (membrane.limit - c) / membrane.limit_width;
    if (!(y > 0)) return std::numeric_limits<double>::infinity();
    if (y < 1) sum -= membrane.limit_stiffness * (1 - y) * (1 - y) * std::log(y);
  }
  return sum;
}

LimitDerivatives limit_derivatives(const Membrane& membrane, const Vector3& strains) noexcept {
  LimitDerivatives result;
  const double d = half_difference(strains), mean = 1 + strains[0];
  if (!(membrane.limit - mean - d < membrane.limit_width)) return result;
  const Barrier high = barrier_at(membrane, mean + d), low = barrier_at(membrane, mean - d);
  const double sum = high.second + low.second;
  result.gradient[0] = high.first + low.first;
  result.hessian(0, 0) = sum;
  // Beside d = 0 the quotient of differences is the second derivative.
  const bool apart = d > 1e-9 * membrane.limit_width;
  const double turning = apart ? (high.first - low.first) / d : sum;
  const Eigen::Vector2d shear = strains.tail<2>();
  const Eigen::Vector2d along = apart ? Eigen::Vector2d(shear / d) : Eigen::Vector2d::Zero();
  result.gradient.tail<2>() = turning * shear;
  result.hessian.block<2, 1>(1, 0) = (high.second - low.second) * along;
  result.hessian.block<1, 2>(0, 1) = result.hessian.block<2, 1>(1, 0).transpose();
  result.hessian.block<2, 2>(1, 1) =
      turning * Eigen::Matrix2d::Identity() + (sum - turning) * along * along.transpose();
  return result;
}

}  // namespace touchstone::sim
