// Which pairs are looked at, against looking at all of them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <touchstone/solve.hpp>

#include "seeded/rng.hpp"
#include "sim/scene_parts.hpp"
#include "sim/shipped_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

using Key = std::tuple<Kind, Index, Index>;
Key key(const Pair& pair) { return {pair.kind, pair.i, pair.j}; }

template <std::size_t N>
bool has(const std::array<Index, N>& element, Index particle) {
  return std::find(element.begin(), element.end(), particle) != element.end();
}

/// Every pair that could touch in a scene whose particles all collide and all may move.
std::vector<Pair> all_pairs(const Scene& scene, const Elements& elements) {
  std::vector<Pair> pairs;
  std::set<Key> folds;
  const auto fold = [&](Index end, Index edge) {
    const Pair pair{Kind::point_edge, end, edge};
    if (folds.insert(key(pair)).second) pairs.push_back(pair);
  };
  const auto& edges = elements.edges();
  std::vector<char> in_edge(scene.particles.size(), 0);
  for (Index e = 0; e < edges.size(); ++e) {
    in_edge[edges[e][0]] = in_edge[edges[e][1]] = 1;
    for (Index f = e + 1; f < edges.size(); ++f) {
      const bool shares[2] = {has(edges[f], edges[e][0]), has(edges[f], edges[e][1])};
      if (!shares[0] && !shares[1]) pairs.push_back({Kind::edge_edge, e, f});
      // Edges that share a particle can only touch by folding: the end of one on the other.
      for (int end = 0; end < 2; ++end) {
        if (!shares[end]) continue;
        fold(edges[e][1 - end], f);
        fold(edges[f][edges[f][0] == edges[e][end] ? 1 : 0], e);
      }
    }
  }
  for (Index p = 0; p < scene.particles.size(); ++p) {
    for (Index f = 0; f < elements.faces().size(); ++f) {
      if (!has(elements.faces()[f], p)) pairs.push_back({Kind::vertex_face, p, f});
    }
    if (in_edge[p]) continue;
    for (Index e = 0; e < edges.size(); ++e) pairs.push_back({Kind::point_edge, p, e});
    for (Index other = p + 1; other < scene.particles.size(); ++other) {
      if (!in_edge[other]) pairs.push_back({Kind::point_point, p, other});
    }
  }
  return pairs;
}

/// Edges, faces, folds and loose particles. On a grid boxes touch more often than they overlap.
Scene random_scene(Rng& random, bool on_grid) {
  Scene scene;
  constexpr int kCount = 32;
  for (int i = 0; i < kCount; ++i) {
    const auto coordinate = [&] { return on_grid ? random.between(-3, 3) : 3 * random.symmetric(); };
    const double x = coordinate(), y = coordinate();
    add_particle(scene, {x, y, static_cast<double>(coordinate())}, 1);
  }
  for (Index i = 0; i + 1 < 8; ++i) scene.wires.push_back({i, i + 1});
  scene.wires.push_back({2, 5});
  for (Index i = 8; i < 14; i += 2) scene.wires.push_back({i, i + 1});
  scene.faces = {{14, 15, 16}, {16, 15, 17}, {18, 19, 20}};
  return scene;
}

std::set<Key> keys(const std::vector<Pair>& pairs) {
  std::set<Key> all;
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
    const Elements elements(scene, system);
    const VectorX x0 = system.initial_position;
    VectorX x1 = x0;
    for (double& x : x1) x += on_grid ? random.between(-1, 1) : random.symmetric();
    const double margin = on_grid ? 0.5 : 0.1 * random.unit();
    // Where particles end within the margin of x1, pairs that were collected with it are enough.
    VectorX near = x1;
    for (double& x : near) x += margin * (on_grid ? random.between(-1, 1) : random.symmetric());
    const std::set<Key> without = keys(elements.candidates(x0, x1, 0)),
                        with = keys(elements.candidates(x0, x1, margin));
    const std::vector<Pair> all = all_pairs(scene, elements);
    const std::set<Key> possible = keys(all);
    CHECK(std::includes(possible.begin(), possible.end(), without.begin(), without.end()));
    CHECK(std::includes(with.begin(), with.end(), without.begin(), without.end()));
    CHECK(without.size() < 3 * all.size() / 4);
    for (const Pair& pair : all) {
      if (solve(elements.query(pair, x0, x1)).contact) {
        CAPTURE(round, elements.describe(pair));
        CHECK(without.count(key(pair)) == 1);
        ++touching[static_cast<std::size_t>(pair.kind)];
      }
      if (solve(elements.query(pair, x0, near)).contact) {
        CAPTURE(round, elements.describe(pair));
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
  const Elements& elements = simulation.elements();
  const std::vector<Pair> all = all_pairs(scene, elements);
  std::size_t crossings = 0;
  for (int i = 0; i < 20; ++i) {
    const VectorX before = simulation.state().q;
    const double time = simulation.state().time;
    const auto records = simulation.step();
    REQUIRE(records.size() == 1);
    std::set<Key> touching, told;
    for (const Pair& pair : all) {
      const auto corners = elements.corners(pair);
      bool counts = false;  // what is pinned and what does not collide is nobody's crossing
      bool collides = true;
      for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
        counts |= !scene.particles[corners[c]].pinned();
        collides &= scene.particles[corners[c]].collides;
      }
      if (counts && collides && solve(elements.query(pair, before, simulation.state().q)).contact)
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
