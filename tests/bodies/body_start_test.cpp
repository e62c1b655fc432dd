// Bodies at the start of a run: pierced ones are refused, enclosed ones are told. Turns that a step could lose.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include <touchstone/error.hpp>

#include "bodies_support.hpp"
#include "scene/body_shapes.hpp"
#include "scene/parts.hpp"
#include "sim/left_out.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using namespace touchstone::tests;

namespace {

/// A free box of 1 m around the origin.
Scene one_box() {
  Scene scene = empty_scene(1.0 / 60);
  scene.bodies = {box_at({1, 1, 1}, {0, 0, 0})};
  return scene;
}

void check_refused(const Scene& scene, const std::string& what) {
  CHECK_THROWS_WITH(Simulation(scene, {}), Catch::Contains("the scene begins with elements that pierce each other: ") &&
                                               Catch::Contains(what));
}

std::string verdict(const Scene& scene) {
  Simulation simulation(scene, {});
  simulation.step();
  return left_out_for_person(simulation, 1);
}

/// A bar of 2 m along the x axis, driven.
Body bar() {
  Body body = box({2, 0.1, 0.1}, 0);
  body.motion = BodyMotion::driven;
  return body;
}

}  // namespace

TEST_CASE("springs, cables and cloth that a body pierces, or that pierce it, are refused") {
  Scene scene = one_box();
  SECTION("a spring through the box") {
    add_spring(scene, add_particle(scene, {0.1, 0.2, -2}, 1), add_particle(scene, {0.1, 0.2, 2}, 1), 1, 0, true);
    check_refused(scene, "edge 0-1 and face ");
    check_refused(scene, " of body 0 at (0.1, 0.2, ");
  }
  SECTION("a solid cable that ends in the box") {
    Cable cable = straight_cable(scene, {0.1, 0.2, 0}, {0.1, 0.2, 2}, 1);
    set_material(cable, 1e6, 0.3, 0.01, 1000);
    cable.solid = true;
    scene.cables.push_back(cable);
    check_refused(scene, "edge 0-1 and face ");
  }
  SECTION("edges of the box through cloth") {
    for (const Vector3& x : {Vector3(-3, -3, 0.1), Vector3(3, -3, 0.1), Vector3(0, 4, 0.1)}) {
      add_particle(scene, x, 1);
    }
    Surface sheet;
    sheet.faces = {{0, 1, 2}};
    sheet.stretch = 100;
    sheet.areal_density = 0.1;
    scene.surfaces = {sheet};
    check_refused(scene, " of body 0 and face 0-1-2 at (-0.5, -0.5, 0.1)");
  }
  SECTION("an edge of a wire frame through a face") {
    scene.bodies[0] = Body();
    scene.bodies[0].vertices = {{0, 0, -1}, {0, 0, 1}, {1, 0, 1}};
    scene.bodies[0].edges = {{0, 1}, {1, 2}};
    scene.bodies[0].density = 1;
    for (const Vector3& x : {Vector3(-1, -1, 0), Vector3(1, -1, 0), Vector3(0, 1, 0)}) add_pinned(scene, x);
    scene.faces = {{{0, 1, 2}}};
    check_refused(scene, "edge 0-1 of body 0 and face 0-1-2 at (0, 0, 0)");
  }
}

TEST_CASE("fixed bodies may intersect each other and what is pinned, and the verdict counts it") {
  Scene scene = one_box();
  scene.bodies[0] = fixed(scene.bodies[0]);
  scene.bodies.push_back(fixed(box({0.5, 0.5, 3}, 0)));
  scene.wires = {{{add_pinned(scene, {0.3, 0.3, -2}), add_pinned(scene, {0.31, 0.32, 2})}}};
  add_particle(scene, {9, 9, 9}, 1);
  CHECK_THAT(verdict(scene), Catch::StartsWith("; left out: pairs among 1 element and 2 bodies that cannot move (") &&
                                 Catch::Contains(" of which intersect)"));
  scene.bodies[1].motion = BodyMotion::driven;
  CHECK_THROWS_WITH(Simulation(scene, {}), Catch::Contains("begins with elements that"));
}

TEST_CASE("what is wholly inside a closed body is told") {
  Scene scene = one_box();
  CHECK(verdict(scene) == "; warning: only one element or body collides, so no pair was asked about");
  add_particle(scene, {2, 0, 0}, 1);
  CHECK(verdict(scene).empty());
  add_particle(scene, {0, 0, 0}, 1);  // in line with corners, edges and the diagonals of faces
  CHECK(verdict(scene) ==
        "; 1 part wholly inside a closed body at the start, without contact of surfaces (particle 1 in body 0)");
  scene.bodies.push_back(box_at({0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}));
  scene.wires = {{{add_particle(scene, {-0.1, 0, 0}, 1), add_particle(scene, {-0.2, 0, 0}, 1)}}};
  CHECK(verdict(scene) ==
        "; 3 parts wholly inside a closed body at the start, without contact of surfaces (particle 1 in body 0, ...)");
  // The sides of faces do not count for a body that needs no mass.
  scene.bodies[0] = fixed(scene.bodies[0]);
  std::swap(scene.bodies[0].faces[2][0], scene.bodies[0].faces[2][1]);
  CHECK(verdict(scene).find("; 3 parts wholly inside a closed body") != std::string::npos);
  // An open body has no inside.
  scene.bodies[0].faces.pop_back();
  CHECK(verdict(scene).find("wholly inside") == std::string::npos);
  CHECK(verdict(scene).find("; 3 parts in the box around an open surface at the start") != std::string::npos);
}

TEST_CASE("a driven body that turns by a whole turn in a step is not at rest") {
  Scene scene = empty_scene(1.0 / 60);
  scene.bodies = {bar()};
  scene.bodies[0].angular_velocity = {0, 0, 2 * std::numbers::pi * 60};
  // In its way, and apart from it at the ends of the step.
  add_pinned(scene, {0, 0.8, -1});
  add_pinned(scene, {0, 0.8, 1});
  scene.wires = {{{0, 1}}};
  Simulation simulation(scene, {});
  CHECK_THROWS_WITH(simulation.step(), Catch::Contains("of body 0"));

  scene.wires.clear();
  scene.particles.clear();
  Simulation free(scene, {});
  CHECK(free.step().size() == 8);  // 2 pi in parts of at most 1 rad
}

TEST_CASE("a path whose next pose is past half a turn in between is followed, not cut short") {
  Scene scene = empty_scene(1);
  scene.bodies = {bar()};
  const auto about_z = [](double angle) { return Quaternion{std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; };
  for (int i = 0; i <= 4; ++i) {  // a whole turn within the first step
    scene.bodies[0].path.push_back({0.25 * i, {about_z(std::numbers::pi / 2 * i), {0, 0, 0}}});
  }
  add_pinned(scene, {0, 0.8, -1});
  add_pinned(scene, {0, 0.8, 1});
  scene.wires = {{{0, 1}}};
  Simulation simulation(scene, {});
  CHECK_THROWS_WITH(simulation.step(), Catch::Contains("of body 0"));
}

TEST_CASE("the sign of a quaternion in a path means nothing: a body takes the shorter turn") {
  const auto end_of = [](double sign) {
    Scene scene = empty_scene(1.0 / 60);
    scene.bodies = {bar()};
    const auto about_z = [](double angle) { return Quaternion{std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; };
    for (int i = 0; i < 4; ++i) {
      Quaternion q = about_z(0.4 * i);
      if (i % 2 == 1) q = {sign * q[0], 0, 0, sign * q[3]};
      scene.bodies[0].path.push_back({0.2 * i, {q, {0, 0, 0}}});
    }
    // Where the longer turn would lead.
    add_pinned(scene, {0, 0.8, -1});
    add_pinned(scene, {0, 0.8, 1});
    scene.wires = {{{0, 1}}};
    Simulation simulation(scene, {});
    std::vector<Matrix3> turns;
    for (int i = 0; i < 30; ++i) {
      CHECK(simulation.step().size() == 1);
      turns.push_back(matrix_of(simulation.bodies()->state().bodies[0].pose.q));
    }
    return turns;
  };
  CHECK((end_of(1) == end_of(-1)));
}
