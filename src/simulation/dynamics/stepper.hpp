// One substep of the equations of motion, by the integrator of the scene.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "dynamics/energy_flows.hpp"
#include "dynamics/islands.hpp"
#include "dynamics/state.hpp"

namespace touchstone::sim {

struct Advance {
  bool converged = false;
  State state;                 ///< at the end of the step, when it converged
  int iterations = 0;          ///< of Newton's method, over all stages
  int projected = 0;           ///< of these, with second derivatives made positive
  bool first_order = false;    ///< by implicit Euler, where the scene's own method gains energy or does not converge
  bool gained_energy = false;  ///< more than its tolerance and the work of driven coordinates; never for explicit ones
  LargestChange largest_change;  ///< when it did not converge
  EnergyFlows flows;             ///< when it converged, of a stepper that measures them
  /// Of advance_in_halves, when it converged: m, how far from a whole substep's end any particle is at the end, or a
  /// substep later with the velocities there. Angles count with a lever of a centimetre.
  double difference = 0;
};

class Stepper {
 public:
  /// @param cancel  is checked in each iteration of Newton's method, and lives as long as this
  Stepper(const System& system, const Settings& settings,
          const linear::Cancellation& cancel = linear::Cancellation::never());

  /// Measures the flows of energy from now on.
  void measure_flows() noexcept { measures_flows_ = true; }

  /// The scene at time 0.
  State initial() const;

  /// `state` moved on by h seconds. Not converged: the step is too long for it; `advance.state` means nothing.
  Advance advance(const State& state, double h);

  /// The same in two halves, compared with a whole substep. The halves make an error of about difference / (2^p - 1), p
  /// = order().
  Advance advance_in_halves(const State& state, double h);

  /// Of the scene's method: a substep of h has an error of h^(order + 1).
  int order() const noexcept;

  /// The same by implicit Euler with contacts in its potential, whatever the scene's integrator is. `near` is the first
  /// iterate.
  Advance advance_with(const State& state, double h, std::span<const ContactTerm> contacts, const VectorX& near);

  /// The work, J, of driven coordinates in a substep of implicit Euler with contacts: the forces that move them against
  /// their inertia and loads, springs and contacts, times their displacements. The substep gains no more energy than
  /// this.
  double driven_work(const State& before, double h, std::span<const ContactTerm> contacts, const State& after) const;

  /// The acceleration at this state; zero in fixed coordinates.
  VectorX acceleration(const State& state) const;

 private:
  struct Solution;
  Solution solve(const State& state, const Stage& stage, const VectorX& guess_velocity, Advance& advance);
  Stage euler_stage(const State& state, double h) const;
  Advance implicit_euler(const State& state, double h);
  Advance implicit_midpoint(const State& state, double h);
  Advance tr_bdf2(const State& state, double h);
  Advance symplectic_euler(const State& state, double h);
  double difference(const State& a, const State& b, double h) const;
  bool gained_energy(const State& before, double h, const State& after) const;
  void finish(const State& before, double h, State& after) const;
  FlowMeter meter(const State& before, double h) const { return {*system_, settings_.drag, before, h}; }
  VectorX strains(const State& at) const { return energy_.strains(at.q, at.frames, at.time); }
  EnergyFlows euler_flows(const State& before, double h, const State& after) const;

  const System* system_;
  Settings settings_;
  Energy energy_;
  Islands newton_;
  bool measures_flows_ = false;
};

}  // namespace touchstone::sim
