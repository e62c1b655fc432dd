// Stiff, light, tiny, far away: no NaN, no crossing, and no energy out of nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/shipped_scenes.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

using namespace touchstone::sim;

namespace {

struct Course {
  double first = 0, most = 0, last = 0;  // total energies, J
  double kinetic = 0;                    // J, at the end
  std::uint64_t contacts = 0;
};

/// Runs the scene. Energy may exceed what it was by what pushing out of the thickness lifts: the weight of everything
/// by the thickness each, and a hundredth.
Course run(const Scene& scene, int steps) {
  Simulation simulation(scene, {});
  Course course;
  course.first = course.most = simulation.energies().total();
  double scale = std::abs(simulation.energies().kinetic);
  for (int i = 0; i < steps; ++i) {
    for (const auto& record : simulation.step()) course.contacts += record.response.contacts + record.response.close;
    course.last = simulation.energies().total();
    course.most = std::max(course.most, course.last);
    scale = std::max(scale, simulation.energies().kinetic);
    REQUIRE(simulation.state().q.allFinite());
    REQUIRE(simulation.state().v.allFinite());
  }
  course.kinetic = simulation.energies().kinetic;
  CHECK(simulation.crossings().empty());
  const double lifted = simulation.system().force.cwiseAbs().sum() * simulation.thickness();
  CHECK(course.most <= course.first + lifted + 0.01 * scale);
  return course;
}

/// A cable that falls across a pinned wire, in the middle of it.
Scene cable_on_wire(const Vector3& origin, double young, double density, double radius) {
  Scene scene;
  scene.settings.contact.restitution = 0;
  scene.settings.contact.friction = 0.5;
  scene.settings.contact.thickness = 1e-3;
  const Index a = add_pinned(scene, origin + Vector3(0.013, -0.5, 0)),
              b = add_pinned(scene, origin + Vector3(0.01, 0.5, 0.001));
  scene.wires.push_back({a, b});
  Cable& cable = add_cable(scene, origin + Vector3(-0.5, 0.01, 0.05), origin + Vector3(0.51, -0.01, 0.05), 40);
  set_material(cable, young, 0.3, radius, density);
  cable.twist = 0;
  cable.damping = 1e-4;
  return scene;
}

}  // namespace

TEST_CASE("a steel cable of radius 1 mm at h = 1/60 s") {
  const Course course = run(cable_on_wire(Vector3::Zero(), 2e11, 7800, 1e-3), 90);
  CHECK(course.contacts > 0);
}

TEST_CASE("everything shifted by 1e6 m") {
  const Course course = run(cable_on_wire({1e6, -1e6, 1e6}, 2e8, 2000, 2e-3), 60);
  CHECK(course.contacts > 0);
}

TEST_CASE("a mass ratio of 1e4 and a stiffness jump of 1e6") {
  Scene scene = make_shipped_scene("chain", 20);
  CHECK(run(scene, 120).contacts > 0);
  // Every other link a million times softer.
  Scene jump;
  for (int i = 0; i <= 10; ++i) add_particle(jump, {0.1 * i, 0.01 * std::sin(2.0 * i), 0}, 0.01);
  jump.particles[0].fixed = {true, true, true};
  for (Index i = 0; i < 10; ++i) add_spring(jump, i, i + 1, i % 2 == 0 ? 1e7 : 10, 0, true);
  const Index a = add_pinned(jump, {0.33, -0.5, -0.2}), b = add_pinned(jump, {0.3, 0.5, -0.21});
  jump.wires.push_back({a, b});
  CHECK(run(jump, 120).contacts > 0);
}

TEST_CASE("segment lengths from 1 to 1000") {
  Scene scene = cable_on_wire(Vector3::Zero(), 1e8, 1200, 2e-3);
  Cable& cable = scene.cables[0];
  // Squeezed towards one end, geometrically.
  const std::size_t count = cable.particles.size();
  const double ratio = std::pow(1000.0, 1.0 / static_cast<double>(count - 2));
  double at = 0, length = 1;
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i, at += length, length *= ratio) places.push_back(at);
  for (std::size_t i = 0; i < count; ++i) {
    scene.particles[cable.particles[i]].position = {-0.5 + places[i] / places.back(), 0.01, 0.05};
  }
  scene.settings.contact.thickness = 5e-5;
  CHECK(run(scene, 60).contacts > 0);
}

TEST_CASE("a pile of cables rests, step after step") {
  Scene scene = make_shipped_scene("cable-drop", 60);
  const Course course = run(scene, 1500);
  CHECK(course.contacts > 1000);
}

TEST_CASE("a small pile of crossed cables rests for 100,000 steps") {
  // Two cables across two on the floor.
  Scene scene;
  scene.settings.contact.restitution = 0.1;
  scene.settings.contact.friction = 0.4;
  scene.settings.contact.thickness = 2e-3;
  for (int i = 0; i < 4; ++i) {
    const bool crosswise = i / 2 == 1;
    const double side = i % 2 == 0 ? -0.06 : 0.07, up = 0.01 + 0.01 * (i / 2) + 0.001 * i;
    const Vector3 from = crosswise ? Vector3(side, -0.11, up) : Vector3(-0.10, side, up);
    const Vector3 to = crosswise ? Vector3(side + 0.004, 0.10, up) : Vector3(0.11, side - 0.003, up);
    Cable& cable = add_cable(scene, from, to, 2);
    set_material(cable, 1e7, 0.4, 0.003, 1200);
    cable.twist = 0;
    cable.damping = 2e-3;
  }
  add_floor(scene, 1);
  const Course settling = run(scene, 600);
  const auto steps = static_cast<int>(touchstone::tests::effort(100'000));
  if (steps < 100'000) WARN(steps << " steps only: this build is slow, or TOUCHSTONE_EFFORT asks for fewer");
  const Course course = run(scene, steps);
  CHECK(course.contacts > static_cast<std::uint64_t>(steps));
  // Friction at rest creeps, and what creeps sinks. It never rises.
  CAPTURE(settling.last, course.last);
  CHECK(course.last <= 1.001 * settling.last);
  CHECK(course.kinetic < 1.5e-10);  // its 29 g are slower than a tenth of a millimetre a second
}

TEST_CASE("the whip at 100 m/s does not go through the wire") {
  Scene scene = make_shipped_scene("whip", 30);
  CHECK(run(scene, 20).contacts > 0);
}
