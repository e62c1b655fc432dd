// The closest approach of a mesh: no pair comes nearer, and the pair that is named comes so near.
// SPDX-License-Identifier: MIT
#include <touchstone/closest_approach.hpp>

#include <cmath>
#include <limits>

#include <touchstone/distance.hpp>
#include <touchstone/solve.hpp>

#include "mesh/same_bytes.hpp"
#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool comes_within(const Query& query, double distance, Metric metric, double t_max) {
  const Separation separation{distance, metric};
  return solve(query, {.t_max = t_max, .separation = separation, .method = Method::exact}).contact;
}

/// With every pair at this separation, and without radii.
Mesh with_separation(MeshElements elements, double distance) {
  elements.separation.distance = distance;
  elements.radii.clear();
  return Mesh(elements);
}

/// Asks every pair whether it comes nearer.
void check_pairs(Scene scene, double distance, double t_max) {
  const Metric metric = scene.elements.separation.metric;
  scene.elements.separation.distance = std::nextafter(distance, 0.0);
  scene.elements.radii.clear();
  const Parts parts = parts_of(scene.elements);
  for (const MeshPair& pair : all_pairs(scene.elements)) {
    const Query query = query_between(scene, parts, pair, scene.x0, scene.x1);
    CAPTURE(name_of(pair.kind), pair.first, pair.second);
    REQUIRE_FALSE(comes_within(query, separation_between(scene, parts, pair), metric, t_max));
  }
}

}  // namespace

TEST_CASE("no pair comes nearer than the closest approach, and the first pairs so near are named") {
  std::size_t apart = 0, touching = 0, intersecting = 0;
  for (std::size_t i = 0; i < effort(400); ++i) {
    seeded::Rng random(seeded::seed_of_stream(391, i));
    Scene scene = random_scene(random, random.pick(kLayouts), 4 + random.below(30));
    add_separation(random, scene);
    const bool at_rest = random.one_in(3);
    if (at_rest) scene.x1 = scene.x0;
    const Mesh mesh(scene.elements);
    StepOptions options;
    options.t_max = at_rest || random.one_in(2) ? 1 : random.unit();
    options.threads = random.between(1, 3);
    const ClosestApproach approach =
        at_rest ? distance(mesh, scene.start()) : closest_approach(mesh, scene.start(), scene.end(), options);
    CAPTURE(i, scene.name, at_rest, options.t_max, approach.distance);
    const FirstContact& first = approach.first_contact;
    REQUIRE(first.start_checked);
    REQUIRE(first.start_intersections.empty() != intersects(mesh, scene.start()));
    FirstContactOptions again;
    static_cast<StepOptions&>(again) = options;
    again.check_start = true;
    if (approach.distance < kInfinity) {
      const Mesh same = with_separation(scene.elements, approach.distance);
      REQUIRE(same_bytes(first, first_contact(same, scene.start(), scene.end(), again)));
      REQUIRE_FALSE(first.free());
    } else {
      REQUIRE(first.free());
      check_pairs(scene, std::numeric_limits<double>::max(), options.t_max);
    }
    if (!first.start_intersections.empty()) {
      ++intersecting;
      REQUIRE(approach.distance == 0);
    } else if (approach.distance == 0) {
      ++touching;
    } else {
      ++apart;
      check_pairs(scene, approach.distance, options.t_max);
    }
  }
  CAPTURE(apart, touching, intersecting);
  if (!whole_effort("the number of scenes of each sort")) return;
  CHECK(apart > 100);
  CHECK(touching > 20);
  CHECK(intersecting > 20);
}

TEST_CASE("of many small triangles no two come nearer than the closest approach") {
  std::size_t apart = 0;
  const std::size_t scenes = effort(120);
  for (std::size_t i = 0; i < scenes; ++i) {
    seeded::Rng random(seeded::seed_of_stream(392, i));
    const std::size_t triangles = 20 + random.below(400);
    const double size = random.uniform(0.001, 0.03), speed = random.one_in(3) ? 0 : random.uniform(0.001, 0.1);
    const bool flat = random.one_in(3);
    MeshElements elements;
    std::vector<Vec3> x0, x1;
    for (std::size_t t = 0; t < triangles; ++t) {
      const auto first = static_cast<MeshIndex>(x0.size());
      elements.faces.push_back({first, first + 1, first + 2});
      const Vec3 centre = {random.unit(), random.unit(), flat ? 0 : random.unit()};
      const Vec3 way = {speed * random.symmetric(), speed * random.symmetric(), speed * random.symmetric()};
      for (int c = 0; c < 3; ++c) {
        x0.push_back({centre.x + size * random.symmetric(), centre.y + size * random.symmetric(),
                      centre.z + size * random.symmetric()});
        x1.push_back({x0.back().x + way.x, x0.back().y + way.y, x0.back().z + way.z});
      }
    }
    elements.vertex_count = x0.size();
    if (random.one_in(2)) elements.separation.metric = Metric::max;
    StepOptions options;
    options.threads = random.between(1, 3);
    const ClosestApproach approach = closest_approach(Mesh(elements), x0, x1, options);
    CAPTURE(i, triangles, speed, approach.distance);
    REQUIRE_FALSE(approach.first_contact.free());
    if (approach.distance == 0) continue;
    ++apart;
    const Mesh nearer = with_separation(elements, std::nextafter(approach.distance, 0.0));
    REQUIRE(first_contact(nearer, x0, x1).free());
  }
  CAPTURE(apart, scenes);
  CHECK(4 * apart > scenes);
}

TEST_CASE("a far element, and a far vertex in none, change nothing of the nearest pair") {
  // Rows of triangles a hundredth apart, and one that is 1e30 or 1e300 away: all pairs would be 18 million.
  for (const double far : {1e30, 1e300}) {
    MeshElements elements;
    std::vector<Vec3> x;
    const auto add = [&](const Vec3& at) {
      const auto first = static_cast<MeshIndex>(x.size());
      elements.faces.push_back({first, first + 1, first + 2});
      x.push_back(at);
      x.push_back({at.x + 0.001, at.y, at.z});
      x.push_back({at.x, at.y + 0.001, at.z});
    };
    for (int i = 0; i < 6000; ++i) add({0.01 * (i % 80), 0.01 * (i / 80), 0});
    add({far, 0, 0});
    x.push_back({-far, far, 0});  // in no element
    elements.vertex_count = x.size();
    const Mesh mesh(elements);
    const ClosestApproach approach = distance(mesh, x);
    CHECK(approach.distance > 0.0089);
    CHECK(approach.distance < 0.009);
    CHECK(closest_approach(mesh, x, x, {}).distance == approach.distance);
    const Mesh nearer = with_separation(elements, std::nextafter(approach.distance, 0.0));
    CHECK(first_contact(nearer, x, x).free());
  }
}

TEST_CASE("parts are measured against each other alone, where only their groups collide") {
  // Two tetrahedra, one above the other's top, and an empty group.
  MeshElements elements;
  elements.vertex_count = 8;
  elements.faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {4, 5, 6}, {4, 7, 5}, {5, 7, 6}, {6, 7, 4}};
  std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.1, 1}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {0, 0, 3}};
  CHECK(distance(Mesh(elements), x).distance < 1);  // within one of them
  elements.rules.groups = {0, 0, 0, 0, 1, 1, 1, 1};
  elements.rules.group_rule = GroupRule::only_listed;
  elements.rules.group_pairs = {{0, 1}};
  const Mesh mesh(elements);
  const ClosestApproach at_rest = distance(mesh, x);
  CHECK(at_rest.distance == 1);
  REQUIRE(at_rest.first_contact.at_start.size() == 1);
  CHECK(mesh.describe(at_rest.first_contact.at_start[0].pair) == "vertex 3 and face 4 (4-5-6)");

  std::vector<Vec3> lower = x;
  for (std::size_t v = 4; v < 8; ++v) lower[v].z -= 0.75;
  CHECK(closest_approach(mesh, x, lower).distance == 0.25);
  StepOptions half;
  half.t_max = 0.5;
  CHECK(closest_approach(mesh, x, lower, half).distance == 0.625);
  for (std::size_t v = 4; v < 8; ++v) lower[v].z -= 9.25;  // through the other one
  const ClosestApproach through = closest_approach(mesh, x, lower);
  CHECK(through.distance == 0);
  CHECK(through.first_contact.toi_upper == 0.1);

  elements.rules.group_pairs.clear();
  CHECK(distance(Mesh(elements), x).distance == kInfinity);
}

TEST_CASE("distances of any size are found") {
  MeshElements elements;
  elements.vertex_count = 3;
  const Mesh mesh(elements);
  for (const double size : {0x1p-1074, 1e-300, 1.0, 1e300}) {
    const std::vector<Vec3> x = {{0, 0, 0}, {size, 0, 0}, {0, 4 * size, 0}};
    CHECK(distance(mesh, x).distance == size);
    CHECK(distance(mesh, x).first_contact.at_start[0].pair == MeshPair{Kind::point_point, 0, 1});
  }
  constexpr double kMost = std::numeric_limits<double>::max();
  const std::vector<Vec3> far = {{kMost, 0, 0}, {-kMost, 0, 0}, {0, 1e308, 0}};
  CHECK(distance(mesh, far).distance == kInfinity);
  CHECK(distance(mesh, far).first_contact.free());
  CHECK_THROWS_AS(distance(mesh, std::vector<Vec3>{{0, 0, 0}}), InvalidQuery);
  // Rounded up: the root of 2 is below the nearest double.
  const std::vector<Vec3> diagonal = {{0, 0, 0}, {1, 1, 0}, {8, 8, 8}};
  const double root = distance(mesh, diagonal).distance;
  CHECK(compare_distance(query_of(mesh, {Kind::point_point, 0, 1}, diagonal, diagonal), 0, {root}) <= 0);
  CHECK(compare_distance(query_of(mesh, {Kind::point_point, 0, 1}, diagonal, diagonal), 0,
                         {std::nextafter(root, 0.0)}) > 0);
}
