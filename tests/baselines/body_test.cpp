// The methods for whole bodies: right where they are known to be, and each of their known failures.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "baselines/body_baseline.hpp"
#include "families/body_scenes.hpp"
#include "support/catch.hpp"

namespace touchstone::tests {
namespace {

using baselines::body_methods;
using baselines::BodyBaseline;
using baselines::MovingBodies;
using baselines::Result;

Body box(double x, double y, double z) {
  const auto [elements, points] = families::box_shape(x, y, z);
  return {Mesh(elements), Positions(points)};
}

/// A blade of length 5 and thickness 0.01 makes a quarter turn about z, and passes a post at that time.
MovingBodies blade_and_post(double time, double post_at_radius = 4) {
  MovingBodies step;
  step.bodies.bodies = {box(5, 0.005, 1), box(0.01, 0.01, 0.5)};
  const double angle = 2 * std::atan(time);  // of the quaternion (1, 0, 0, t)
  const Vec3 post{post_at_radius * std::cos(angle), post_at_radius * std::sin(angle), 0};
  step.motions = {motion_between({}, {{1, 0, 0, 1}, {}}), motion_between({{1, 0, 0, 0}, post}, {{1, 0, 0, 0}, post})};
  return step;
}

const BodyBaseline& waypoints() { return body_methods().at(0); }
const BodyBaseline& advancement() { return body_methods().at(1); }

TEST_CASE("baselines of bodies: the registry") {
  CHECK(waypoints().name == "waypoints");
  CHECK(advancement().name == "body_advancement");
  for (const BodyBaseline& method : body_methods()) {
    CHECK(std::count(method.tolerances.begin(), method.tolerances.end(), method.usual_tolerance) == 1);
  }
}

TEST_CASE("baselines of bodies: a contact that lasts is found and not late, and bodies far apart are free") {
  MovingBodies step = blade_and_post(0.4567);
  step.motions[0].q1 = {1, 0, 0, 0.4567};  // it ends within the post
  const FirstBodyContact exact = first_contact(step.bodies, step.motions);
  REQUIRE(exact.contact);
  for (const BodyBaseline& method : body_methods()) {
    for (const double tolerance : method.tolerances) {
      CAPTURE(method.name, tolerance);
      const Result found = method.solve(step, tolerance);
      REQUIRE(found.contact);
      CHECK(found.toi <= exact.toi);
      CHECK(found.toi > exact.toi - 2 * tolerance);
    }
  }
  const MovingBodies apart = blade_and_post(0.4567, 6);
  CHECK(first_contact(apart.bodies, apart.motions).free());
  for (const BodyBaseline& method : body_methods()) CHECK_FALSE(method.solve(apart, method.usual_tolerance).contact);
}

TEST_CASE("baselines of bodies: waypoints miss a contact between two of them") {
  const MovingBodies step = blade_and_post(0.4551);  // it lasts from about 0.4535 to 0.4567
  REQUIRE(first_contact(step.bodies, step.motions).contact);
  CHECK_FALSE(waypoints().solve(step, 0.1).contact);
  CHECK_FALSE(waypoints().solve(step, 0.01).contact);
  CHECK(waypoints().solve(step, 0.001).contact);
}

TEST_CASE("baselines of bodies: advancement takes bodies within its tolerance for contacts") {
  const MovingBodies step = blade_and_post(0.4551, 5.0146);  // the tip passes a corner of the post by about 0.0005
  REQUIRE(first_contact(step.bodies, step.motions).free());
  CHECK(advancement().solve(step, 1e-3).contact);
  CHECK_FALSE(advancement().solve(step, 1e-6).contact);
}

TEST_CASE("baselines of bodies: where nothing moves there is no contact") {
  MovingBodies step = blade_and_post(0.5);
  step.motions[0] = {};
  for (const BodyBaseline& method : body_methods()) CHECK_FALSE(method.solve(step, method.usual_tolerance).contact);
}

}  // namespace
}  // namespace touchstone::tests
