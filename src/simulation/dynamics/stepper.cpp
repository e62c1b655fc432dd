// SPDX-License-Identifier: MIT
#include "dynamics/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/energy_budget.hpp"
#include "dynamics/rounding.hpp"

namespace touchstone::sim {
namespace {

// Fraction of the scene's step. In substeps that are no longer than this, implicit Euler stands in for a second-order
// method that does not converge; longer ones are halved first.
constexpr double kFirstOrderBelow = 0.125;

// m/s, of Newton's method with contacts: their springs are no more exact than this.
constexpr double kContactTolerance = 1e-3;

// Times the work of driven coordinates that is measured at the substep's end: the second-order methods take their
// forces from all over the substep.
constexpr double kWorkFactor = 2;

}  // namespace

struct Stepper::Solution {
  State state;  // at the stage's end; v is the stage's velocity
  VectorX strain_rate;
};

Stepper::Stepper(const System& system, const Settings& settings, const linear::Cancellation& cancel)
    : system_(&system), settings_(settings), energy_(system), newton_(system, settings, cancel) {}

State Stepper::initial() const {
  State state;
  state.q = system_->initial_position;
  state.v = system_->initial_velocity;
  system_->prescribe(0, state.q);
  state.frames = system_->initial_frames(state.q);
  return state;
}

Advance Stepper::advance(const State& state, double h) {
  Advance advance;
  switch (settings_.integrator) {
    case Integrator::implicit_euler: advance = implicit_euler(state, h); break;
    case Integrator::tr_bdf2: advance = tr_bdf2(state, h); break;
    case Integrator::implicit_midpoint: advance = implicit_midpoint(state, h); break;
    case Integrator::symplectic_euler: advance = symplectic_euler(state, h); break;
  }
  const bool is_explicit = settings_.integrator == Integrator::symplectic_euler;
  const bool second_order =
      settings_.integrator == Integrator::tr_bdf2 || settings_.integrator == Integrator::implicit_midpoint;
  const bool is_short = h <= kFirstOrderBelow * settings_.time_step;
  advance.gained_energy = advance.converged && !is_explicit && gained_energy(state, h, advance.state);
  if (second_order && (advance.converged ? advance.gained_energy : is_short)) {
    const Advance tried = std::move(advance);
    advance = implicit_euler(state, h);
    advance.iterations += tried.iterations;
    advance.projected += tried.projected;
    advance.first_order = true;
    if (advance.converged) advance.gained_energy = gained_energy(state, h, advance.state);
  }
  if (!advance.converged) return advance;
  if (!advance.state.q.allFinite() || !advance.state.v.allFinite()) advance.converged = false;
  return advance;
}

Advance Stepper::advance_in_halves(const State& state, double h) {
  const Advance whole = advance(state, h);
  if (!whole.converged) return whole;
  const Advance first = advance(state, h / 2);
  if (!first.converged) return first;
  Advance second = advance(first.state, h / 2);
  second.iterations += whole.iterations + first.iterations;
  second.projected += whole.projected + first.projected;
  second.first_order = second.first_order || first.first_order;
  second.gained_energy = second.gained_energy || first.gained_energy;
  second.flows += first.flows;
  if (second.converged) second.difference = difference(whole.state, second.state, h);
  return second;
}

int Stepper::order() const noexcept {
  return settings_.integrator == Integrator::tr_bdf2 || settings_.integrator == Integrator::implicit_midpoint ? 2 : 1;
}

double Stepper::difference(const State& a, const State& b, double h) const {
  double most = 0;
  const auto particles = static_cast<Eigen::Index>(3 * system_->particle_count());
  for (Eigen::Index i = 0; i < particles; i += 3) {
    most = std::max(
        most, (a.q.segment<3>(i) - b.q.segment<3>(i)).norm() + h * (a.v.segment<3>(i) - b.v.segment<3>(i)).norm());
  }
  for (Eigen::Index i = particles; i < a.q.size(); ++i) {
    most = std::max(most, kLever * (std::abs(a.q[i] - b.q[i]) + h * std::abs(a.v[i] - b.v[i])));
  }
  return most;
}

void Stepper::finish(const State& before, double h, State& after) const {
  after.time = before.time + h;
  system_->prescribe(after.time, after.q);
  for (Eigen::Index i = 0; i < after.q.size(); ++i) {
    if (!system_->fixed[static_cast<std::size_t>(i)]) continue;
    after.v[i] = (after.q[i] - before.q[i]) / h;
  }
}

VectorX Stepper::acceleration(const State& state) const {
  VectorX gradient = -system_->force;
  energy_.derivatives(state.q, state.frames, state.time, energy_.elastic(), Hessian::projected, gradient, nullptr);
  // The damping force of strain s is -c ds/dt grad s: that of a spring of stiffness c, strained by ds/dt.
  const VectorX strains = energy_.strains(state.q, state.frames, state.time);
  Strains damping{energy_.damped(strains, 1).stiffness - energy_.elastic().stiffness, strains};
  if (damping.stiffness.any()) {
    damping.with_limits = false;  // their force is in the gradient already
    damping.rest -= energy_.strain_rates(state.q, state.v, state.frames, state.time);
    energy_.derivatives(state.q, state.frames, state.time, damping, Hessian::projected, gradient, nullptr);
  }
  VectorX a = VectorX::Zero(state.q.size());
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!system_->fixed[static_cast<std::size_t>(i)])
      a[i] = -gradient[i] / system_->mass[i] - settings_.drag * state.v[i];
  }
  return a;
}

Stepper::Solution Stepper::solve(const State& state, const Stage& stage, const VectorX& guess_velocity,
                                 Advance& advance) {
  VectorX guess = stage.base + stage.span * guess_velocity;
  for (Eigen::Index i = 0; i < guess.size(); ++i) {
    if (system_->fixed[static_cast<std::size_t>(i)]) guess[i] = state.q[i];
  }
  system_->prescribe(stage.time, guess);
  Solution solution;
  solution.state = state;
  const NewtonResult result = newton_.minimise(stage, guess, solution.state.q, solution.state.frames);
  advance.converged = result.converged;
  advance.iterations += result.iterations;
  advance.projected += result.projected;
  advance.largest_change = result.largest_change;
  solution.state.time = stage.time;
  solution.state.v = (solution.state.q - stage.base) / stage.span;
  return solution;
}

/// Of a substep of implicit Euler, whose forces are those at its end.
EnergyFlows Stepper::euler_flows(const State& before, double h, const State& after) const {
  FlowMeter flows = meter(before, h);
  flows.pass(1, before, after);
  flows.drive(1, after, (strains(after) - strains(before)) / h);
  return flows.finish(after);
}

Stage Stepper::euler_stage(const State& state, double h) const {
  return {state.q, state.v, h, state.time + h, energy_.damped(energy_.strains(state.q, state.frames, state.time), h),
          {},      0};
}

Advance Stepper::implicit_euler(const State& state, double h) {
  Advance advance;
  advance.state = solve(state, euler_stage(state, h), state.v, advance).state;
  if (!advance.converged) return advance;
  finish(state, h, advance.state);
  if (measures_flows_) advance.flows = euler_flows(state, h, advance.state);
  return advance;
}

Advance Stepper::advance_with(const State& state, double h, std::span<const ContactTerm> contacts,
                              const VectorX& near) {
  Advance advance;
  Stage stage = euler_stage(state, h);
  stage.contacts = contacts;
  stage.tolerance = kContactTolerance;
  advance.state = solve(state, stage, (near - state.q) / h, advance).state;
  if (!advance.converged) return advance;
  finish(state, h, advance.state);
  advance.converged = advance.state.q.allFinite() && advance.state.v.allFinite();
  if (measures_flows_) advance.flows = euler_flows(state, h, advance.state);
  return advance;
}

bool Stepper::gained_energy(const State& before, double h, const State& after) const {
  State later = before;  // the twist that is inserted into a ring gives energy, which is no gain either
  later.time += h;
  const Energies was = energies(*system_, before), turned = energies(*system_, later), is = energies(*system_, after);
  const double work = kWorkFactor * std::max(driven_work(before, h, {}, after), 0.0);
  return !(is.total() <= std::max(was.total(), turned.total()) + work + energy_tolerance(was, is));
}

double Stepper::driven_work(const State& before, double h, std::span<const ContactTerm> contacts,
                            const State& after) const {
  VectorX moved = VectorX::Zero(after.q.size());
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    if (system_->fixed[static_cast<std::size_t>(i)]) moved[i] = after.q[i] - before.q[i];
  }
  if (moved.isZero(0)) return 0;
  const Stage stage = euler_stage(before, h);
  VectorX pull = system_->mass.cwiseProduct(after.v - before.v) / h - system_->force;
  energy_.derivatives(after.q, after.frames, after.time, stage.strains, Hessian::exact, pull, nullptr);
  double work = pull.dot(moved);
  for (const ContactTerm& term : contacts) {
    const Vector3 against = contact_derivatives(term, before.q, after.q, Vector3::Zero()).gradient;
    work += against.dot(relative_motion(term, moved));
  }
  return work;
}

Advance Stepper::implicit_midpoint(const State& state, double h) {
  // Half a substep of implicit Euler leads to the middle; the end lies as far beyond it.
  Advance advance;
  const Stage stage{state.q,
                    state.v,
                    h / 2,
                    state.time + h / 2,
                    energy_.damped(energy_.strains(state.q, state.frames, state.time), h / 2),
                    {},
                    0};
  const State middle = solve(state, stage, state.v, advance).state;
  if (!advance.converged) return advance;
  advance.state.q = 2 * middle.q - state.q;
  advance.state.v = 2 * middle.v - state.v;
  VectorX q = advance.state.q;
  system_->prescribe(state.time + h, q);
  advance.state.frames = system_->transported(middle.frames, middle.q, q);
  finish(state, h, advance.state);
  if (measures_flows_) {
    FlowMeter flows = meter(state, h);
    flows.pass(1, state, advance.state);
    flows.drive(1, middle, (strains(middle) - strains(state)) / (0.5 * h));
    advance.flows = flows.finish(advance.state);
  }
  return advance;
}

Advance Stepper::tr_bdf2(const State& state, double h) {
  // A trapezoid to t + g h, then the second-order backward difference through t and t + g h. With g = 2 - sqrt 2 both
  // stages have the same span, g / 2 of h.
  const double fraction = 1 - std::sqrt(0.5), weight = std::sqrt(2.0) / 4;
  Advance advance;
  const VectorX a0 = acceleration(state);
  const VectorX s0 = energy_.strains(state.q, state.frames, state.time);
  const VectorX r0 = energy_.strain_rates(state.q, state.v, state.frames, state.time);

  Stage stage;
  stage.span = fraction * h;
  stage.base = state.q + stage.span * state.v;
  stage.base_velocity = state.v + stage.span * a0;
  stage.time = state.time + 2 * fraction * h;
  const VectorX s1_base = s0 + stage.span * r0;
  stage.strains = energy_.damped(s1_base, stage.span);
  const State middle = solve(state, stage, state.v, advance).state;
  if (!advance.converged) return advance;
  const VectorX a1 = (middle.v - stage.base_velocity) / stage.span;
  const VectorX r1 = (energy_.strains(middle.q, middle.frames, middle.time) - s1_base) / stage.span;

  stage.base = state.q + weight * h * (state.v + middle.v);
  stage.base_velocity = state.v + weight * h * (a0 + a1);
  stage.time = state.time + h;
  stage.strains = energy_.damped(s0 + weight * h * (r0 + r1), stage.span);
  advance.state = solve(middle, stage, middle.v, advance).state;
  if (!advance.converged) return advance;
  finish(state, h, advance.state);
  if (measures_flows_) {
    FlowMeter flows = meter(state, h);
    flows.pass(2 * fraction, state, middle);
    flows.pass(1 - 2 * fraction, middle, advance.state);
    // The rates of the two parts, with weights that sum to the parts' lengths.
    const VectorX s1 = strains(middle), s2 = strains(advance.state);
    const VectorX first = (s1 - s0) / (2 * fraction * h), second = (s2 - s1) / ((1 - 2 * fraction) * h);
    flows.drive(weight, state, first);
    flows.drive(weight, middle, ((2 * fraction - weight) * first + (1 - 3 * fraction) * second) / weight);
    flows.drive(fraction, advance.state, second);
    advance.flows = flows.finish(advance.state);
  }
  return advance;
}

Advance Stepper::symplectic_euler(const State& state, double h) {
  Advance advance;
  advance.state.v = state.v + h * acceleration(state);
  advance.state.q = state.q + h * advance.state.v;
  for (Eigen::Index i = 0; i < state.q.size(); ++i) {
    if (system_->fixed[static_cast<std::size_t>(i)]) advance.state.q[i] = state.q[i];
  }
  system_->prescribe(state.time + h, advance.state.q);
  advance.converged = advance.state.q.allFinite();
  if (!advance.converged) return advance;
  advance.state.frames = system_->transported(state.frames, state.q, advance.state.q);
  finish(state, h, advance.state);
  if (measures_flows_) {
    FlowMeter flows = meter(state, h);
    flows.pass(1, state, advance.state);
    flows.drive(1, state, (strains(advance.state) - strains(state)) / h);
    advance.flows = flows.finish(advance.state);
  }
  return advance;
}

}  // namespace touchstone::sim
