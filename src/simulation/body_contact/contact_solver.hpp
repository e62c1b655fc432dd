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
  double room = 0;                     ///< m: what the gap has beyond the distance that is kept
  double extra = 0;                    ///< m/s, added to `least` where that was not enough
  double push = 0;                     ///< m/s: so fast the elements are to be moved apart, which adds no velocity
  double correction = 0;               ///< N s: the impulse of that
  double normal_impulse = 0;           ///< N s, >= 0
  Vector3 friction = Vector3::Zero();  ///< N s, across the normal
  Vector3 bounce = Vector3::Zero();    ///< N s: of impacts with restitution, in all directions

  Vector3 impulse() const { return normal_impulse * contact.normal + friction + bounce; }  ///< N s, of a
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

struct BounceRule {
  double restitution = 0;
  double h = 0;        ///< s: the substep
  double resting = 0;  ///< m/s: a slower approach does not bounce
  SolverRule solver;
};

/// The impacts of the substep in the order of their times: of the contacts whose room is used up, the first ones bounce
/// with the velocities that they have at that time, then the next ones with the velocities that this leaves. Contacts
/// within a sixteenth of the substep are one impact, so that a face that lands on its corners does not tilt.
/// @returns the number of sweeps
int bounce(Movers& movers, std::vector<SolverContact>& contacts, const BounceRule& rule);

/// As solve_contacts, for the velocities that move elements apart, which begin at zero in `movers`.
void solve_pushes(Movers& movers, std::vector<SolverContact>& contacts, int sweeps);

}  // namespace touchstone::sim
