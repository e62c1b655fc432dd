// Contacts as terms of the potential of an implicit step. Stiff elements need them, as bare impulses pump energy into
// those.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "rods/system.hpp"

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

/// sum omega_i x_i.
Vector3 relative_motion(const ContactTerm& term, const VectorX& x);

/// sum omega_i (x_i - x0_i).
Vector3 relative_motion(const ContactTerm& term, const VectorX& x0, const VectorX& x);

double normal_force(const ContactTerm& term, const VectorX& x0, const VectorX& x);

double contact_value(const ContactTerm& term, const VectorX& x0, const VectorX& x);

/// Friction over `slip` at x: along the slip, across the normal, never longer than 1.
Vector3 friction_pull(const ContactTerm& term, const VectorX& x0, const VectorX& x);

/// The first derivative with respect to u, and a second one that is never negative. Friction bends so sharply at rest
/// that Newton's method with the exact second derivative turns back at one contact or another in every iteration, and
/// creeps. So `pull` is a variable of its own, which meets friction_pull at the solution only (Chan, Golub and Mulet
/// 1999, for total variation, which has the same corner). Where the two agree, the second derivative is exact.
struct ContactDerivatives {
  Vector3 gradient;
  Eigen::Matrix3d hessian;
};
ContactDerivatives contact_derivatives(const ContactTerm& term, const VectorX& x0, const VectorX& x,
                                       const Vector3& pull);

/// `pull` after a step of `step_length` of Newton's direction, which moves u by `step_length` times `du` from x.
Vector3 next_pull(const ContactTerm& term, const VectorX& x0, const VectorX& x, const Vector3& pull, const Vector3& du,
                  double step_length);

}  // namespace touchstone::sim
