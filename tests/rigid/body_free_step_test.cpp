// A free step of bodies is free when its end is asked about again, and ends at the first contact but for rounding.
// SPDX-License-Identifier: MIT
#include <touchstone/touchstone.hpp>

#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("the motion to the poses of a free step is free, pair by pair") {
  seeded::Rng random(4102);
  const std::size_t scenes = effort(40);
  int shortened = 0, whole = 0, stopped = 0;
  for (std::size_t i = 0; i < scenes; ++i) {
    const RandomBodies scene = random_bodies(random);
    CAPTURE(i);
    const FreeBodyStep step = free_step(scene.bodies, scene.motions);
    REQUIRE(step.poses.size() == scene.motions.size());
    if (step.outcome == StepOutcome::contact_at_start || step.outcome == StepOutcome::intersects_at_start) {
      ++stopped;
      CHECK(step.length == 0);
      CHECK(!(step.first_contact.at_start.empty() && step.first_contact.start_intersections.empty()));
      continue;
    }
    if (step.outcome == StepOutcome::no_room) continue;
    std::vector<RigidMotion> path = scene.motions;
    for (std::size_t b = 0; b < path.size(); ++b) {
      path[b].q1 = step.poses[b].orientation;
      path[b].p1 = step.poses[b].position;
    }
    for (const BodyPair& pair : every_pair(scene.bodies)) {
      SolveOptions options;
      options.separation = separation_of(scene.bodies, pair);
      options.method = Method::exact;
      CHECK(!solve(query_of(scene.bodies, pair, path), options).contact);
    }
    if (step.outcome == StepOutcome::whole) {
      ++whole;
      CHECK(step.length == 1);
      CHECK(step.poses[0].orientation == scene.motions[0].q1);
    } else {
      ++shortened;
      CHECK(step.length < step.first_contact.toi_upper);
      CHECK(step.length > step.first_contact.toi * (1 - 1e-9));
    }
  }
  if (!whole_effort("that each outcome comes")) return;
  CHECK(shortened > 0);
  CHECK(whole > 0);
  CHECK(stopped > 0);
}
