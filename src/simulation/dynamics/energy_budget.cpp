// SPDX-License-Identifier: MIT
#include "dynamics/energy_budget.hpp"

#include <algorithm>
#include <cmath>

#include "rods/cloth_energy.hpp"
#include "rods/energy.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

// Fraction of the kinetic and stored energy that a substep may gain. Second-order methods keep the energy of small
// vibrations or take from it, but on stiff elements that turn in a substep they may multiply it. Implicit Euler takes
// from it where the potential is convex, and mostly also where it buckles. The fraction lets pass the gains of either
// on small vibrations, and stops an energy that multiplies.
constexpr double kGain = 2e-3;

// Rounding of the energies, relative to that of the loads, which may be much larger than the others: some thousands of
// epsilon, for sums over many particles. The millijoule stands for loads that are zero.
constexpr double kRounding = 1e-12;
constexpr double kSmallLoad = 1e-3;  // J

}  // namespace

Energies energies(const System& system, const State& state) {
  const Energy energy(system);
  const Strains elastic = energy.elastic();
  const VectorX strain = energy.strains(state.q, state.frames, state.time) - elastic.rest;
  const VectorX stored = 0.5 * elastic.stiffness.cwiseProduct(strain.cwiseProduct(strain));
  Energies e;
  e.kinetic = 0.5 * (system.mass.array() * state.v.array().square()).sum();
  const auto lengths = static_cast<Eigen::Index>(system.stretch_elements.size());
  e.stretch = stored.head(lengths).sum();
  const auto cloth = static_cast<Eigen::Index>(system.membrane_row(0));
  for (Eigen::Index i = lengths; i < cloth; i += 3) {
    e.bend += stored[i] + stored[i + 1];
    e.twist += stored[i + 2];
  }
  if (kCloth && stored.size() > cloth) {
    const auto hinges = static_cast<Eigen::Index>(system.hinge_row(0));
    e.stretch += stored.segment(cloth, hinges - cloth).sum() +
                 stretch_limit_energy(system, energy.strains(state.q, state.frames, state.time));
    e.bend += stored.tail(stored.size() - hinges).sum();
  }
  e.load = -system.force.dot(state.q);
  return e;
}

double energy_tolerance(const Energies& before, const Energies& after) {
  return kGain * std::max(before.total() - before.load, after.total() - after.load) +
         kRounding * (std::abs(before.load) + kSmallLoad);
}

}  // namespace touchstone::sim
