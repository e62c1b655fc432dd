// Contacts as part of an implicit step: what stiff elements need, on which a bare impulse would pump energy.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/system.hpp"

namespace touchstone::sim {

/// With u = sum omega_i (x_i - x_i at the start of the step): 1/2 stiffness min(n . u - goal, 0)^2 along the normal
/// and, across it, friction's dissipation slip * |u_T|, smoothed where |u_T| is less than `stick` (Li et al. 2020).
struct ContactTerm {
  std::array<Index, 4> particles{};
  std::size_t corners = 0;
  std::array<double, 4> omega{};
  Vector3 normal = Vector3::Zero();
  double goal = 0;       ///< m
  double stiffness = 0;  ///< N/m
  double slip = 0;       ///< N: friction's coefficient times the normal force
  double stick = 0;      ///< m
};

/// sum omega_i (x_i - x0_i).
Vector3 relative_motion(const ContactTerm& term, const VectorX& x0, const VectorX& x);

double normal_force(const ContactTerm& term, const VectorX& x0, const VectorX& x);

double contact_value(const ContactTerm& term, const VectorX& x0, const VectorX& x);

/// First and second derivatives with respect to u; the second ones are never negative.
struct ContactDerivatives {
  Vector3 gradient;
  Eigen::Matrix3d hessian;
};
ContactDerivatives contact_derivatives(const ContactTerm& term, const VectorX& x0, const VectorX& x);

}  // namespace touchstone::sim
