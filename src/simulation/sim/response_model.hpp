// The scene as the response to contacts sees it: masses, stiffnesses, and the speed of position corrections.
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/colliders.hpp"
#include "contact/contact.hpp"

namespace touchstone::sim {

class ResponseModel {
 public:
  ResponseModel(const Colliders& colliders, const System& system, const Settings& settings);

  const Colliders& colliders() const noexcept { return *colliders_; }
  const System& system() const noexcept { return *system_; }
  const ContactSettings& contact() const noexcept { return contact_; }

  /// m: elements may come as near as this.
  double thickness() const noexcept { return thickness_; }

  /// 1/kg, of each coordinate of a particle; 0 where it is held.
  const VectorX& inverse_mass() const noexcept { return inverse_mass_; }

  /// The greatest inverse mass of a particle in any direction, 1/kg.
  double inverse_mass(Index particle) const;

  /// Whether all coordinates of the particle are prescribed.
  bool is_held(Index particle) const;

  /// Whether the springs of the contact's particles, or their dampers, answer within h seconds.
  bool is_stiff(const Contact& contact, double h) const;

  ImpulseRule impulse_rule(double h) const;

  /// m: an approach of no more than this in h seconds is that of elements at rest, and does not bounce.
  double resting_approach(double h) const;

  /// How far elements in a contact of the potential, `missing` m nearer than the thickness, move apart in h seconds, m.
  double position_correction(double missing, double h) const;

 private:
  double recovery(double h) const;

  const Colliders* colliders_;
  const System* system_;
  ContactSettings contact_;
  double gravity_;  // m/s^2
  double time_step_;
  double thickness_;
  VectorX inverse_mass_;
  VectorX stiffness_, damping_;  // of the springs of each particle, N/m and N s/m
};

}  // namespace touchstone::sim
