// SPDX-License-Identifier: MIT
#include "sim/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <touchstone/error.hpp>

#include "rods/cloth_energy.hpp"
#include "scene/features.hpp"
#include "sim/state_check.hpp"
#include "sim/step_limits.hpp"

namespace touchstone::sim {
namespace {

/// Rigid bodies. As in scene/features.hpp, tests/cost compares with a build without them; only this file asks.
#ifdef TOUCHSTONE_SIM_WITHOUT_BODIES
constexpr bool kBodies = false;
#else
constexpr bool kBodies = true;
#endif

// Substeps of a step, refused ones included: 2^24 of them would take for ever.
constexpr int kMostSubsteps = 20'000;

// A gain of energy halves a step into at most about so many substeps. Halving helps until substeps are as short as the
// times in which the elements and contacts answer; a shorter one is better taken than halved for ever.
constexpr double kMostSubstepsForEnergy = 100;

// The same for what bodies store in springs, cables and cloth when they push particles. Fewer: the stiff ones answer in
// times that are shorter than any substep.
constexpr double kMostSubstepsForStrains = 8;

// The error that a substep may make, over what the tolerance allows, is estimated by steps of two lengths. At times in
// which an error passes through zero, the estimate is too low for the whole motion: so it counts for more.
constexpr double kErrorSafety = 4;

// A longer substep is tried when the error of the one before promises that it will do.
constexpr double kPromise = 0.8;

// A substep that is too inaccurate is cut into at most 2^6 at once: the estimate may be far off.
constexpr int kMostHalvingsAtOnce = 6;

// Fraction of the step: the default of the least substep that a tolerance asks for.
constexpr double kLeastOfStep = 1.0 / 1024;

std::vector<double> waypoint_times(const Scene& scene) {
  std::vector<double> times;
  for (const Particle& particle : scene.particles) {
    for (const Waypoint& point : particle.path) times.push_back(point.time);
  }
  for (const Body& body : scene.bodies) {
    for (const BodyWaypoint& point : body.path) times.push_back(point.time);
  }
  std::sort(times.begin(), times.end());
  return times;
}

Scene checked(Scene scene) {
  check_scene(scene);
  scene.particles.shrink_to_fit();
  return scene;
}

}  // namespace

Simulation::Simulation(Scene scene, const SimulationOptions& options)
    : cancel_(options.check_cancelled),
      scene_(checked(std::move(scene))),
      system_(scene_),
      colliders_(scene_, system_, options.narrow_phase == NarrowPhase::exact ? Keep::separations : Keep::contact),
      stepper_(system_, scene_.settings, cancel_),
      response_(colliders_, system_, scene_.settings, options.narrow_phase, options.threads, stepper_, cancel_),
      prover_(colliders_, NarrowPhase::exact, options.threads, cancel_),
      narrow_phase_(options.narrow_phase),
      threads_(options.threads),
      keep_ends_(options.keep_ends),
      measures_flows_(options.measure_flows),
      keeps_contacts_(options.keep_contacts),
      ignores_radii_(options.narrow_phase == NarrowPhase::paper && has_radii(scene_)),
      waypoints_(waypoint_times(scene_)),
      state_(stepper_.initial()) {
  if (measures_flows_) {
    stepper_.measure_flows();
    response_.measure_flows();
  }
  if (!scene_.bodies.empty()) {
    if (narrow_phase_ == NarrowPhase::paper) {
      throw Error("bodies: the narrow phase of the paper knows no motion that turns; the exact one would be right");
    }
    bodies_ = std::make_unique<SimulatedBodies>(scene_, system_, colliders_, cancel_);
    bodies_->check_start(bodies_->state(), state_.q, "the scene");
    if (keeps_contacts_) bodies_->keep_contacts();
  }
  if (keeps_contacts_) response_.keep_contacts();
  start_ = check_start(state_, bodies_ ? bodies_->state().bodies : BodyStates(), "the scene");
}

Simulation::~Simulation() = default;

StartFindings Simulation::check_start(const State& state, const BodyStates& bodies, std::string_view what) {
  const std::vector<Pair> pairs = colliders_.candidates(state.q, state.q, 0);
  prover_.contacts(pairs, {&state.q, &state.q}, [&](std::size_t i, const Answer&) {
    const Pair& pair = pairs[i];
    const double separation = colliders_.separation(pair);
    if (separation == 0) {
      throw Error(fmt::format("{} begins with elements that touch: {}", what, colliders_.describe(pair)));
    }
    throw Error(fmt::format(
        "{} begins with elements that are too near: {} are {:.9g} m apart, and their radii ask for more than {:.9g} m; "
        "smaller radii, or elements farther apart, would be right",
        what, colliders_.describe(pair), colliders_.distance(pair, state.q), separation));
  });
  cancel_.check();
  return check_no_intersection(colliders_, state.q, bodies, what, threads_);
}

Vector3 Simulation::position_of(Index vertex) const {
  static const BodyStates none;
  return colliders_.at(vertex, state_.q, bodies_ ? bodies_->state().bodies : none);
}

Energies Simulation::energies() const {
  Energies sum = sim::energies(system_, state_);
  if (bodies_) {
    const Energies of_bodies = bodies_->energies();
    sum.kinetic += of_bodies.kinetic;
    sum.load += of_bodies.load;
  }
  return sum;
}

void Simulation::resume(State state, std::uint64_t steps, BodiesState bodies) {
  check_state(scene_, system_, state, steps);
  if (kCloth && !within_stretch_limits(system_, state.q))
    throw Error("q: the checkpoint's cloth is stretched to its strain_limit or beyond, which no run reaches");
  if (bodies_) {
    bodies_->check_state(bodies, state.time);
    bodies_->check_start(bodies, state.q, "the checkpoint");
  }
  start_ = check_start(state, bodies.bodies, bodies_ ? "the checkpoint" : "q: the checkpoint");
  if (bodies_) bodies_->take(std::move(bodies));
  state_ = std::move(state);
  steps_ = steps;
}

std::vector<SubstepRecord> Simulation::step() {
  std::optional<State> before;
  const std::optional<BodiesState> bodies_before = kBodies && bodies_ ? std::optional(bodies_->state()) : std::nullopt;
  const std::size_t crossings_before = crossings_.size();
  ++steps_;
  try {
    return make_substeps(before);
  } catch (...) {
    // A step is made as a whole or not at all, whatever the exception.
    if (before) state_ = std::move(*before);
    if (bodies_before) bodies_->take(*bodies_before);
    crossings_.resize(crossings_before);
    --steps_;
    throw;
  }
}

std::vector<SubstepRecord> Simulation::make_substeps(std::optional<State>& before) {
  // Substeps are dyadic fractions of the step, so that their ends fall on the step's end exactly. A substep that is
  // refused is halved. Once the halves of a longer one are made, the next one is as long again.
  std::vector<SubstepRecord> records;
  std::size_t passed_waypoints = 0;
  const auto whole = static_cast<double>(steps_ - 1);
  const RefusedCounts refused_before = refused_;
  Refusal refusal;  // the latest
  const auto why = [&] {
    return fmt::format("({}): {}", refused_for_person(refused_, refused_before),
                       refusal_for_person(refusal, scene_, system_, colliders_, state_.q));
  };
  const double growth = std::ldexp(1.0, stepper_.order());  // of the error a second in a substep of twice the length
  double done = 0, fraction = 1;
  int halvings = 0, tries = 0;
  while (done < 1) {
    cancel_.check();
    const double start = time_at(whole + done), end = time_at(whole + done + fraction);
    if (++tries > kMostSubsteps) {
      throw Error(fmt::format("step {} cannot be taken: after {} tries of its parts it has come to {:.9g} s {}", steps_,
                              kMostSubsteps, start, why()));
    }
    if (fraction < 1 && !before) before = state_;
    const auto tried = try_substep(end - start, end);
    if (const auto* const record = std::get_if<SubstepRecord>(&tried)) {
      records.push_back(*record);
      passed_waypoints += waypoints_between(start, end);
      done += fraction;
      double excess = record->excess * growth;
      while (halvings > 0 && excess <= kPromise && std::fmod(done, 2 * fraction) == 0) {
        fraction *= 2;
        --halvings;
        excess *= growth;
      }
      continue;
    }
    refusal = std::get<Refusal>(tried);
    ++refused_[static_cast<std::size_t>(refusal.cause)];
    fraction /= 2;
    ++halvings;
    if (refusal.cause == Cause::inaccurate) {
      const int most = halvings + kMostHalvingsAtOnce - 1;
      for (double excess = refusal.excess / growth;
           excess > 1 && halvings < most && !is_least(fraction * scene_.settings.time_step); excess /= growth) {
        fraction /= 2;
        ++halvings;
      }
    }
    if (halvings > kMostHalvings) {
      throw Error(fmt::format("step {} at {:.9g} s cannot be taken, not even in parts of {:.3g} s {}", steps_, start,
                              end - start, why()));
    }
  }
  passed_waypoints_ += passed_waypoints;
  return records;
}

std::size_t Simulation::waypoints_between(double start, double end) const noexcept {
  // The end of a substep is a rounded product, and a waypoint's time a rounded decimal number.
  const double room = 0x1p-40 * end;
  const auto first = std::upper_bound(waypoints_.begin(), waypoints_.end(), start + room);
  const auto last = std::lower_bound(waypoints_.begin(), waypoints_.end(), end - room);
  return first < last ? static_cast<std::size_t>(last - first) : 0;
}

std::variant<SubstepRecord, Refusal> Simulation::try_substep(double h, double end_time) {
  double excess = 0;
  Advance advance = integrate(h, excess);
  if (!advance.converged) return Refusal{.largest_change = advance.largest_change};
  const bool may_be_halved =
      narrow_phase_ == NarrowPhase::exact && h > scene_.settings.time_step / kMostSubstepsForEnergy;
  if (advance.gained_energy && may_be_halved) return Refusal{Cause::gained_energy};

  if (excess > 1 && !is_least(h)) {
    return Refusal{.cause = Cause::inaccurate, .excess = excess};
  }

  ResponseResult response = response_.respond({&state_, h, std::move(advance.state), advance.flows});
  times_ += response.times;
  // A gain of energy is let pass in a substep that is too short to be halved again.
  const auto stands = [&](const std::optional<Refusal>& refused) {
    return refused && (refused->cause != Cause::gained_energy || may_be_halved);
  };
  if (stands(response.refused)) return *response.refused;
  bool contacts_gained = response.refused.has_value();
  State& next = response.end;
  if (!next.q.allFinite() || !next.v.allFinite()) return Refusal{Cause::not_converged};

  BodyResult bodies;
  if (kBodies && bodies_) {
    // Bodies that do not come apart in a short substep are merged for it.
    const bool may_merge = h <= scene_.settings.time_step / kMostSubstepsForEnergy;
    bodies = bodies_->step(state_, h, end_time, may_merge, system_, next);
    times_ += bodies.times;
    if (stands(bodies.refused)) return *bodies.refused;
    if (bodies.strains_gain && h > scene_.settings.time_step / kMostSubstepsForStrains) {
      return Refusal{Cause::gained_energy};
    }
    contacts_gained |= bodies.refused.has_value() || bodies.strains_gain;
  }
  if (kCloth && !within_stretch_limits(system_, next.q)) return Refusal{Cause::overstretched};

  std::vector<Crossing> crossings;
  const StepProof proof = prove(next, h, crossings);
  if (!crossings.empty() && narrow_phase_ == NarrowPhase::exact) {
    return Refusal{Cause::not_certified, crossings.front().pair, crossings.front().point};
  }
  crossings_.insert(crossings_.end(), crossings.begin(), crossings.end());
  next.time = end_time;
  SubstepRecord record;
  const double energy_before = measures_flows_ ? energies().total() : 0;
  state_ = std::move(next);
  if (kBodies && bodies_) bodies_->take(std::move(bodies.end));
  if (measures_flows_) {
    record.flows = response.flows;
    record.flows += bodies.flows;
    record.numerical = energies().total() - energy_before - record.flows.total();
  }
  record.step = steps_;
  record.time = end_time;
  record.length = h;
  record.newton_iterations = advance.iterations + response.counts.newton_iterations;
  record.newton_projected = advance.projected;
  record.first_order = advance.first_order ? 1 : 0;
  record.gained_energy = advance.gained_energy || contacts_gained ? 1 : 0;
  record.excess = excess;
  record.response = response.counts;
  record.proof = proof;
  if (kBodies && bodies_) {
    record.bodies = bodies.counts;
    record.proof.separations += bodies.counts.separations;
  }
  if (keep_ends_) record.end = state_.q;
  if (kBodies && bodies_ && keep_ends_) record.end_bodies = bodies_->state().bodies;
  for (const Contact& c : response.contacts) {
    record.contacts.push_back({c.pair, c.time > 0, c.time, sim::contact_point(c, state_.q)});
  }
  for (const BodyContact& c : bodies.contacts) record.contacts.push_back({c.pair, c.at_touch, 1, c.point});
  std::stable_sort(record.contacts.begin(), record.contacts.end(),
                   [](const ContactMark& a, const ContactMark& b) { return a.time < b.time; });
  return record;
}

Advance Simulation::integrate(double h, double& excess) {
  const PhaseClock clock(times_.integration);
  const double tolerance = scene_.settings.tolerance;
  if (tolerance == 0) return stepper_.advance(state_, h);
  Advance advance = stepper_.advance_in_halves(state_, h);
  const double error = kErrorSafety * advance.difference / (std::ldexp(1.0, stepper_.order()) - 1);
  excess = error / (tolerance * h);
  return advance;
}

bool Simulation::is_least(double h) const noexcept {
  const Settings& settings = scene_.settings;
  const double least = settings.least_step > 0 ? settings.least_step : kLeastOfStep * settings.time_step;
  return h < 2 * least * (1 - 1e-9);  // substeps are rounded
}

/// Looks at the positions as they are stored, and finds its own candidates.
StepProof Simulation::prove(const State& end, double h, std::vector<Crossing>& crossings) {
  const PhaseClock clock(times_.proof);
  const std::vector<Pair> pairs = colliders_.candidates(state_.q, end.q, 0);
  StepProof proof;
  proof.pairs = pairs.size();
  proof.separations = separations_of(colliders_, pairs);
  proof.levels = prover_.contacts(pairs, {&state_.q, &end.q}, [&](std::size_t i, const Answer& answer) {
    crossings.push_back({steps_, state_.time + answer.toi * h,
                         colliders_.contact_point(pairs[i], state_.q, end.q, answer), pairs[i],
                         colliders_.query(pairs[i], state_.q, end.q), answer});
  });
  proof.crossings = crossings.size();
  return proof;
}

}  // namespace touchstone::sim
