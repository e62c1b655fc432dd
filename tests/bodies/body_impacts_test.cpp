// Impacts of bodies: their order in time, their energy, and bodies that nothing parts.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include "bodies_support.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone::sim;
using namespace touchstone::tests;

namespace {

/// Equal boxes in a row, so near to each other that the first one's impact runs through all of them in one step.
Scene cradle(int boxes, double restitution) {
  Scene scene = empty_scene(1.0 / 50);
  scene.settings.contact.restitution = restitution;
  for (int i = 0; i < boxes; ++i) scene.bodies.push_back(box_at({0.1, 0.1, 0.1}, {0.105 * i, 0, 0}));
  scene.bodies[0].velocity = {2, 0, 0};
  return scene;
}

double speed(const Simulation& simulation, std::size_t body) {
  return simulation.bodies()->state().bodies[body].velocity.x();
}

SimulationOptions measured() {
  SimulationOptions options;
  options.measure_flows = true;
  return options;
}

}  // namespace

TEST_CASE("an impact runs through a row of boxes in the order of time") {
  Simulation elastic(cradle(4, 1), {});
  REQUIRE(elastic.step().size() == 1);
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(speed(elastic, i)) < 1e-4);
  CHECK(speed(elastic, 3) == Approx(2).epsilon(1e-4));

  // Each impact leaves (1 - e) / 2 of the speed, and hands on (1 + e) / 2.
  Simulation half(cradle(3, 0.5), {});
  REQUIRE(half.step().size() == 1);
  CHECK(speed(half, 0) == Approx(0.5).epsilon(1e-4));
  CHECK(speed(half, 1) == Approx(0.375).epsilon(1e-4));
  CHECK(speed(half, 2) == Approx(1.125).epsilon(1e-4));
}

TEST_CASE("the energy of an impact is that of its restitution, and no other column has it") {
  for (const double e : {0.0, 0.6, 1.0}) {
    CAPTURE(e);
    Scene scene = empty_scene(1.0 / 100);
    scene.settings.contact.restitution = e;
    scene.bodies = {box_at({0.1, 0.1, 0.1}, {0, 0, 0}), box_at({0.1, 0.1, 0.1}, {0.14, 0, 0}, 1500)};
    scene.bodies[0].velocity = {3, 0, 0};
    Simulation simulation(scene, measured());
    EnergyFlows flows;
    double numerical = 0;
    const double before = simulation.energies().total();
    for (int i = 0; i < 5; ++i) {
      for (const SubstepRecord& record : simulation.step()) {
        flows += record.flows;
        numerical += record.numerical;
      }
    }
    const double m1 = 0.5, m2 = 1.5, expected = -(1 - e * e) / 2 * (m1 * m2 / (m1 + m2)) * 9;
    CHECK(flows.impacts == Approx(expected).margin(1e-6));
    CHECK(std::abs(flows.friction) < 1e-9);
    CHECK(std::abs(numerical) < 1e-9);
    CHECK(simulation.energies().total() - before == Approx(flows.total() + numerical).margin(1e-12));
  }
}

TEST_CASE("a box that slides gives its energy to friction, and one that is pushed gets it from its driver") {
  const double friction = 0.3, weight = 9.81;
  Scene scene = empty_scene(1.0 / 200);
  scene.settings.gravity = {0, 0, -weight};
  scene.settings.contact.friction = friction;
  scene.settings.contact.restitution = 0;
  Body ground = box_at({20, 20, 1}, {0, 0, -0.5}, 0);
  ground.motion = BodyMotion::fixed;
  scene.bodies = {ground, box_at({0.4, 0.4, 0.1}, {0, 0, 0.051})};
  scene.bodies[1].velocity = {1, 0, 0};
  const double mass = 500 * 0.4 * 0.4 * 0.1;
  const auto run = [](Simulation& simulation, int steps) {
    EnergyFlows flows;
    for (int i = 0; i < steps; ++i) {
      for (const SubstepRecord& record : simulation.step()) flows += record.flows;
    }
    return flows;
  };
  Simulation slides(scene, measured());
  const EnergyFlows slid = run(slides, 100);
  CHECK(slid.friction == Approx(-0.5 * mass).epsilon(0.02));  // it comes to rest
  CHECK(slides.energies().kinetic < 1e-6 * mass);
  CHECK(std::abs(slid.driven) < 1e-9);

  scene.bodies[1].velocity = {0, 0, 0};
  Body pusher = box_at({0.1, 0.2, 0.06}, {-0.26, 0, 0.051}, 0);
  pusher.motion = BodyMotion::driven;
  pusher.velocity = {0.5, 0, 0};
  scene.bodies.push_back(pusher);
  Simulation pushed(scene, measured());
  const double start = pushed.bodies()->state().bodies[1].pose.p.x();
  const EnergyFlows flows = run(pushed, 200);
  const double way = pushed.bodies()->state().bodies[1].pose.p.x() - start;
  CHECK(way > 0.4);
  CHECK(flows.friction == Approx(-friction * mass * weight * way).epsilon(0.05));
  // The first impact takes as much as it gives.
  CHECK(flows.driven == Approx(friction * mass * weight * way + 2 * pushed.energies().kinetic).epsilon(0.05));
}

TEST_CASE("boxes at rest give no energy to any column") {
  Scene scene = empty_scene(1.0 / 100);
  scene.settings.gravity = {0, 0, -9.81};
  scene.settings.contact.friction = 0.5;
  Body ground = box_at({2, 2, 1}, {0, 0, -0.5}, 0);
  ground.motion = BodyMotion::fixed;
  scene.bodies = {ground, box_at({0.2, 0.2, 0.2}, {0, 0, 0.101}), box_at({0.2, 0.2, 0.2}, {0.02, 0, 0.302})};
  Simulation simulation(scene, measured());
  for (int i = 0; i < 50; ++i) simulation.step();
  // J: a step's fall would give 4 kg g^2 h^2 / 2 to each.
  for (int i = 0; i < 20; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      CHECK(std::abs(record.flows.impacts) < 1e-6);
      CHECK(std::abs(record.flows.friction) < 1e-6);
      CHECK(std::abs(record.flows.driven) < 1e-12);
      CHECK(std::abs(record.numerical) < 1e-6);
    }
  }
}

TEST_CASE("drag on bodies is in its column") {
  Scene scene = empty_scene(1.0 / 100);
  scene.settings.drag = 0.5;
  scene.bodies = {box_at({0.1, 0.2, 0.3}, {0, 0, 0})};
  scene.bodies[0].velocity = {1, 2, 3};
  scene.bodies[0].angular_velocity = {3, 1, 2};
  Simulation simulation(scene, measured());
  const double before = simulation.energies().total();
  double drag = 0, numerical = 0;
  for (int i = 0; i < 50; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      drag += record.flows.drag;
      numerical += std::abs(record.numerical);
    }
  }
  CHECK(drag == Approx(before * (std::exp(-0.5) - 1)).epsilon(1e-3));
  CHECK(numerical < 1e-9 * before);
}

TEST_CASE("bodies that nothing parts move as one: with their momentum, and without a touch") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int merged = 0, tried = 0;
  for (std::size_t run = 0; run < effort(100); ++run) {
    // A clump that falls into itself: so much in one substep that impulses find no way.
    Scene scene = empty_scene(1.0 / 10);
    scene.settings.contact.thickness = 1e-5;
    scene.settings.contact.restitution = 0;
    scene.settings.contact.friction = 0.5;
    for (int i = 0; i < 8; ++i) {
      const Vector3 at((i & 1 ? 0.06 : -0.06), (i & 2 ? 0.06 : -0.06), (i & 4 ? 0.06 : -0.06));
      Body body = box_at({0.1, 0.1 + 0.005 * unit(random), 0.1}, at);
      body.velocity = -5 * at + 0.3 * Vector3(unit(random), unit(random), unit(random));
      body.angular_velocity = 4 * Vector3(unit(random), unit(random), unit(random));
      scene.bodies.push_back(body);
    }
    const Simulation simulation(scene, {});
    const Colliders& colliders = simulation.colliders();
    const BodyResponse response(colliders, simulation.system(), scene.settings);
    const BodiesState start = simulation.bodies()->state();
    const VectorX none;
    const BodyResult result = response.step(start, {0.1, 0.1, &none, none, &none, true});
    ++tried;
    if (result.refused || result.counts.zones == 0) continue;
    ++merged;
    CAPTURE(run, result.counts.zones);
    CHECK(!any_touch(colliders, start.bodies, result.end.bodies));
    const BodySystem& system = colliders.bodies();
    const Momentum before = momentum_of(system, start.bodies), after = momentum_of(system, result.end.bodies);
    CHECK((after.linear - before.linear).norm() < 1e-12 * 5);
    CHECK((after.angular - before.angular).norm() < 1e-12 * 5);
    CHECK(system.energies(result.end.bodies).kinetic <= system.energies(start.bodies).kinetic * (1 + 1e-9));
    CHECK(result.flows.impacts + result.flows.friction + result.flows.corrections ==
          Approx(system.energies(result.end.bodies).kinetic - system.energies(start.bodies).kinetic).epsilon(1e-6));
  }
  CAPTURE(tried, merged);
  if (whole_effort("groups that move as one")) CHECK(merged > 2);
}

TEST_CASE("a body that pushes a stiff spring by its end stores no more in it than the body loses") {
  Scene scene = empty_scene(1.0 / 240);
  scene.settings.contact.restitution = 0;
  for (int i = 0; i < 4; ++i) {
    scene.particles.emplace_back();
    scene.particles.back().position = {0.06 + 0.1 * i, 0.01, 0.005};
    scene.particles.back().mass = 0.02;
  }
  for (Index i = 0; i < 3; ++i) {
    Spring spring;
    spring.a = i;
    spring.b = i + 1;
    spring.rest_length = 0.1;
    spring.stiffness = 1e5;
    scene.springs.push_back(spring);
  }
  scene.bodies = {box_at({0.1, 0.1, 0.1}, {0, 0, 0})};
  scene.bodies[0].velocity = {4, 0, 0};
  Simulation simulation(scene, measured());
  const double before = simulation.energies().total();
  double most = before, gained = 0;
  std::uint64_t contacts = 0;
  const std::size_t steps = effort(24);
  for (std::size_t i = 0; i < steps; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      contacts += record.bodies.contacts + record.bodies.close;
      gained += std::max(record.numerical, 0.0);
    }
    most = std::max(most, simulation.energies().total());
  }
  // In a whole step the box moves the end of the first spring by 17 mm, which is 14 J of the 4 J that there are.
  CHECK(most < 1.002 * before);
  CHECK(gained < 0.05 * before);
  CHECK((contacts > 0 || !whole_effort("that the box meets the springs")));
}
