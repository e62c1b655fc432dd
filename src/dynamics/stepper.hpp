// One step of the equations of motion, contacts left aside.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "dynamics/islands.hpp"

namespace touchstone::sim {

struct State {
  double time = 0;  ///< s
  VectorX q, v;     ///< m and m/s; rad and rad/s for angles
  Frames frames;    ///< of q
};

struct Advance {
  bool converged = false;
  State state;                 ///< at the end of the step, when it converged
  int iterations = 0;          ///< of Newton's method, over all stages
  int convex = 0;              ///< of these, with second derivatives made positive
  bool first_order = false;    ///< by implicit Euler, where the scene's own method gains energy or does not converge
  bool gained_energy = false;  ///< more than a little, and than driven coordinates gave; not told of explicit steps
  Mover mover;                 ///< when it did not converge
};

class Stepper {
 public:
  Stepper(const System& system, const Settings& settings);

  /// The scene at time 0.
  State initial() const;

  /// `state` moved on by h seconds. Not converged: the step is too long for it; `advance.state` means nothing.
  Advance advance(const State& state, double h);

  /// One step of implicit Euler with contacts in its potential, whatever the scene's integrator is. It begins to
  /// search at `near`.
  Advance advance_with(const State& state, double h, std::span<const ContactTerm> contacts, const VectorX& near);

  /// The work, J, that driven coordinates do in a step of implicit Euler with contacts: what moves them, against
  /// their own inertia and loads, springs and contacts, times how far. The step gains no more energy than this.
  double driven_work(const State& before, double h, std::span<const ContactTerm> contacts, const State& after) const;

  /// What acts at this state, over mass: zero in fixed coordinates.
  VectorX acceleration(const State& state) const;

 private:
  struct Solution;
  Solution solve(const State& state, const Stage& stage, const VectorX& guess_velocity, Advance& advance);
  Stage euler_stage(const State& state, double h) const;
  Advance implicit_euler(const State& state, double h);
  Advance implicit_midpoint(const State& state, double h);
  Advance tr_bdf2(const State& state, double h);
  Advance symplectic_euler(const State& state, double h);
  bool gained_energy(const State& before, double h, const State& after) const;
  void finish(const State& before, double h, State& after) const;

  const System* system_;
  Settings settings_;
  Energy energy_;
  Islands newton_;
};

/// J, by where they are. Potential energies of gravity and of the particles' forces are zero at the origin.
struct Energies {
  double kinetic = 0, stretch = 0, bend = 0, twist = 0, load = 0;
  double total() const noexcept { return kinetic + stretch + bend + twist + load; }
};
Energies energies(const System& system, const State& state);

}  // namespace touchstone::sim
