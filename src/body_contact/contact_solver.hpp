// The velocities of a substep in which bodies and particles do not approach beyond their gaps: impulses on all contacts
// at once, by projected Gauss-Seidel (Moreau 1999; Catto 2005).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "body_contact/closest.hpp"

namespace touchstone::sim {

/// A contact, what is asked of it and the impulse that answers it, over the substep's length: a force, N.
struct SolverContact {
  BodyContact contact;
  double least = 0;                    ///< m/s: the relative velocity along the normal must not be below it
  double push = 0;                     ///< m/s: so fast the elements are to be moved apart, which adds no velocity
  double normal_impulse = 0;           ///< N s, >= 0
  Vector3 friction = Vector3::Zero();  ///< N s, across the normal
};

/// One body: velocities of its centre and its angular velocity, by which it is displaced in the substep.
struct MovingBody {
  Vector3 velocity = Vector3::Zero(), spin = Vector3::Zero();
  double inverse_mass = 0;
  Matrix3 inverse_inertia = Matrix3::Zero();  ///< in the world's frame

  void apply(const Vector3& impulse, const Vector3& arm) noexcept;
};

/// What impulses act on.
struct Movers {
  std::vector<MovingBody> bodies;
  VectorX particles;     ///< velocities, m/s
  VectorX inverse_mass;  ///< of each coordinate of a particle; 0 where it is held

  Vector3 velocity(const ContactSide& side) const noexcept;
  void apply(const ContactSide& side, const Vector3& impulse) noexcept;
  Matrix3 response(const ContactSide& side) const noexcept;  ///< velocity of the side by an impulse on it
  Vector3 approach(const BodyContact& contact) const noexcept { return velocity(contact.a) - velocity(contact.b); }
};

struct SolverRule {
  double friction = 0;
  double tolerance = 0;  ///< m/s: sweeps end when no relative velocity changes by more
  int sweeps = 0;        ///< at most
};

/// Changes the velocities by impulses. The impulses that the contacts have are applied first.
/// @returns the number of sweeps
int solve_contacts(Movers& movers, std::vector<SolverContact>& contacts, const SolverRule& rule);

/// The same for the velocities that move elements apart, which begin at zero in `movers`.
void solve_pushes(Movers& movers, const std::vector<SolverContact>& contacts, int sweeps);

}  // namespace touchstone::sim
