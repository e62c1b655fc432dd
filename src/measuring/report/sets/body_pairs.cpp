// SPDX-License-Identifier: MIT
#include "report/sets/body_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <touchstone/curved.hpp>

#include "bodies/spin.hpp"
#include "families/curved_parts.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/simulated_bodies.hpp"
#include "sim/simulation.hpp"

namespace touchstone::report {
namespace {

using sim::BodyStates;
using sim::Colliders;
using sim::Pair;
using sim::SceneMotion;

/// A scene without particles, after how many steps its bodies are near each other, and how many steps lie between two
/// whose pairs are taken.
struct BodyPlan {
  sim::Index size;
  std::size_t before, every;
};
constexpr std::array<BodyPlan, 2> kPlans{{{50, 100, 5}, {36, 10, 1}}};  // of kBodyScenes

constexpr std::size_t kMostSamples = 100;  // steps of which the pairs are taken
constexpr std::size_t kPairsPerSample = 10;
constexpr std::size_t kMissesPerHit = 100;
constexpr int kMostDoublings = 9;  // of the time in which bodies move on freely

/// The states h seconds later, when bodies meet nothing; false when one turns too far.
bool move_freely(const sim::BodySystem& system, double h, BodyStates& states) {
  const BodyStates from = states;
  system.accelerate(states, h);
  constexpr double kMostTurn = 1;  // rad, as in a simulation
  if (system.most_turn(states, h) > kMostTurn) return false;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const sim::RigidBody& body = system.bodies()[i];
    if (!body.is_free()) continue;
    sim::BodyState& to = states[i];
    to.pose.p = from[i].pose.p + 0.5 * h * (from[i].velocity + to.velocity);
    to.pose.q = sim::free_spin(body.inertia, from[i].pose.q, to.momentum, h);
    if (sim::dot(to.pose.q, from[i].pose.q) < 0) to.pose.q = sim::negated(to.pose.q);
  }
  return true;
}

/// The pairs of one scene, by kind.
class Collected {
 public:
  Collected(std::string_view scene, const BodyPairOptions& options) : options_(options) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      QuerySet& set = sets_[static_cast<std::size_t>(kind)];
      set.name = std::string(scene) + "/" + std::string(name_of(kind));
      set.about = "Candidate pairs of the scene " + std::string(scene) +
                  " of touchstone simulate; one in a hundred touches, when nothing keeps it apart";
      set.kind = kind;
    }
  }

  /// Those of a step that was taken.
  void add_taken(const Colliders& colliders, const SceneMotion& motion) {
    const std::vector<Pair> pairs = colliders.body_candidates(motion, options_.separation);
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      std::vector<CurvedQuery> queries;
      for (const Pair& pair : pairs) {
        if (pair.kind == kind) queries.push_back(colliders.query(pair, motion));
      }
      taken_[static_cast<std::size_t>(kind)] += add(kind, queries, (options_.count + samples() - 1) / samples());
    }
  }

  std::size_t samples() const { return std::clamp<std::size_t>(options_.count / kPairsPerSample, 1, kMostSamples); }

  /// Pairs that touch when the bodies move on freely from these states.
  void add_touching(const Colliders& colliders, const BodyStates& states, double step, const sim::VectorX& x) {
    for (int doublings = 0; doublings <= kMostDoublings; ++doublings) {
      BodyStates end = states;
      if (!move_freely(colliders.bodies(), std::ldexp(step, doublings), end)) return;
      const SceneMotion motion{&x, &x, &states, &end};
      if (add_those_that_touch(colliders, motion)) return;
    }
  }

  std::vector<QuerySet> take() {
    std::vector<QuerySet> sets;
    for (QuerySet& set : sets_) {
      if (set.size() > 0) sets.push_back(std::move(set));
    }
    return sets;
  }

 private:
  bool add_those_that_touch(const Colliders& colliders, const SceneMotion& motion) {
    std::array<std::vector<CurvedQuery>, 2> touching;
    for (const Pair& pair : colliders.body_candidates(motion, options_.separation)) {
      const CurvedQuery query = colliders.query(pair, motion);
      if (solve(query, {.separation = Separation{options_.separation}, .wanted = Wanted::contact}).contact)
        touching[static_cast<std::size_t>(pair.kind)].push_back(query);
    }
    bool any = false;
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      const auto k = static_cast<std::size_t>(kind);
      any = any || !touching[k].empty();
      const std::size_t target = (taken_[k] + kMissesPerHit - 1) / kMissesPerHit;
      if (target > touching_[k]) touching_[k] += add(kind, touching[k], target - touching_[k]);
    }
    return any;
  }

  /// Adds at most so many of them, evenly spread. @returns how many
  std::size_t add(Kind kind, const std::vector<CurvedQuery>& queries, std::size_t most) {
    const std::size_t stride = std::max<std::size_t>(1, (queries.size() + most - 1) / most);
    std::vector<CurvedQuery>& all = sets_[static_cast<std::size_t>(kind)].curved;
    const std::size_t before = all.size();
    for (std::size_t i = 0; i < queries.size(); i += stride) all.push_back(queries[i]);
    return all.size() - before;
  }

  const BodyPairOptions& options_;
  std::array<QuerySet, 2> sets_;  // by kind, as those below
  std::array<std::size_t, 2> taken_{}, touching_{};
};

}  // namespace

std::vector<QuerySet> body_pair_sets(std::string_view scene, const BodyPairOptions& options, const BodyPulse& pulse) {
  const auto number = std::find(kBodyScenes.begin(), kBodyScenes.end(), scene) - kBodyScenes.begin();
  const BodyPlan& plan = kPlans.at(static_cast<std::size_t>(number));
  sim::Simulation simulation(sim::make_shipped_scene(scene, plan.size), {});
  const sim::SimulatedBodies& bodies = *simulation.bodies();
  const sim::VectorX none;  // the scene has no particles
  Collected pairs(scene, options);
  for (std::size_t i = 0; i < plan.before; ++i) {
    pulse();
    simulation.step();
  }
  for (std::size_t sample = 0; sample < pairs.samples(); ++sample) {
    for (std::size_t i = 1; i < plan.every; ++i) {
      pulse();
      simulation.step();
    }
    const BodyStates start = bodies.state().bodies;
    simulation.step();
    pairs.add_taken(simulation.colliders(), {&none, &none, &start, &bodies.state().bodies});
    pairs.add_touching(simulation.colliders(), start, simulation.scene().settings.time_step, none);
  }
  return pairs.take();
}

Query straight_twin(const CurvedQuery& query) {
  Query twin;
  twin.kind = query.kind;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    twin.start[i] = families::position(query, i, 0);
    twin.end[i] = families::position(query, i, 1);
  }
  return twin;
}

}  // namespace touchstone::report
