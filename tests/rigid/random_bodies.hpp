// Bodies of all sorts in motion, and the questions about them asked pair by pair, from the definitions.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <touchstone/bodies.hpp>
#include <touchstone/curved.hpp>

#include "seeded/rng.hpp"

namespace touchstone::tests {

inline Body box(double x, double y, double z) {
  MeshElements elements;
  elements.vertex_count = 8;
  elements.faces = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back({(i & 4) != 0 ? x : -x, (i & 2) != 0 ? y : -y, (i & 1) != 0 ? z : -z});
  return Body(Mesh(elements), Positions(points));
}

/// A coordinate: of few bits, so that elements often meet in corners and borders, or of all bits.
inline double some_coordinate(seeded::Rng& random, bool coarse) {
  const double x = random.symmetric();
  return coarse ? std::floor(4 * x) / 4 : x;
}

inline Vec3 some_point(seeded::Rng& random, bool coarse, double size) {
  Vec3 point;
  point.x = size * some_coordinate(random, coarse);
  point.y = size * some_coordinate(random, coarse);
  point.z = size * some_coordinate(random, coarse);
  return point;
}

/// Faces, edges in no face and loose points, at random.
inline Body random_body(seeded::Rng& random, bool coarse, bool radii) {
  if (random.one_in(3)) {
    const auto half = [&] { return 0.25 + std::fabs(some_coordinate(random, coarse)) / 2; };
    const double x = half(), y = half();
    return box(x, y, half());
  }
  MeshElements elements;
  elements.vertex_count = 3 + random.below(8);
  const auto count = static_cast<MeshIndex>(elements.vertex_count);
  for (MeshIndex i = 0; i + 2 < count; ++i) {
    if (random.one_in(2)) elements.faces.push_back({i, i + 1, i + 2});
    if (random.one_in(4)) elements.edges.push_back({i, i + 2});
  }
  if (radii) {
    for (MeshIndex i = 0; i < count; ++i) elements.radii.push_back(random.one_in(2) ? 0 : 0.1 * random.uniform(0, 1));
  }
  std::vector<Vec3> points;
  for (MeshIndex i = 0; i < count; ++i) points.push_back(some_point(random, coarse, 0.75));
  return Body(Mesh(elements), Positions(points));
}

inline std::array<double, 4> some_orientation(seeded::Rng& random, bool coarse) {
  std::array<double, 4> q{};
  while (q == std::array<double, 4>{}) {
    for (double& component : q) component = coarse ? static_cast<double>(random.between(-2, 2)) : random.symmetric();
  }
  return q;
}

inline RigidMotion some_motion(seeded::Rng& random, bool coarse, double distance) {
  RigidMotion motion;
  motion.q0 = some_orientation(random, coarse);
  motion.q1 = random.one_in(5) ? motion.q0 : some_orientation(random, coarse);
  if (!random.one_in(3)) motion = with_shorter_turn(motion);
  if (random.one_in(4)) {
    for (double& component : motion.q1) component *= 1000;
  }
  double dot = 0, squares[2] = {0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    dot += motion.q0[i] * motion.q1[i];
    squares[0] += motion.q0[i] * motion.q0[i];
    squares[1] += motion.q1[i] * motion.q1[i];
  }
  if (dot < 0 && dot * dot > 0.999 * squares[0] * squares[1]) motion.q1 = motion.q0;  // it would be zero on the way
  motion.p0 = some_point(random, coarse, distance);
  motion.p1 = some_point(random, coarse, distance);
  return motion;
}

struct RandomBodies {
  Bodies bodies;
  std::vector<RigidMotion> motions;
};

inline RandomBodies random_bodies(seeded::Rng& random) {
  RandomBodies scene;
  const bool coarse = random.one_in(2), radii = random.one_in(4);
  const std::size_t count = 2 + random.below(2);
  const double distance = random.uniform(0.5, 3);
  for (std::size_t i = 0; i < count; ++i) {
    scene.bodies.bodies.push_back(random_body(random, coarse, radii));
    scene.motions.push_back(some_motion(random, coarse, distance));
  }
  if (random.one_in(4)) scene.bodies.separation.distance = 0.125;
  if (random.one_in(3)) scene.bodies.separation.metric = Metric::max;
  if (count > 2 && random.one_in(3)) scene.bodies.rules.body_pairs = {{2, 0}};
  return scene;
}

/// All pairs that are asked about, from the words of BodyPair, in ascending order.
inline std::vector<BodyPair> every_pair(const Bodies& bodies) {
  struct Sorts {
    std::vector<MeshIndex> vertices, points, edges, wires, faces;
  };
  std::vector<Sorts> all;
  for (const Body& body : bodies.bodies) {
    Sorts sorts;
    const Mesh& mesh = body.mesh();
    std::vector<char> in_edge(mesh.vertex_count(), 0);
    for (MeshIndex e = 0; e < mesh.edges().size(); ++e) {
      const auto [a, b] = mesh.edges()[e];
      in_edge[a] = in_edge[b] = 1;
      sorts.edges.push_back(e);
      const bool in_face = std::any_of(mesh.faces().begin(), mesh.faces().end(), [&, v = a, w = b](const auto& face) {
        return std::count(face.begin(), face.end(), v) + std::count(face.begin(), face.end(), w) == 2;
      });
      if (!in_face) sorts.wires.push_back(e);
    }
    for (MeshIndex v = 0; v < mesh.vertex_count(); ++v) {
      sorts.vertices.push_back(v);
      if (in_edge[v] == 0) sorts.points.push_back(v);
    }
    for (MeshIndex f = 0; f < mesh.faces().size(); ++f) sorts.faces.push_back(f);
    all.push_back(sorts);
  }
  std::vector<BodyPair> pairs;
  for (BodyIndex a = 0; a < all.size(); ++a) {
    for (BodyIndex b = 0; b < all.size(); ++b) {
      const auto listed = [&](const std::array<BodyIndex, 2>& pair) {
        return (pair[0] == a && pair[1] == b) || (pair[0] == b && pair[1] == a);
      };
      const auto& excluded = bodies.rules.body_pairs;
      if (a == b || std::any_of(excluded.begin(), excluded.end(), listed)) continue;
      const auto add = [&](Kind kind, const std::vector<MeshIndex>& first, const std::vector<MeshIndex>& second) {
        for (const MeshIndex i : first) {
          for (const MeshIndex j : second) pairs.push_back({kind, {a, i}, {b, j}});
        }
      };
      add(Kind::vertex_face, all[a].vertices, all[b].faces);
      add(Kind::point_edge, all[a].points, all[b].wires);
      if (a < b) add(Kind::edge_edge, all[a].edges, all[b].edges);
      if (a < b) add(Kind::point_point, all[a].points, all[b].points);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace touchstone::tests
