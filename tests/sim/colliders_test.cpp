// The pairs that the colliders find, against the pairs among all elements.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <set>

#include <touchstone/solve.hpp>

#include "scene/shipped_scenes.hpp"
#include "seeded/rng.hpp"
#include "sim/all_pairs.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

std::set<PairKey> keys(const std::vector<Pair>& pairs) {
  std::set<PairKey> all;
  for (const Pair& pair : pairs) CHECK(all.insert(key(pair)).second);  // none twice
  return all;
}

}  // namespace

TEST_CASE("every pair that touches in a step is a candidate, also where boxes only touch") {
  Rng random(77);
  std::array<std::uint64_t, 4> touching{};
  for (int round = 0; round < 400; ++round) {
    const bool on_grid = round % 2 == 0;
    const Scene scene = random_scene(random, on_grid);
    const System system(scene);
    const Colliders colliders(scene, system);
    const VectorX x0 = system.initial_position;
    VectorX x1 = x0;
    for (double& x : x1) x += on_grid ? random.between(-1, 1) : random.symmetric();
    const double margin = on_grid ? 0.5 : 0.1 * random.unit();
    // Where particles end within the margin of x1, pairs that were collected with it are enough.
    VectorX near = x1;
    for (double& x : near) x += margin * (on_grid ? random.between(-1, 1) : random.symmetric());
    const std::set<PairKey> without = keys(colliders.candidates(x0, x1, 0)),
                            with = keys(colliders.candidates(x0, x1, margin));
    const std::vector<Pair> all = all_pairs(scene, colliders);
    const std::set<PairKey> possible = keys(all);
    CHECK(std::includes(possible.begin(), possible.end(), without.begin(), without.end()));
    CHECK(std::includes(with.begin(), with.end(), without.begin(), without.end()));
    CHECK(without.size() < 3 * all.size() / 4);
    for (const Pair& pair : all) {
      if (solve(colliders.query(pair, x0, x1)).contact) {
        CAPTURE(round, colliders.describe(pair));
        CHECK(without.count(key(pair)) == 1);
        ++touching[static_cast<std::size_t>(pair.kind)];
      }
      if (solve(colliders.query(pair, x0, near)).contact) {
        CAPTURE(round, colliders.describe(pair));
        CHECK(with.count(key(pair)) == 1);
      }
    }
  }
  for (const auto count : touching) CHECK(count > 10);
}

TEST_CASE("the proof of a step names every pair that touches in it, and no other") {
  // With the paper's solver some do.
  const NarrowPhase narrow_phase = GENERATE(NarrowPhase::paper, NarrowPhase::exact);
  Scene scene = make_shipped_scene("hoop", 200);
  for (Particle& p : scene.particles) {
    if (p.pinned() || p.position.z() < 1.7) continue;
    p.position.z() -= 0.5;
    p.velocity.z() -= 4;
  }
  Simulation simulation(scene, {narrow_phase, 1});
  const Colliders& colliders = simulation.colliders();
  const std::vector<Pair> all = all_pairs(scene, colliders);
  std::size_t crossings = 0;
  for (int i = 0; i < 20; ++i) {
    const VectorX before = simulation.state().q;
    const double time = simulation.state().time;
    const auto records = simulation.step();
    REQUIRE(records.size() == 1);
    std::set<PairKey> touching, told;
    for (const Pair& pair : all) {
      const auto corners = colliders.corners(pair);
      bool counts = false;  // pinned elements and those that do not collide have no crossings
      bool collides = true;
      for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
        counts |= !scene.particles[corners[c]].pinned();
        collides &= scene.particles[corners[c]].collides;
      }
      if (counts && collides && solve(colliders.query(pair, before, simulation.state().q)).contact)
        touching.insert(key(pair));
    }
    for (std::size_t c = crossings; c < simulation.crossings().size(); ++c) {
      const Crossing& crossing = simulation.crossings()[c];
      told.insert(key(crossing.pair));
      CHECK(crossing.step == static_cast<std::uint64_t>(i + 1));
      CHECK(crossing.time >= time);
      CHECK(crossing.time <= simulation.state().time);
    }
    CHECK(told == touching);
    CHECK(records[0].proof.crossings == touching.size());
    crossings = simulation.crossings().size();
  }
  if (narrow_phase == NarrowPhase::paper) {
    CHECK(crossings > 20);
  } else {
    CHECK(crossings == 0);
  }
}
