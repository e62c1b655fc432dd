// SPDX-License-Identifier: MIT
#include "sim/simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include <touchstone/error.hpp>

#include "sim/state_check.hpp"

namespace touchstone::sim {
namespace {

constexpr int kMostParts = 20'000;    // of a step, refused ones included: 2^24 of them would take for ever
constexpr double kEnergyParts = 100;  // of a step, to which it is cut at most because it would gain energy

Scene checked(Scene scene) {
  check_scene(scene);
  scene.particles.shrink_to_fit();
  return scene;
}

}  // namespace

Simulation::Simulation(Scene scene, const SimulationOptions& options)
    : scene_(checked(std::move(scene))),
      system_(scene_),
      elements_(scene_, system_),
      stepper_(system_, scene_.settings),
      response_(elements_, system_, scene_.settings, options.narrow_phase, options.threads),
      prover_(elements_, NarrowPhase::exact, options.threads),
      narrow_phase_(options.narrow_phase),
      before_part_(options.before_part),
      state_(stepper_.initial()) {
  check_start(state_, "the scene");
}

Simulation::~Simulation() = default;

void Simulation::check_start(const State& state, std::string_view what) {
  const std::vector<Pair> pairs = elements_.candidates(state.q, state.q, 0);
  prover_.contacts(pairs, state.q, state.q, [&](std::size_t i, const Answer&) {
    throw Error(fmt::format("{} begins with elements that touch: {}", what, elements_.describe(pairs[i])));
  });
}

void Simulation::resume(State state, std::uint64_t steps) {
  check_state(scene_, system_, state, steps);
  check_start(state, "q: the checkpoint");
  state_ = std::move(state);
  steps_ = steps;
}

std::vector<StepRecord> Simulation::step() {
  std::optional<State> before;
  const std::size_t crossings_before = crossings_.size();
  ++steps_;
  try {
    return parts_of_step(before);
  } catch (...) {
    // Whatever it is, and whoever threw it: steps are made whole.
    if (before) state_ = std::move(*before);
    crossings_.resize(crossings_before);
    --steps_;
    throw;
  }
}

std::vector<StepRecord> Simulation::parts_of_step(std::optional<State>& before) {
  // Parts are dyadic shares of the step, so that their ends fall on the step's end exactly. A part that is refused is
  // halved; what is left of the step is then tried at once again.
  std::vector<StepRecord> records;
  const auto whole = static_cast<double>(steps_ - 1);
  const RefusedCounts refused_before = refused_;
  Refusal refusal;  // the latest
  const auto why = [&] {
    return fmt::format("({}): {}", refused_for_person(refused_, refused_before),
                       refusal_for_person(refusal, scene_, system_, elements_, state_.q));
  };
  double done = 0, share = 1;
  int halvings = 0, parts = 0;
  while (done < 1) {
    if (before_part_) before_part_();
    const double start = time_at(whole + done), end = time_at(whole + done + share);
    if (++parts > kMostParts) {
      throw Error(fmt::format("step {} cannot be taken: after {} tries of its parts it has come to {:.9g} s {}", steps_,
                              kMostParts, start, why()));
    }
    StepRecord record;
    record.step = steps_;
    if (share < 1 && !before) before = state_;
    const auto tried = try_part(end - start, end, record);
    if (!tried) {
      records.push_back(record);
      done += share;
      while (halvings > 0 && std::fmod(done, 2 * share) == 0) {
        share *= 2;
        --halvings;
      }
      continue;
    }
    refusal = *tried;
    count(refused_, refusal.cause);
    share /= 2;
    if (++halvings > kMostHalvings) {
      throw Error(fmt::format("step {} at {:.9g} s cannot be taken, not even in parts of {:.3g} s {}", steps_, start,
                              end - start, why()));
    }
  }
  return records;
}

std::optional<Refusal> Simulation::try_part(double h, double end_time, StepRecord& record) {
  Advance advance = [&] {
    const PhaseClock clock(times_.integration);
    return stepper_.advance(state_, h);
  }();
  const auto refused = [](Cause cause) {
    Refusal refusal;
    refusal.cause = cause;
    return refusal;
  };
  const auto not_converged = [&](const Mover& mover, bool with_contacts) {
    Refusal refusal = refused(Cause::not_converged);
    refusal.mover = mover;
    refusal.with_contacts = with_contacts;
    return refusal;
  };
  if (!advance.converged) return not_converged(advance.mover, false);
  // Halving helps until steps are as short as what the elements and contacts answer in; after that, the step is better
  // taken than halved for ever.
  const bool may_be_cut = narrow_phase_ == NarrowPhase::exact && h > scene_.settings.time_step / kEnergyParts;
  if (advance.gained_energy && may_be_cut) return refused(Cause::gained_energy);
  record.gained_energy = advance.gained_energy ? 1 : 0;
  State& next = advance.state;
  switch (response_.respond(stepper_, state_, h, next, record.response, times_)) {
    case Response::Outcome::done: break;
    case Response::Outcome::not_converged: return not_converged(response_.trouble().mover, true);
    case Response::Outcome::not_resolved: {
      Refusal refusal = refused(Cause::not_resolved);
      if (const auto& left = response_.trouble().left) {
        refusal.pair = left->pair;
        refusal.place = place_of(*left, state_.q);
      }
      return refusal;
    }
    case Response::Outcome::gained_energy:
      if (may_be_cut) return refused(Cause::gained_energy);
      record.gained_energy = 1;
      break;
  }
  if (!next.q.allFinite() || !next.v.allFinite()) return not_converged({}, false);

  const PhaseClock clock(times_.proof);
  // The proof looks at the positions as they are stored, and finds its own candidates.
  const std::vector<Pair> pairs = elements_.candidates(state_.q, next.q, 0);
  std::vector<Crossing> crossings;
  record.proof.pairs = pairs.size();
  record.proof.levels = prover_.contacts(pairs, state_.q, next.q, [&](std::size_t i, const Answer& answer) {
    crossings.push_back({record.step, state_.time + answer.toi * h, elements_.place(pairs[i], state_.q, next.q, answer),
                         pairs[i], answer});
  });
  record.proof.crossings = crossings.size();
  if (!crossings.empty() && narrow_phase_ == NarrowPhase::exact) {
    Refusal refusal = refused(Cause::not_certified);
    refusal.pair = crossings.front().pair;
    refusal.place = crossings.front().place;
    return refusal;
  }
  crossings_.insert(crossings_.end(), crossings.begin(), crossings.end());

  next.time = end_time;
  state_ = std::move(next);
  record.time = end_time;
  record.length = h;
  record.newton_iterations = advance.iterations + record.response.newton_iterations;
  record.newton_convex = advance.convex;
  record.first_order = advance.first_order ? 1 : 0;
  return std::nullopt;
}

}  // namespace touchstone::sim
