// SPDX-License-Identifier: MIT
#include "families/body_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace touchstone::families {
namespace {

using seeded::Rng;
using Quaternion = std::array<double, 4>;

RigidMotion with_shorter(const RigidMotion& motion) {
  return motion_between({motion.q0, motion.p0}, {motion.q1, motion.p1});
}

double& axis(Vec3& p, std::size_t k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

/// A coordinate: of few bits, so that elements often meet in corners and borders, or of all bits.
double some_coordinate(Rng& random, bool coarse) {
  const double x = random.symmetric();
  return coarse ? std::floor(4 * x) / 4 : x;
}

}  // namespace

BodyShape random_shape(Rng& random, bool coarse, bool radii) {
  if (random.one_in(3)) {
    const auto half = [&] { return 0.25 + std::fabs(some_coordinate(random, coarse)) / 2; };
    const double x = half(), y = half();
    return box_shape(x, y, half());
  }
  BodyShape shape;
  MeshElements& elements = shape.elements;
  elements.vertex_count = 3 + random.below(8);
  const auto count = static_cast<MeshIndex>(elements.vertex_count);
  for (MeshIndex i = 0; i + 2 < count; ++i) {
    if (random.one_in(2)) elements.faces.push_back({i, i + 1, i + 2});
    if (random.one_in(4)) elements.edges.push_back({i, i + 2});
  }
  if (radii) {
    for (MeshIndex i = 0; i < count; ++i) elements.radii.push_back(random.one_in(2) ? 0 : 0.1 * random.uniform(0, 1));
  }
  for (MeshIndex i = 0; i < count; ++i) shape.points.push_back(some_point(random, coarse, 0.75));
  return shape;
}

namespace {

Quaternion some_orientation(Rng& random, bool coarse) {
  Quaternion q{};
  while (q == Quaternion{}) {
    for (double& component : q) component = coarse ? static_cast<double>(random.between(-2, 2)) : random.symmetric();
  }
  return q;
}

/// One of the 24 orientations that map the axes to the axes.
Quaternion some_quarter(Rng& random) {
  Quaternion q{};
  while (q == Quaternion{}) {
    for (double& component : q) component = random.between(-1, 1);
    const auto zeros = std::count(q.begin(), q.end(), 0);
    if (zeros == 1) q = {};
  }
  return q;
}

double small_integer(Rng& random, int least, int most) { return random.between(least, most); }

BodyShape some_box(Rng& random, int most) {
  const double x = small_integer(random, 1, most), y = small_integer(random, 1, most);
  return box_shape(x, y, small_integer(random, 1, most));
}

BodyScene quarter_turns(Rng& random) {
  BodyScene scene;
  for (int i = 0; i < 2; ++i) {
    scene.shapes.push_back(some_box(random, 3));
    RigidMotion motion;
    motion.q0 = some_quarter(random);
    motion.q1 = some_quarter(random);
    motion = with_shorter(motion);
    for (std::size_t k = 0; k < 3; ++k) {
      axis(motion.p0, k) = small_integer(random, -5, 5);
      axis(motion.p1, k) = small_integer(random, -5, 5);
    }
    scene.motions.push_back(motion);
  }
  if (random.one_in(4)) scene.separation.distance = small_integer(random, 1, 2) / 2;
  if (random.one_in(2)) scene.separation.metric = Metric::max;
  return scene;
}

BodyScene touching(Rng& random) {
  BodyScene scene;
  const auto k = static_cast<std::size_t>(random.below(3));
  const double side = random.one_in(2) ? 1 : -1;
  if (random.one_in(3)) scene.separation.distance = small_integer(random, 1, 4) / 4;
  double apart = scene.separation.distance;
  for (int i = 0; i < 2; ++i) {
    BodyShape box = some_box(random, 3);
    apart += std::fabs(axis(box.points[0], k));
    RigidMotion motion;
    if (random.one_in(2))
      motion.q1[k + 1] = small_integer(random, -1, 1);  // about the axis of approach: its side stays
    scene.shapes.push_back(box);
    scene.motions.push_back(motion);
  }
  RigidMotion& motion = scene.motions[1];
  const double way = small_integer(random, 1, 3);
  const int when = random.between(0, 2);  // 0: at the start, 1: in the middle, 2: at the end
  axis(motion.p0, k) = side * (apart + (when == 0 ? 0 : way));
  axis(motion.p1, k) = side * (apart + (when == 0 ? way : when == 1 ? -way : 0));
  for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
    axis(motion.p0, other) = small_integer(random, -8, 8) / 4;
    axis(motion.p1, other) = small_integer(random, -8, 8) / 4;
  }
  if (random.one_in(3)) {
    double& ulp = axis(random.one_in(2) ? motion.p0 : motion.p1, k);
    ulp = std::nextafter(ulp, random.one_in(2) ? 100.0 : -100.0);
  }
  return scene;
}

BodyScene one_inside(Rng& random) {
  BodyScene scene;
  const bool coarse = random.one_in(2);
  const double half = random.uniform(0.25, 0.75);
  scene.shapes = {box_shape(half, half / 2, half), box_shape(2, 2, 2)};
  scene.motions.push_back(some_motion(random, coarse, 0.5));
  scene.motions.push_back(some_motion(random, coarse, 0.25));
  if (random.one_in(3)) scene.motions[0].p1.x += 4;
  if (random.one_in(4)) std::swap(scene.shapes[0], scene.shapes[1]), std::swap(scene.motions[0], scene.motions[1]);
  return scene;
}

/// The sides of a prism whose outline has so many teeth.
BodyShape gear_shape(int teeth, double inner, double outer) {
  BodyShape shape;
  const int corners = 2 * teeth;
  shape.elements.vertex_count = static_cast<std::size_t>(2 * corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = std::acos(-1.0) * i / teeth, r = i % 2 == 0 ? outer : inner;
    for (const double z : {-0.25, 0.25}) shape.points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    const auto a = static_cast<MeshIndex>(2 * i), b = static_cast<MeshIndex>(2 * ((i + 1) % corners));
    shape.elements.faces.push_back({a, b, b + 1});
    shape.elements.faces.push_back({a, b + 1, a + 1});
  }
  return shape;
}

BodyScene gear_pair(Rng& random) {
  BodyScene scene;
  const int teeth = random.between(3, 5);
  const double inner = 1, outer = random.uniform(1.25, 1.5), turn = random.uniform(-0.5, 0.5);
  const double apart = random.uniform(inner + outer, 2 * outer);
  for (int i = 0; i < 2; ++i) {
    scene.shapes.push_back(gear_shape(teeth, inner, outer));
    const double start = i == 0 ? 0 : random.uniform(0, 1), end = start + (i == 0 ? turn : -turn);
    const Vec3 axle{i == 0 ? 0 : apart, 0, 0};
    scene.motions.push_back(
        {{std::cos(start), 0, 0, std::sin(start)}, {std::cos(end), 0, 0, std::sin(end)}, axle, axle});
  }
  return scene;
}

BodyScene far_away(Rng& random) {
  static constexpr std::array kOthers = {BodyFamily::bodies_random, BodyFamily::bodies_quarter,
                                         BodyFamily::bodies_touch, BodyFamily::bodies_inside};
  const BodyFamily other = random.pick(kOthers);
  BodyScene scene = body_scene(other, random.bits(), 0);
  for (std::size_t k = 0; k < 3; ++k) {
    const int factor = random.between(-3, 3);
    const double offset = std::ldexp(factor, random.between(8, 44));
    for (RigidMotion& motion : scene.motions) axis(motion.p0, k) += offset, axis(motion.p1, k) += offset;
  }
  return scene;
}

}  // namespace

Bodies BodyScene::bodies() const {
  Bodies made;
  for (const BodyShape& shape : shapes) made.bodies.emplace_back(Mesh(shape.elements), Positions(shape.points));
  made.rules = rules;
  made.separation = separation;
  return made;
}

std::string_view name_of(BodyFamily family) noexcept {
  switch (family) {
    case BodyFamily::bodies_random: return "bodies_random";
    case BodyFamily::bodies_quarter: return "bodies_quarter";
    case BodyFamily::bodies_touch: return "bodies_touch";
    case BodyFamily::bodies_inside: return "bodies_inside";
    case BodyFamily::bodies_gears: return "bodies_gears";
    case BodyFamily::bodies_far: return "bodies_far";
  }
  return {};
}

std::optional<BodyFamily> body_family_named(std::string_view name) noexcept {
  for (const BodyFamily family : kEveryBodyFamily) {
    if (name_of(family) == name) return family;
  }
  return std::nullopt;
}

BodyScene body_scene(BodyFamily family, std::uint64_t seed, std::uint64_t index) {
  Rng random(seeded::seed_of_stream(seed + 0x9E3779B97F4A7C15u * static_cast<std::uint64_t>(family), index));
  switch (family) {
    case BodyFamily::bodies_random: return random_body_scene(random);
    case BodyFamily::bodies_quarter: return quarter_turns(random);
    case BodyFamily::bodies_touch: return touching(random);
    case BodyFamily::bodies_inside: return one_inside(random);
    case BodyFamily::bodies_gears: return gear_pair(random);
    case BodyFamily::bodies_far: return far_away(random);
  }
  return {};
}

BodyShape box_shape(double x, double y, double z) {
  BodyShape shape;
  shape.elements.vertex_count = 8;
  shape.elements.faces = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                          {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  for (int i = 0; i < 8; ++i) {
    shape.points.push_back({(i & 4) != 0 ? x : -x, (i & 2) != 0 ? y : -y, (i & 1) != 0 ? z : -z});
  }
  return shape;
}

Vec3 some_point(Rng& random, bool coarse, double size) {
  Vec3 point;
  point.x = size * some_coordinate(random, coarse);
  point.y = size * some_coordinate(random, coarse);
  point.z = size * some_coordinate(random, coarse);
  return point;
}

RigidMotion some_motion(Rng& random, bool coarse, double distance) {
  RigidMotion motion;
  motion.q0 = some_orientation(random, coarse);
  motion.q1 = random.one_in(5) ? motion.q0 : some_orientation(random, coarse);
  if (!random.one_in(3)) motion = with_shorter(motion);
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

BodyScene random_body_scene(Rng& random) {
  BodyScene scene;
  const bool coarse = random.one_in(2), radii = random.one_in(4);
  const std::size_t count = 2 + random.below(2);
  const double distance = random.uniform(0.5, 3);
  for (std::size_t i = 0; i < count; ++i) {
    scene.shapes.push_back(random_shape(random, coarse, radii));
    scene.motions.push_back(some_motion(random, coarse, distance));
  }
  if (random.one_in(4)) scene.separation.distance = 0.125;
  if (random.one_in(3)) scene.separation.metric = Metric::max;
  if (count > 2 && random.one_in(3)) scene.rules.body_pairs = {{2, 0}};
  return scene;
}

std::vector<BodyPair> every_pair(const Bodies& bodies) {
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

}  // namespace touchstone::families
