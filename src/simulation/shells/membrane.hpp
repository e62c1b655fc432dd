// The membrane of cloth: constant-strain triangles of a St. Venant-Kirchhoff material in plane stress, and a limit of
// their stretch.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "scene/scene.hpp"

namespace touchstone::sim {

using MembraneVector = Eigen::Matrix<double, 9, 1>;
using MembraneMatrix = Eigen::Matrix<double, 9, 9>;

/// With the deformation gradient F, C = F^T F and the Green strain E = (C - I) / 2, the energy per area is
///   (lambda / 2) tr(E)^2 + mu tr(E^2), lambda and mu those of plane stress times the sheet's thickness.
/// In the strains s = (E_11 + E_22, E_11 - E_22, 2 E_12) it has no mixed terms:
///   stretch / (2 (1 - poisson)) s_1^2 / 2 + stretch / (2 (1 + poisson)) (s_2^2 + s_3^2) / 2.
struct Membrane {
  std::array<Index, 3> p{};
  Eigen::Matrix<double, 3, 2> weights;  ///< 1/m: column a of F is sum_i weights(i, a) x_i
  std::array<double, 3> stiffness{};    ///< J, of each strain
  double damping = 0;                   ///< s
  /// The square of the principal stretch that is never reached; 0: there is no limit. Closer to it than `limit_width`,
  /// a principal stretch has an energy that grows without bound (see limit_energy).
  double limit = 0, limit_width = 0;
  double limit_stiffness = 0;  ///< J
};

/// @returns the element of a triangle that is at rest at x, without stiffness
Membrane membrane_at_rest(const std::array<Index, 3>& p, const std::array<Vector3, 3>& x);

/// The strains of one triangle and their derivatives by x_0, x_1, x_2.
class MembraneStrain {
 public:
  MembraneStrain(const Membrane& membrane, const Vector3& x0, const Vector3& x1, const Vector3& x2);

  Vector3 strains() const noexcept;

  /// Column k is the gradient of strain k.
  Eigen::Matrix<double, 9, 3> gradients() const noexcept;

  /// Adds the sum of stress_k times the second derivatives of strain k. @param projected  without the part in which
  /// compression makes the energy concave
  void add_hessians(const Vector3& stress, bool projected, MembraneMatrix& sum) const;

 private:
  const Membrane* membrane_;
  Vector3 f1_, f2_;  // columns of F
};

/// The largest square of a principal stretch at these strains: the larger eigenvalue of C.
double largest_square_stretch(const Vector3& strains) noexcept;

/// The energy of the limit of stretch: phi(c_1) + phi(c_2), c the eigenvalues of C and, with y = (limit - c) / width,
///   phi = -limit_stiffness (1 - y)^2 ln y for y < 1 and 0 beyond
/// (the barrier of Li, Kaufman and Jiang 2021, "Codimensional incremental potential contact", for stretch). It is
/// twice differentiable and convex in the strains. Infinite at the limit and beyond.
double limit_energy(const Membrane& membrane, const Vector3& strains) noexcept;

struct LimitDerivatives {
  Vector3 gradient = Vector3::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};
/// By the strains, which must be below the limit.
LimitDerivatives limit_derivatives(const Membrane& membrane, const Vector3& strains) noexcept;

}  // namespace touchstone::sim
