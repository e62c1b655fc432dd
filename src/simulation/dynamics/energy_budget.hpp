// The energy of a state, and how much of it a substep may gain.
// SPDX-License-Identifier: MIT
#pragma once

#include "dynamics/state.hpp"
#include "rods/energy.hpp"

namespace touchstone::sim {

Energies energies(const System& system, const State& state);

/// The gain, J, between two states of a substep that counts as none: a fraction of the kinetic and stored energy, as
/// the methods may amplify small vibrations, and the rounding of the loads.
double energy_tolerance(const Energies& before, const Energies& after);

}  // namespace touchstone::sim
