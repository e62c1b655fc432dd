// Bodies that turn at constant rates: the verdicts of all pairs of their elements, asked one by one.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <tuple>

#include <touchstone/touchstone.hpp>

#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("screws of bodies have the verdicts of all pairs of their elements") {
  seeded::Rng random(4106);
  std::size_t contacts = 0, opens = 0, frees = 0, sooner = 0;
  for (std::size_t i = 0; i < effort(60); ++i) {
    RandomBodies scene = random_bodies(random);
    for (RigidMotion& motion : scene.motions) {
      if (!random.one_in(3)) continue;
      motion.control_points = random.between(3, 4);
      for (Vec3& x : motion.inner) x = some_point(random, random.one_in(2), 3);
    }
    BodyScrewOptions options;
    options.check_start = false;
    options.most_arcs = 32;
    if (random.one_in(4)) options.t_max = random.uniform(0, 1);
    CAPTURE(i, options.t_max);
    std::vector<BodyScrewContact> open;
    double contact_by = options.t_max;
    bool contact = false;
    for (const BodyPair& pair : every_pair(scene.bodies)) {
      ScrewOptions one;
      one.t_max = options.t_max;
      one.separation = separation_of(scene.bodies, pair);
      one.most_arcs = options.most_arcs;
      const ScrewAnswer answer = solve_screw(query_of(scene.bodies, pair, scene.motions), one);
      if (answer.verdict == ScrewVerdict::free) continue;
      open.push_back({pair, answer});
      if (answer.verdict != ScrewVerdict::contact) continue;
      contact = true;
      contact_by = std::min(contact_by, answer.contact_by);
    }
    std::sort(open.begin(), open.end(), [](const BodyScrewContact& a, const BodyScrewContact& b) {
      return std::tie(a.answer.free_until, a.pair) < std::tie(b.answer.free_until, b.pair);
    });
    const BodyScrewAnswer found = solve_screw(scene.bodies, scene.motions, options);
    CHECK(found.contact_by == contact_by);
    CHECK((found.verdict == ScrewVerdict::contact) == contact);
    CHECK((found.verdict == ScrewVerdict::free) == found.pairs.empty());
    CHECK(found.free_until == (found.pairs.empty() ? options.t_max : found.pairs.front().answer.free_until));
    std::size_t n = 0;
    for (const BodyScrewContact& one : open) {
      if (one.answer.free_until > contact_by) continue;
      if (n < found.pairs.size() && found.pairs[n].pair == one.pair) {
        CHECK(found.pairs[n].answer.verdict == one.answer.verdict);
        ++n;
        continue;
      }
      // Left out by boxes around more arcs than its own: it does not meet by then.
      ScrewOptions finer;
      finer.t_max = contact_by;
      finer.separation = separation_of(scene.bodies, one.pair);
      finer.arcs = finer.most_arcs = 64;
      CHECK(solve_screw(query_of(scene.bodies, one.pair, scene.motions), finer).verdict == ScrewVerdict::free);
      ++sooner;
    }
    CHECK(n == found.pairs.size());
    options.threads = 3;
    CHECK(solve_screw(scene.bodies, scene.motions, options).free_until == found.free_until);
    contacts += contact ? 1 : 0;
    frees += open.empty() ? 1 : 0;
    opens += !contact && !open.empty() ? 1 : 0;
  }
  if (!whole_effort("that each verdict comes")) return;
  CHECK(contacts > 0);
  CHECK(frees > 0);
  CHECK(opens > 0);
  CHECK(sooner > 0);
}

TEST_CASE("a bar on a screw reaches a wall at the angle of its corner") {
  Bodies bodies;
  bodies.bodies = {box(1, 1, 3), box(0.25, 8, 8)};
  std::vector<RigidMotion> motions(2);
  const double s = std::sqrt(0.5);
  motions[0].q1 = {s, 0, 0, s};
  motions[1].p0 = motions[1].p1 = {1.375 + 0.25, 0, 0};
  BodyScrewOptions options;
  options.arcs = 128;
  const BodyScrewAnswer hit = solve_screw(bodies, motions, options);
  CHECK(hit.verdict == ScrewVerdict::contact);
  const double right = std::acos(0.0), angle = right / 2 - std::acos(1.375 / std::sqrt(2.0));
  CHECK(hit.free_until <= angle / right);
  CHECK(hit.contact_by >= angle / right);
  CHECK(hit.contact_by - hit.free_until < 1e-5);
  CHECK(!hit.pairs.empty());
  CHECK(!hit.free());
  motions[1].p0.x = motions[1].p1.x = 1.4375 + 0.25;
  CHECK(solve_screw(bodies, motions).free());
  options.arcs = 3;
  CHECK_THROWS_AS(solve_screw(bodies, motions, options), InvalidQuery);
}

TEST_CASE("a box whose origin is on a curve flies over a wall, where the straight way meets it") {
  Bodies bodies;
  bodies.bodies = {box(0.5, 0.5, 0.5), box(0.25, 8, 2)};
  std::vector<RigidMotion> motions(2);
  motions[0].p0 = {-6, 0, 0}, motions[0].p1 = {6, 0, 0};
  motions[0].q1 = {1, 1, 0, 0};
  CHECK(solve_screw(bodies, motions).verdict == ScrewVerdict::contact);
  motions[0].control_points = 4;
  motions[0].inner = {{{-2, 0, 8}, {2, 0, 8}}};  // 6 high over the wall: at least 6 - sqrt(3) / 2, and the wall has 2
  CHECK(solve_screw(bodies, motions).free());
  motions[0].inner = {{{-2, 0, 3}, {2, 0, 3}}};  // 2.25 high
  CHECK(solve_screw(bodies, motions).verdict == ScrewVerdict::contact);
  // All that is exact refuses the curve, and names the body.
  const std::string name = "body 0: the position is on a curve of 4 control points; only solve_screw takes that";
  CHECK_THROWS_WITH(first_contact(bodies, motions), name);
  CHECK_THROWS_WITH(all_contacts(bodies, motions), name);
  CHECK_THROWS_WITH(candidates(bodies, motions), name);
  CHECK_THROWS_WITH(free_step(bodies, motions), name);
}
