// The energy of a state, and how much of it a substep may gain.
// SPDX-License-Identifier: MIT
#pragma once

#include "dynamics/state.hpp"

namespace touchstone::sim {

/// J, by kind. Potential energies of gravity and of the particles' forces are zero at the origin.
struct Energies {
  double kinetic = 0, stretch = 0, bend = 0, twist = 0, load = 0;
  double total() const noexcept { return kinetic + stretch + bend + twist + load; }
};
Energies energies(const System& system, const State& state);

/// The gain, J, between two states of a substep that counts as none: a fraction of the kinetic and stored energy, as
/// the methods may amplify small vibrations, and the rounding of the loads.
double energy_tolerance(const Energies& before, const Energies& after);

}  // namespace touchstone::sim
