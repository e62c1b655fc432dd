// Runs of scenes whose elements have radii: every pair of every step, measured exactly and without the simulator's
// code, stays farther apart than the sum of its radii. And motions whose outcome is known.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include <touchstone/error.hpp>

#include "scene/parts.hpp"
#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"
#include "sim/simulation.hpp"
#include "sim/thick_elements.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

struct MeasuredCourse {
  Nearness nearness;
  std::uint64_t contacts = 0, entering = 0, separated = 0, zones = 0;
};

/// Runs a scene, and measures it as a scene with the radii of `measured`.
MeasuredCourse measured_run(const Scene& scene, const Scene& measured, int steps, int first_measured = 0) {
  const ThickElements elements(measured);
  REQUIRE(!elements.pairs().empty());
  Simulation simulation(scene, {});
  MeasuredCourse course;
  for (int i = 0; i < steps; ++i) {
    const VectorX before = simulation.state().q;
    const auto records = simulation.step();
    for (const SubstepRecord& record : records) {
      course.contacts += record.response.contacts + record.response.close;
      course.entering += record.response.natures[static_cast<std::size_t>(touchstone::Nature::entering)];
      course.separated += record.proof.separations.pairs;
      course.zones += static_cast<std::uint64_t>(record.response.zones);
      CHECK(record.proof.crossings == 0);
      CHECK(record.proof.separations.pairs <= record.proof.pairs);
    }
    if (i < first_measured) continue;
    // The states at the ends of shorter substeps are not kept.
    const std::vector<double> times = records.size() == 1 ? std::vector<double>{0.375, 1} : std::vector{1.0};
    elements.measure(before, simulation.state().q, times, course.nearness);
  }
  return course;
}

MeasuredCourse measured_run(const Scene& scene, int steps, int first_measured = 0) {
  return measured_run(scene, scene, steps, first_measured);
}

/// A loose sphere.
Index add_sphere(Scene& scene, const Vector3& at, double radius, const Vector3& velocity) {
  const Index p = add_particle(scene, at, 0.1);
  scene.particles[p].radius = radius;
  scene.particles[p].velocity = velocity;
  return p;
}

}  // namespace

TEST_CASE("no two cables of radius r ever come nearer than 2 r, nor a cable to the floor nearer than r", "[slow]") {
  const MeasuredCourse course = measured_run(make_shipped_scene("cable-drop", std::nullopt), 120);
  CHECK(course.nearness.violations == 0);
  CHECK(course.nearness.exact > 500);
  CHECK(course.nearness.least_gap > 0);
  CHECK(course.nearness.least_gap < 2e-3);
  CHECK(course.contacts > 500);
  CHECK(course.entering > 0);
}

TEST_CASE("cables that are thrown at each other, with hardly a layer to push in and few impulses, keep their radii",
          "[slow]") {
  Scene scene = make_shipped_scene("cable-drop", 400);
  scene.settings.contact.thickness = GENERATE(1e-4, 1e-7);
  scene.settings.contact.passes = 1;
  int number = 0;
  for (const Cable& cable : scene.cables) {
    for (const Index p : cable.particles)
      scene.particles[p].velocity = {3.0 * (number % 3 - 1), 2.0 * (number % 2), -20};
    ++number;
  }
  const MeasuredCourse course = measured_run(scene, 40);
  CHECK(course.nearness.violations == 0);
  CHECK(course.nearness.exact > 1000);
  CHECK(course.nearness.least_gap > 0);
  CHECK(course.nearness.least_gap < 1e-4);
  CHECK(course.zones > 0);
}

TEST_CASE("the same cables without their radii come nearer, which the measurement sees", "[slow]") {
  const Scene solid = make_shipped_scene("cable-drop", std::nullopt);
  Scene thin = solid;
  for (Cable& cable : thin.cables) cable.solid = false;
  const MeasuredCourse course = measured_run(thin, solid, 30);
  CHECK(course.entering == 0);
  CHECK(course.separated == 0);
  CHECK(course.nearness.violations > 100);
}

TEST_CASE("ball, net and rim of the hoop keep their radii") {
  const MeasuredCourse course = measured_run(make_shipped_scene("hoop", 200), 75, 20);
  CHECK(course.nearness.violations == 0);
  CHECK(course.nearness.exact > 100);
  CHECK(course.contacts > 100);
}

TEST_CASE("a heap of spheres, thick edges and a thick sheet") {
  Scene scene;
  scene.settings.contact.restitution = 0.3;
  scene.settings.contact.friction = 0.3;
  scene.settings.contact.thickness = 1e-4;
  // A sheet that hangs by its corners, of 6 x 6 particles.
  constexpr Index kSide = 6;
  for (Index i = 0; i < kSide * kSide; ++i) {
    const bool corner = (i % kSide == 0 || i % kSide == kSide - 1) && (i < kSide || i >= kSide * (kSide - 1));
    const Vector3 at(0.05 * (i % kSide), 0.05 * static_cast<double>(i / kSide), 0);
    corner ? add_pinned(scene, at) : add_particle(scene, at, 0.01);
  }
  for (Index y = 0; y < kSide; ++y) {
    for (Index x = 0; x < kSide; ++x) {
      const Index p = y * kSide + x;
      if (x + 1 < kSide) add_spring(scene, p, p + 1, 500, 0.2, true);
      if (y + 1 < kSide) add_spring(scene, p, p + kSide, 500, 0.2, true);
      if (x + 1 == kSide || y + 1 == kSide) continue;
      add_spring(scene, p, p + kSide + 1, 500, 0.2, true);
      scene.faces.push_back({{p, p + 1, p + kSide + 1}, 3e-3});
      scene.faces.push_back({{p, p + kSide + 1, p + kSide}, 3e-3});
    }
  }
  for (int i = 0; i < 6; ++i) {
    const double angle = 2.4 * i, z = 0.05 + 0.04 * i;
    add_sphere(scene, {0.125 + 0.04 * std::cos(angle), 0.12 + 0.04 * std::sin(angle), z}, 0.012 + 1e-3 * i, {0, 0, -1});
    const Index a = add_particle(scene, {0.03, 0.1 + 0.01 * i, z + 0.02}, 0.02);
    const Index b = add_particle(scene, {0.22, 0.11 + 0.012 * i, z + 0.021}, 0.02);
    add_spring(scene, a, b, 2000, 0.5, true);
    scene.springs.back().radius = 4e-3;
  }
  const MeasuredCourse course = measured_run(scene, 60);
  CHECK(course.nearness.violations == 0);
  CHECK(course.nearness.exact > 1000);
  CHECK(course.entering > 100);
}

TEST_CASE("the legs of one bent cable keep two radii, and its bend is no obstacle to itself") {
  constexpr double kRadius = 0.01, kBend = 0.03, kSegment = 0.006;
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.contact.restitution = 0;
  scene.settings.contact.thickness = 1e-4;
  scene.settings.drag = 1;
  scene.settings.time_step = 1.0 / 240;
  Cable cable;
  const auto add = [&](const Vector3& at, double speed) {
    cable.particles.push_back(add_particle(scene, at, 0));
    scene.particles.back().velocity = {0, speed, 1e-3};
  };
  constexpr int kLeg = 30, kArc = 15;
  for (int i = kLeg; i > 0; --i) add({kSegment * i, -kBend, 0}, 3.0 * i / kLeg);
  for (int i = 0; i <= kArc; ++i) {
    const double angle = 3.141592653589793 * i / kArc;
    add({-kBend * std::sin(angle), -kBend * std::cos(angle), 0}, 0);
  }
  for (int i = 1; i <= kLeg; ++i) add({kSegment * i, kBend, 0}, -3.0 * i / kLeg);
  set_material(cable, 2e4, 0.4, kRadius, 1000);
  cable.twist = 0;
  cable.damping = 1e-2;
  cable.solid = true;
  scene.cables.push_back(cable);
  const MeasuredCourse course = measured_run(scene, 30);
  CHECK(course.nearness.violations == 0);
  CHECK(course.nearness.exact > 500);
  CHECK(course.nearness.least_gap < 2e-3);
  CHECK(course.contacts > 20);
}

TEST_CASE("two parallel cables that are thrown against one another stop two radii apart") {
  constexpr double kRadius = 0.01, kThickness = 2e-4, kStep = 1e-3;
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.time_step = kStep;
  scene.settings.contact.restitution = 0;
  scene.settings.contact.thickness = kThickness;
  for (const double side : {-1.0, 1.0}) {
    Cable cable = straight_cable(scene, {0, 0.05 * side, 0}, {0.6, 0.05 * side, 0}, 10);
    set_material(cable, 1e7, 0.4, kRadius, 1000);
    cable.solid = true;
    for (const Index p : cable.particles) scene.particles[p].velocity = {0, -side, 0};
    scene.cables.push_back(cable);
  }
  Simulation simulation(scene, {});
  for (int i = 0; i < 80; ++i) {
    simulation.step();
    for (Index p = 0; p < 11; ++p) {
      // Parallel at all times, so the distance of two opposite particles is that of the cables.
      const double apart = position(simulation.state().q, p + 11).y() - position(simulation.state().q, p).y();
      CAPTURE(i, p, apart);
      CHECK(apart > 2 * kRadius);
      // An impulse may end the approach at the start of the step, and each cable moves at 1 m/s.
      if (i >= 40) CHECK(apart < 2 * kRadius + 2 * kStep + kThickness);
    }
  }
  CHECK(simulation.energies().kinetic < 1e-3 * Simulation(scene, {}).energies().kinetic);
}

TEST_CASE("a sphere rests on a floor with a thickness, and two spheres rebound at the sum of their radii") {
  constexpr double kRadius = 0.02, kFloor = 0.005, kThickness = 1e-4;
  Scene scene;
  scene.settings.time_step = 1e-3;
  scene.settings.contact.restitution = 0;
  scene.settings.contact.thickness = kThickness;
  add_floor(scene, 1);
  for (Facet& face : scene.faces) face.radius = kFloor;
  const Index falling = add_sphere(scene, {0.1, 0.2, 0.3}, kRadius, {0, 0, 0});
  Simulation simulation(scene, {});
  for (int i = 0; i < 600; ++i) {
    simulation.step();
    CHECK(position(simulation.state().q, falling).z() > kRadius + kFloor);
  }
  CHECK(position(simulation.state().q, falling).z() < kRadius + kFloor + 2 * kThickness);
  CHECK(simulation.state().v.head(3 * 5).norm() < 1e-6);

  Scene two;
  two.settings.gravity.setZero();
  two.settings.contact.restitution = 1;
  two.settings.time_step = 1e-3;
  two.settings.contact.thickness = kThickness;
  add_sphere(two, {0, 0, 0}, 0.03, {0.5, 0, 0});
  add_sphere(two, {0.2, 0, 0}, 0.05, {-0.5, 0, 0});
  Simulation pair(two, {});
  double nearest = 1;
  for (int i = 0; i < 200; ++i) {
    pair.step();
    nearest = std::min(nearest, position(pair.state().q, 1).x() - position(pair.state().q, 0).x());
  }
  CHECK(nearest > 0.08);
  CHECK(nearest < 0.08 + 1e-3 + kThickness);  // the way of a step, or the layer in which they are pushed apart
  CHECK(pair.state().v[0] == Approx(-0.5));
  CHECK(pair.state().v[3] == Approx(0.5));
}

TEST_CASE("a scene or checkpoint that begins with a pair within its separation is refused with both distances") {
  Scene scene;
  for (const double y : {0.0, 0.125}) {
    const Index a = add_particle(scene, {-1, y, 0}, 1), b = add_particle(scene, {1, y, 0}, 1);
    scene.wires.push_back({{a, b}, 0.0625});
  }
  const std::string reason =
      "begins with elements that are too near: edge 0-1 and edge 2-3 are 0.125 m apart, and their radii ask for more "
      "than 0.125 m; smaller radii, or elements farther apart, would be right";
  CHECK_THROWS_WITH(Simulation(scene, {}), "the scene " + reason);
  for (const Index p : {2u, 3u}) scene.particles[p].position.y() = std::nextafter(0.125, 1);
  scene.settings.gravity.setZero();
  Simulation simulation(scene, {});
  CHECK(simulation.colliders().separation({touchstone::Kind::edge_edge, 0, 1}) == 0.125);

  State state = simulation.state();
  for (const Eigen::Index y : {7, 10}) state.q[y] = 0.125;
  CHECK_THROWS_WITH(simulation.resume(state, 0), "q: the checkpoint " + reason);
  CHECK(simulation.state().q[7] > 0.125);

  // The narrow phase of the paper knows no separation, and says so.
  for (const Index p : {2u, 3u}) scene.particles[p].position.y() = 0.1;
  SimulationOptions paper;
  paper.narrow_phase = NarrowPhase::paper;
  CHECK(Simulation(scene, paper).ignores_radii());
  CHECK_FALSE(simulation.ignores_radii());
}

TEST_CASE("a pair that has no room is named with its separation") {
  // A thick wire is driven towards another one that is held.
  Scene scene;
  scene.settings.gravity.setZero();
  const Index a = add_pinned(scene, {-1, 0, 0}), b = add_pinned(scene, {1, 0, 0});
  const Index c = add_pinned(scene, {0, -1, 0.5}), d = add_pinned(scene, {0, 1, 0.5});
  for (const Index p : {c, d}) {
    const Vector3 from = scene.particles[p].position;
    scene.particles[p].path = {{0, from}, {1, from - Vector3(0, 0, 1)}};
  }
  scene.wires = {{{a, b}, 0.1}, {{c, d}, 0.15}};
  Simulation simulation(scene, {});
  std::string message;
  try {
    for (int i = 0; i < 60; ++i) simulation.step();
  } catch (const touchstone::Error& error) {
    message = error.what();
  }
  CHECK_THAT(message,
             Catch::Contains("edge 0-1 and edge 2-3 would come within 0.25 m at (0, 0, 0), and nothing of them"));
  CHECK(position(simulation.state().q, 2).z() > 0.25);
  CHECK(position(simulation.state().q, 2).z() < 0.25 + 1.001 / 60);  // within a step of it
}
