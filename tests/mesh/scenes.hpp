// Small meshes of all sorts in motion, and the questions about them asked pair by pair, from the definitions.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <touchstone/mesh.hpp>
#include <touchstone/solve.hpp>

#include "seeded/rng.hpp"

namespace touchstone::tests {

struct Scene {
  std::string name;
  MeshElements elements;
  std::vector<double> x0, x1;  ///< rows of elements.dimension coordinates

  Positions start() const { return {x0, elements.dimension}; }
  Positions end() const { return {x1, elements.dimension}; }
  Vec3 corner(const std::vector<double>& x, MeshIndex v) const {
    const auto n = static_cast<std::size_t>(elements.dimension);
    return {x[v * n], x[v * n + 1], n == 3 ? x[v * n + 2] : 0};
  }
};

enum class Layout { soup, clustered, coplanar, wires, plane };
inline constexpr std::array<Layout, 5> kLayouts = {Layout::soup, Layout::clustered, Layout::coplanar, Layout::wires,
                                                   Layout::plane};

/// A coordinate: of few bits, so that elements often meet in corners and borders, or of all bits.
inline double coordinate(seeded::Rng& random, bool coarse) {
  const double x = random.symmetric();
  return coarse ? std::floor(8 * x) / 8 : x;
}

inline Scene random_scene(seeded::Rng& random, Layout layout, std::size_t vertices) {
  Scene scene;
  constexpr std::array<const char*, 5> kNames = {"soup", "clustered", "coplanar", "wires", "plane"};
  scene.name = kNames[static_cast<std::size_t>(layout)];
  MeshElements& elements = scene.elements;
  elements.vertex_count = vertices;
  elements.dimension = layout == Layout::plane ? 2 : 3;
  const bool coarse = random.one_in(3);
  const double size = random.uniform(0.05, 0.6), speed = random.uniform(0.02, 0.8);
  std::vector<Vec3> centres;
  const std::size_t clusters = layout == Layout::clustered ? 3 : vertices / 4 + 1;
  for (std::size_t i = 0; i < clusters; ++i) {
    Vec3 centre;
    centre.x = coordinate(random, coarse);
    centre.y = coordinate(random, coarse);
    centre.z = coordinate(random, coarse);
    centres.push_back(centre);
  }
  const double scale = std::ldexp(1.0, random.between(-30, 30));
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vec3& centre = centres[v * clusters / vertices];
    for (int k = 0; k < elements.dimension; ++k) {
      const double c = k == 0 ? centre.x : k == 1 ? centre.y : centre.z;
      double at = c + size * coordinate(random, coarse);
      double to = at + speed * coordinate(random, coarse);
      if (layout == Layout::coplanar && k == 2) {
        at = 0.25 * static_cast<double>(v * 3 / vertices);
        to = random.one_in(2) ? at : 0.25;
      }
      scene.x0.push_back(scale * at);
      scene.x1.push_back(scale * to);
    }
  }
  const auto vertex = [&](std::size_t near) {  // most elements join vertices that are near each other
    const std::size_t first = near / 4 * 4;
    return static_cast<MeshIndex>(std::min(vertices - 1, first + random.below(6)));
  };
  std::set<std::array<MeshIndex, 3>> faces;
  std::set<std::array<MeshIndex, 2>> edges;
  if (layout != Layout::wires && layout != Layout::plane) {
    for (std::size_t i = 0; i < vertices / 3; ++i) {
      const std::size_t near = random.below(vertices);
      std::array<MeshIndex, 3> face;
      for (MeshIndex& corner : face) corner = vertex(near);
      std::array<MeshIndex, 3> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !faces.insert(sorted).second) continue;
      elements.faces.push_back(face);
    }
  }
  const std::size_t more_edges = elements.faces.empty() ? vertices / 2 : vertices / 6;
  for (std::size_t i = 0; i < more_edges; ++i) {
    const std::size_t near = random.below(vertices);
    std::array<MeshIndex, 2> edge;
    for (MeshIndex& corner : edge) corner = vertex(near);
    if (edge[0] == edge[1] || !edges.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}).second) continue;
    elements.edges.push_back(edge);
  }
  return scene;
}

/// Gives the scene a separation of some sort, in units of its own size.
inline void add_separation(seeded::Rng& random, Scene& scene) {
  double largest = 0;
  for (const double x : scene.x0) largest = std::max(largest, std::fabs(x));
  if (random.one_in(2)) scene.elements.separation.metric = Metric::max;
  if (random.one_in(2)) {
    scene.elements.separation.distance = 0.02 * largest * random.unit();
  } else {
    for (std::size_t v = 0; v < scene.elements.vertex_count; ++v) {
      scene.elements.radii.push_back(random.one_in(4) ? 0 : 0.02 * largest * random.unit());
    }
  }
}

/// The mesh's edges and what follows from them, found again without the library.
struct Parts {
  std::vector<std::array<MeshIndex, 2>> edges;  ///< in the library's order
  std::vector<MeshIndex> points, vertices, wires;
};

inline Parts parts_of(const MeshElements& elements) {
  Parts parts;
  parts.edges = elements.edges;
  const auto sorted = [](std::array<MeshIndex, 2> e) {
    if (e[1] < e[0]) std::swap(e[0], e[1]);
    return e;
  };
  std::set<std::array<MeshIndex, 2>> of_faces, given;
  for (const auto& face : elements.faces) {
    for (std::size_t k = 0; k < 3; ++k) of_faces.insert(sorted({face[k], face[(k + 1) % 3]}));
  }
  for (const auto& edge : elements.edges) given.insert(sorted(edge));
  for (const auto& edge : of_faces) {
    if (given.count(edge) == 0) parts.edges.push_back(edge);
  }
  std::set<MeshIndex> in_edges;
  for (MeshIndex e = 0; e < parts.edges.size(); ++e) {
    in_edges.insert(parts.edges[e].begin(), parts.edges[e].end());
    if (of_faces.count(sorted(parts.edges[e])) == 0) parts.wires.push_back(e);
  }
  for (MeshIndex v = 0; v < elements.vertex_count; ++v) {
    const bool listed = elements.points && std::count(elements.points->begin(), elements.points->end(), v) != 0;
    const bool loose = elements.points ? listed : in_edges.count(v) == 0;
    if (loose) parts.points.push_back(v);
    if (loose || in_edges.count(v) != 0) parts.vertices.push_back(v);
  }
  return parts;
}

inline std::vector<MeshIndex> corners_of(const MeshElements& elements, const Parts& parts, const MeshPair& pair,
                                         bool of_second) {
  const MeshIndex i = of_second ? pair.second : pair.first;
  const bool edge = pair.kind == Kind::edge_edge || (pair.kind == Kind::point_edge && of_second);
  if (edge) return {parts.edges[i][0], parts.edges[i][1]};
  if (pair.kind == Kind::vertex_face && of_second) {
    return {elements.faces[i][0], elements.faces[i][1], elements.faces[i][2]};
  }
  return {i};
}

/// Whether a wire joins the vertex to the wire e, of which it is no corner: both may fold onto each other.
inline bool is_beside(const Parts& parts, MeshIndex vertex, MeshIndex e) {
  const auto has = [](const std::array<MeshIndex, 2>& edge, MeshIndex v) { return edge[0] == v || edge[1] == v; };
  if (has(parts.edges[e], vertex)) return false;
  return std::any_of(parts.wires.begin(), parts.wires.end(), [&](MeshIndex other) {
    const auto& [a, b] = parts.edges[other];
    return (a == vertex && has(parts.edges[e], b)) || (b == vertex && has(parts.edges[e], a));
  });
}

/// Whether the rules and shared vertices let the pair collide.
inline bool allowed(const MeshElements& elements, const Parts& parts, const MeshPair& pair) {
  const auto a = corners_of(elements, parts, pair, false), b = corners_of(elements, parts, pair, true);
  for (const MeshIndex i : a) {
    if (std::count(b.begin(), b.end(), i) != 0) return false;
  }
  const CollisionRules& rules = elements.rules;
  for (const MeshPair& listed : rules.element_pairs) {
    const bool one_sort = pair.kind == Kind::edge_edge || pair.kind == Kind::point_point;
    const bool same = listed.first == pair.first && listed.second == pair.second;
    const bool swapped = one_sort && listed.first == pair.second && listed.second == pair.first;
    if (listed.kind == pair.kind && (same || swapped)) return false;
  }
  const auto is_in = [](const std::vector<std::array<MeshIndex, 2>>& list, MeshIndex i, MeshIndex j) {
    return std::any_of(list.begin(), list.end(), [&](const auto& entry) {
      return (entry[0] == i && entry[1] == j) || (entry[0] == j && entry[1] == i);
    });
  };
  for (const MeshIndex i : a) {
    for (const MeshIndex j : b) {
      if (is_in(rules.vertex_pairs, i, j)) continue;
      if (rules.groups.empty()) return true;
      const bool listed = is_in(rules.group_pairs, rules.groups[i], rules.groups[j]);
      if (listed == (rules.group_rule == GroupRule::only_listed)) return true;
    }
  }
  return false;
}

/// Every pair that is to be asked about, by the definition.
inline std::vector<MeshPair> all_pairs(const MeshElements& elements) {
  const Parts parts = parts_of(elements);
  std::vector<MeshPair> pairs;
  const auto add = [&](Kind kind, MeshIndex i, MeshIndex j) {
    if (allowed(elements, parts, {kind, i, j})) pairs.push_back({kind, i, j});
  };
  if (elements.dimension == 3) {
    for (MeshIndex i = 0; i < parts.edges.size(); ++i) {
      for (MeshIndex j = i + 1; j < parts.edges.size(); ++j) add(Kind::edge_edge, i, j);
    }
    for (const MeshIndex v : parts.vertices) {
      for (MeshIndex f = 0; f < elements.faces.size(); ++f) add(Kind::vertex_face, v, f);
    }
    for (const MeshIndex v : parts.vertices) {
      const bool is_point = std::count(parts.points.begin(), parts.points.end(), v) != 0;
      for (const MeshIndex e : parts.wires) {
        if (is_point || is_beside(parts, v, e)) add(Kind::point_edge, v, e);
      }
    }
  } else {
    for (const MeshIndex v : parts.vertices) {
      for (MeshIndex e = 0; e < parts.edges.size(); ++e) add(Kind::point_edge, v, e);
    }
  }
  for (std::size_t i = 0; i < parts.points.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.points.size(); ++j) add(Kind::point_point, parts.points[i], parts.points[j]);
  }
  return pairs;
}

inline Query query_between(const Scene& scene, const Parts& parts, const MeshPair& pair, const std::vector<double>& x0,
                           const std::vector<double>& x1) {
  Query query;
  query.kind = pair.kind;
  std::size_t c = 0;
  for (const bool of_second : {false, true}) {
    for (const MeshIndex v : corners_of(scene.elements, parts, pair, of_second)) {
      query.start[c] = scene.corner(x0, v);
      query.end[c++] = scene.corner(x1, v);
    }
  }
  return query;
}

/// The pair's separation: a sum of two doubles is rounded up through long doubles, which hold these sums exactly enough
/// to tell whether the rounded sum is too small.
inline double separation_between(const Scene& scene, const Parts& parts, const MeshPair& pair) {
  for (const PairSeparation& listed : scene.elements.pair_separations) {
    const bool one_sort = pair.kind == Kind::edge_edge || pair.kind == Kind::point_point;
    const bool swapped = one_sort && listed.pair == MeshPair{pair.kind, pair.second, pair.first};
    if (listed.pair == pair || swapped) return listed.distance;
  }
  const bool wires = pair.kind == Kind::point_edge && scene.elements.dimension == 3;
  if (wires && std::count(parts.points.begin(), parts.points.end(), pair.first) == 0) return 0;  // beside each other
  if (scene.elements.radii.empty()) return scene.elements.separation.distance;
  double radius[2] = {0, 0};
  for (const bool of_second : {false, true}) {
    for (const MeshIndex v : corners_of(scene.elements, parts, pair, of_second)) {
      radius[of_second] = std::max(radius[of_second], scene.elements.radii[v]);
    }
  }
  const long double exact = static_cast<long double>(radius[0]) + static_cast<long double>(radius[1]);
  double sum = radius[0] + radius[1];
  if (static_cast<long double>(sum) < exact) sum = std::nextafter(sum, INFINITY);
  return sum;
}

/// Gives some pairs a separation of their own.
inline void add_pair_separations(seeded::Rng& random, Scene& scene) {
  double largest = 0;
  for (const double x : scene.x0) largest = std::max(largest, std::fabs(x));
  for (const MeshPair& pair : all_pairs(scene.elements)) {
    if (!random.one_in(5)) continue;
    const bool swapped = (pair.kind == Kind::edge_edge || pair.kind == Kind::point_point) && random.one_in(2);
    const double distance = random.one_in(3) ? 0 : 0.05 * largest * random.unit();
    scene.elements.pair_separations.push_back(
        {swapped ? MeshPair{pair.kind, pair.second, pair.first} : pair, distance});
  }
}

}  // namespace touchstone::tests
