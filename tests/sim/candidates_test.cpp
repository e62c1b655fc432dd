// The candidate pairs of a step: none is missing, and few are superfluous.
// SPDX-License-Identifier: MIT
#include <set>
#include <tuple>

#include <touchstone/solve.hpp>

#include "broad_phase/grid.hpp"
#include "scene/shipped_scenes.hpp"
#include "seeded/rng.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;

namespace {

using Key = std::tuple<Kind, Index, Index>;

VectorX moved(seeded::Rng& random, const VectorX& x, Eigen::Index coordinates, double by) {
  VectorX result = x;
  for (Eigen::Index i = 0; i < coordinates; ++i) result[i] += by * random.symmetric();
  return result;
}

}  // namespace

TEST_CASE("whatever touches while particles end within the margin is among the candidates") {
  const Scene scene = make_shipped_scene("two-edges", 30);
  const System system(scene);
  const Colliders colliders(scene, system);
  const auto coordinates = static_cast<Eigen::Index>(3 * system.particle_count());
  const auto edges = static_cast<Index>(colliders.edges().size());
  seeded::Rng random(21);
  long contacts = 0, candidates = 0, all = 0;
  for (int round = 0; round < 40; ++round) {
    // Thrown into one heap, which flies; some of it turns inside out.
    VectorX x0 = moved(random, VectorX::Zero(system.initial_position.size()), coordinates, 1);
    VectorX x1 = moved(random, x0, coordinates, round % 2 == 0 ? 0.05 : 1);
    x1.head(coordinates).array() += 20 * random.symmetric();
    const double margin = 0.02 * random.unit();
    std::set<Key> collected;
    for (const Pair& pair : colliders.candidates(x0, x1, margin)) collected.insert({pair.kind, pair.i, pair.j});
    candidates += static_cast<long>(collected.size());
    const VectorX end = moved(random, x1, coordinates, margin);
    for (Index i = 0; i < edges; ++i) {
      for (Index j = i + 1; j < edges; ++j) {
        const Pair pair{Kind::edge_edge, i, j};
        ++all;
        if (!solve(colliders.query(pair, x0, end)).contact) continue;
        ++contacts;
        REQUIRE(collected.count({pair.kind, i, j}) == 1);
      }
    }
  }
  CHECK(contacts > 500);
  CHECK(candidates < all);
}

TEST_CASE("a cable that is fast asks about few pairs, however many of its segments sweep over the same places") {
  // In the first step it meets the wire, and its ends are drawn together along half of its length.
  Scene scene = make_shipped_scene("whip", 600);
  scene.settings.time_step = 1.0 / 60;
  scene.settings.integrator = Integrator::implicit_euler;
  Simulation simulation(scene, {});
  const std::size_t segments = simulation.colliders().edges().size();
  std::uint64_t pairs = 0, queries = 0, contacts = 0, swept = 0;
  for (int i = 0; i < 6; ++i) {
    const VectorX before = simulation.state().q;
    for (const SubstepRecord& record : simulation.step()) {
      pairs += record.proof.pairs;
      queries += record.response.queries;
      contacts += record.response.contacts;
    }
    // The queries that boxes around the paths would ask.
    std::vector<broad_phase::Box> boxes;
    for (const Edge& edge : simulation.colliders().edges()) {
      boxes.push_back(broad_phase::empty_box());
      for (const Index p : edge) {
        broad_phase::extend(boxes.back(), corner_of(before, p));
        broad_phase::extend(boxes.back(), corner_of(simulation.state().q, p));
      }
    }
    broad_phase::for_each_overlap(boxes, [&](std::uint32_t, std::uint32_t) { ++swept; });
  }
  CHECK(contacts > 0);
  CHECK(swept > 50 * segments);
  CHECK(pairs < 6 * segments);
  CHECK(queries < 6 * 5 * segments);
}
