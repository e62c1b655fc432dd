// SPDX-License-Identifier: MIT
#include "sim/all_pairs.hpp"

#include <algorithm>
#include <set>

#include "scene/parts.hpp"

namespace touchstone::sim {
namespace {

template <std::size_t N>
bool has_particle(const std::array<Index, N>& element, Index particle) {
  return std::find(element.begin(), element.end(), particle) != element.end();
}

}  // namespace

std::vector<Pair> all_pairs(const Scene& scene, const Colliders& colliders) {
  std::vector<Pair> pairs;
  std::set<PairKey> folds;
  const auto fold = [&](Index end, Index edge) {
    const Pair pair{Kind::point_edge, end, edge};
    if (folds.insert(key(pair)).second) pairs.push_back(pair);
  };
  const auto& edges = colliders.edges();
  std::vector<char> in_edge(scene.particles.size(), 0);
  for (Index e = 0; e < edges.size(); ++e) {
    in_edge[edges[e][0]] = in_edge[edges[e][1]] = 1;
    for (Index f = e + 1; f < edges.size(); ++f) {
      const bool shares[2] = {has_particle(edges[f], edges[e][0]), has_particle(edges[f], edges[e][1])};
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
    for (Index f = 0; f < colliders.faces().size(); ++f) {
      if (!has_particle(colliders.faces()[f], p)) pairs.push_back({Kind::vertex_face, p, f});
    }
    if (in_edge[p]) continue;
    for (Index e = 0; e < edges.size(); ++e) pairs.push_back({Kind::point_edge, p, e});
    for (Index other = p + 1; other < scene.particles.size(); ++other) {
      if (!in_edge[other]) pairs.push_back({Kind::point_point, p, other});
    }
  }
  return pairs;
}

Scene random_scene(seeded::Rng& random, bool on_grid) {
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

}  // namespace touchstone::sim
