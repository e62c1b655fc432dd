// Bodies that push particles onto other particles: strings, grains and cloth between a body and a floor.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "bodies_support.hpp"
#include "scene/parts.hpp"
#include "scene/sheet.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone::sim;
using namespace touchstone::tests;

namespace {

Body frame_at(const Vector3& at) {
  Body frame;
  frame.vertices = {{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}};
  frame.edges = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
  frame.density = 1;
  frame.pose.p = at;
  return frame;
}

/// A floor of particles that nothing moves, and gravity.
Scene floor_scene() {
  Scene scene;
  scene.settings.contact.friction = 0.3;
  scene.settings.contact.thickness = 2e-3;
  add_floor(scene, 1);
  return scene;
}

void add_string(Scene& scene, double y, double z, bool solid) {
  Cable cable = straight_cable(scene, {-0.2, y, z}, {0.2, y + 0.05, z + 0.01}, 8);
  set_material(cable, 1e7, 0.4, 0.003, 1200);
  cable.damping = 2e-3;
  cable.solid = solid;
  scene.cables.push_back(cable);
}

struct Run {
  double highest = 0;  // of the body's centre, at the end
  double lowest = 1;   // of the particles above the floor, ever
  std::size_t substeps = 0;
  std::uint64_t contacts = 0;
};

/// The floor has the first four particles.
Run run(const Scene& scene, std::size_t steps) {
  Simulation simulation(scene, {});
  Run run;
  for (std::size_t i = 0; i < steps; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      ++run.substeps;
      run.contacts += record.bodies.contacts + record.bodies.close;
    }
    for (Index p = 4; p < scene.particles.size(); ++p) {
      run.lowest = std::min(run.lowest, position(simulation.state().q, p).z());
    }
  }
  CHECK(simulation.crossings().empty());
  run.highest = simulation.bodies()->state().bodies[0].pose.p.z();
  return run;
}

}  // namespace

TEST_CASE("a frame that falls on strings presses them on the floor, and not through it") {
  for (const bool solid : {false, true}) {
    CAPTURE(solid);
    Scene scene = floor_scene();
    for (int i = 0; i < 4; ++i) add_string(scene, 0.1 * i, 0.02 + 0.02 * i, solid);
    scene.bodies = {frame_at({0, 0.15, 0.3})};
    const std::size_t steps = effort(90);
    const Run result = run(scene, steps);
    CHECK(result.lowest > (solid ? 0.003 : 0.0));
    if (!whole_effort("strings under a frame")) continue;
    CHECK(result.contacts > 0);
    CHECK(result.highest > 0);
    CHECK(result.highest < 0.05);
    // At rest, what pushes store is what the integrator released, and no substep is cut for it.
    CHECK(result.substeps < steps + steps / 4);
  }
}

TEST_CASE("a box that falls on grains and on cloth keeps them above the floor") {
  Scene scene = floor_scene();
  for (int i = 0; i < 9; ++i) {
    add_particle(scene, {-0.3 + 0.03 * (i % 3), -0.03 + 0.03 * (i / 3), 0.001}, 0.01);
  }
  const std::size_t others = scene.particles.size();
  Surface cloth;
  cloth.faces = add_sheet(scene, {{0.2, -0.1, 0.01}, {0.2, 0, 0}, {0, 0.2, 0}, 4}).faces;
  cloth.stretch = 50;
  cloth.bend = 1e-5;
  for (std::size_t p = others; p < scene.particles.size(); ++p) scene.particles[p].mass = 1e-3;
  scene.surfaces.push_back(cloth);
  scene.bodies = {box_at({0.2, 0.2, 0.1}, {-0.27, 0, 0.3}), box_at({0.1, 0.1, 0.1}, {0.3, 0, 0.3})};
  const std::size_t steps = effort(60);
  const Run result = run(scene, steps);
  CHECK(result.lowest > 0);
  if (!whole_effort("grains and cloth under boxes")) return;
  CHECK(result.contacts > 0);
  CHECK(result.highest < 0.06);
  CHECK(result.substeps < 8 * steps);
}

TEST_CASE("a refusal of bodies names the distance that their radii ask for") {
  for (const double radius : {0.0, 0.01}) {
    CAPTURE(radius);
    Scene scene = empty_scene(1.0 / 100);
    Body press = box_at({0.2, 0.2, 0.2}, {0, 0, 0.5}, 0), anvil = box_at({0.1, 0.3, 0.2}, {0.02, 0.01, 0}, 0);
    press.motion = BodyMotion::driven;
    press.path = {{0, {{1, 0, 0, 0}, {0, 0, 0.5}}}, {0.1, {{1, 0, 0, 0}, {0, 0, 0.1}}}};
    anvil.motion = BodyMotion::fixed;
    press.radius = anvil.radius = radius;
    scene.bodies = {press, anvil};
    Simulation simulation(scene, {});
    const auto all = [&] {
      for (int i = 0; i < 10; ++i) simulation.step();
    };
    CHECK_THROWS_WITH(all(), Catch::Contains(radius > 0 ? " of body 1 would come within 0.02 m at ("
                                                        : " of body 1 would touch at (") &&
                                 Catch::Contains(", and find no way apart"));
  }
}
