// The distance of bodies at rest: no pair is nearer, the pairs that are so near are named, and no other.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <touchstone/distance.hpp>
#include <touchstone/touchstone.hpp>

#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

std::vector<RigidMotion> at_rest(const std::vector<Pose>& poses) {
  std::vector<RigidMotion> motions;
  for (const Pose& pose : poses) motions.push_back(motion_between(pose, pose));
  return motions;
}

std::vector<BodyPair> pairs_of(const BodyDistance& found) {
  std::vector<BodyPair> pairs;
  for (const BodyContact& contact : found.pairs) {
    pairs.push_back(contact.pair);
    CHECK(contact.separation.distance == found.distance);
    CHECK(contact.answer.contact);
    CHECK(contact.answer.starts_within);
  }
  return pairs;
}

}  // namespace

TEST_CASE("the distance of bodies is that of all pairs of their elements") {
  seeded::Rng random(4111);
  std::size_t apart = 0, touching = 0, several = 0;
  for (std::size_t i = 0; i < effort(200); ++i) {
    const RandomBodies scene = random_bodies(random);
    std::vector<Pose> poses;
    for (const RigidMotion& motion : scene.motions) poses.push_back({motion.q0, motion.p0});
    if (i % 3 == 0) {  // elements often touch
      for (auto& [orientation, p] : poses) {
        orientation = {1, 0, 0, 0};
        p = {std::floor(4 * p.x) / 4, std::floor(4 * p.y) / 4, std::floor(4 * p.z) / 4};
      }
    }
    const std::vector<RigidMotion> motions = at_rest(poses);
    MeshOptions options;
    options.threads = random.one_in(2) ? 1 : 3;
    const BodyDistance found = distance(scene.bodies, poses, options);
    CAPTURE(i, found.distance, found.pairs.size(), found.intersections.size());
    const Metric metric = scene.bodies.separation.metric;
    std::vector<BodyPair> within;
    for (const BodyPair& pair : every_pair(scene.bodies)) {
      const CurvedQuery query = query_of(scene.bodies, pair, motions);
      if (compare_distance(query, 0, {found.distance, metric}) <= 0) within.push_back(pair);
      if (found.distance > 0) REQUIRE(compare_distance(query, 0, {std::nextafter(found.distance, 0.0), metric}) > 0);
    }
    REQUIRE(pairs_of(found) == within);
    REQUIRE((found.distance > 0) == found.intersections.empty());
    CHECK(found.excluded == scene.bodies.rules.body_pairs.size());
    apart += found.distance > 0 ? 1 : 0;
    touching += found.distance == 0 && !within.empty() ? 1 : 0;
    several += within.size() > 1 ? 1 : 0;
  }
  CAPTURE(apart, touching, several);
  CHECK(apart > effort(200) / 8);
  if (effort(200) == 200) CHECK((touching > 0 && several > 10));
}

TEST_CASE("the distance of bodies: boxes, far origins, one inside another, and nothing to ask") {
  Bodies bodies;
  bodies.bodies = {box(1, 1, 1), box(1, 1, 1)};
  const Pose here{}, turned{{1, 0, 0, 1}, {3.5, 0, 0}};
  BodyDistance found = distance(bodies, {here, turned});
  CHECK(found.distance == 1.5);
  CHECK(found.pairs.size() > 1);
  CHECK(found.intersections.empty());
  // A corner is sqrt(2) from the axis: the gap is 3.5 - 1 - sqrt(2), rounded up.
  const double s = std::sqrt(0.5);
  found = distance(bodies, {here, {{std::cos(std::atan(1.0) / 2), 0, 0, std::sin(std::atan(1.0) / 2)}, {3.5, 0, 0}}});
  CHECK(found.distance == Approx(2.5 - 2 * s).epsilon(1e-14));
  bodies.separation.metric = Metric::max;
  found = distance(bodies, {here, {{1, 0, 0, 0}, {3.5, 4.5, 0}}});
  CHECK(found.distance == 2.5);
  bodies.separation.metric = Metric::euclidean;

  // One inside the other touches nothing, and is at the distance 0.
  bodies.bodies = {box(1, 1, 1), box(9, 9, 9)};
  found = distance(bodies, {here, here});
  CHECK(found.distance == 0);
  CHECK(found.pairs.empty());
  CHECK(found.intersections.size() == 1);

  MeshElements point;
  point.vertex_count = 1;
  point.points = {0};
  point.radii = {0.5};  // does not count
  bodies.bodies = {Body(Mesh(point), std::vector<Vec3>{{1e300, 0, 0}}),
                   Body(Mesh(point), std::vector<Vec3>{{0, 0, 0}})};
  CHECK(distance(bodies, {here, here}).distance == 1e300);
  CHECK(distance(bodies, {here, {{1, 0, 0, 0}, {1e300, 0x1p-1074, 0}}}).distance == 0x1p-1074);
  CHECK(std::isinf(distance(bodies, {{{1, 0, 0, 0}, {1.7e308, 0, 0}}, {{1, 0, 0, 0}, {-1.7e308, 0, 0}}}).distance));
  bodies.rules.body_pairs = {{0, 1}};
  found = distance(bodies, {here, here});
  CHECK(std::isinf(found.distance));
  CHECK(found.excluded == 1);
  CHECK(std::isinf(distance(Bodies{}, {}).distance));
  CHECK_THROWS_AS(distance(bodies, {here}), InvalidQuery);
  CHECK_THROWS_AS(distance(bodies, {here, {{0, 0, 0, 0}, {}}}), InvalidQuery);
}
