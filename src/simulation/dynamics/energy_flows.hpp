// The energy that the forces of a substep give and take, contacts left aside.
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/outcome.hpp"
#include "dynamics/state.hpp"
#include "rods/energy.hpp"

namespace touchstone::sim {

/// Adds up the flows of one substep.
class FlowMeter {
 public:
  /// @param system, before  live as long as this  @param drag  1/s  @param h  s
  FlowMeter(const System& system, double drag, const State& before, double h);

  /// The system comes from one state to another, in `length` of the substep. A strain with damping c that changes by ds
  /// in a time dt takes at least c ds^2 / dt. So does drag. The rates in between are not asked: a damper that is stiff
  /// for the substep ends them at once.
  void pass(double length, const State& from, const State& to);

  /// The forces at `at` hold against the driven coordinates for `weight` of the substep. @param rates  of each strain
  void drive(double weight, const State& at, const VectorX& rates);

  /// The flows, with the inertia and loads of the driven coordinates, whose velocities are those of `after`.
  EnergyFlows finish(const State& after);

 private:
  const System* system_;
  Energy energy_;
  double drag_, h_;
  const State* before_;
  Strains elastic_;
  VectorX damping_;  // of each strain
  VectorX moved_;    // by driven coordinates in the substep; 0 for others
  EnergyFlows flows_;
};

}  // namespace touchstone::sim
