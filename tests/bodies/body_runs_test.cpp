// Runs of bodies: free flight, collisions, rest, and what may never change.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include <cmath>
#include <numbers>

#include "bodies_support.hpp"
#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"
#include "sim/output_text.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using namespace touchstone::tests;

TEST_CASE("a racket that is thrown flips, keeps its angular momentum to the last bit, and flies a parabola") {
  Scene scene = empty_scene(1.0 / 60);
  scene.settings.gravity = {0, 0, -9.81};
  scene.bodies.push_back(box_at({0.3, 0.2, 0.02}, {0, 0, 0}));
  scene.bodies[0].angular_velocity = {0.01, 10, 0};
  scene.bodies[0].velocity = {1, 2, 3};
  Simulation simulation(scene, {});
  const Vector3 momentum = simulation.bodies()->state().bodies[0].momentum;
  const double energy = simulation.energies().total();
  double least = 1, most = -1;
  for (int i = 0; i < 600; ++i) {
    simulation.step();
    const BodyState& state = simulation.bodies()->state().bodies[0];
    REQUIRE(state.momentum == momentum);
    REQUIRE(std::abs(simulation.energies().total() - energy) < 1e-9 * simulation.energies().kinetic);
    const double along = turned_back(state.pose.q, momentum).y() / momentum.norm();
    least = std::min(least, along);
    most = std::max(most, along);
  }
  CHECK(least < -0.9);
  CHECK(most > 0.9);
  const double t = simulation.state().time;
  const Vector3 expected = t * Vector3(1, 2, 3) + 0.5 * t * t * Vector3(0, 0, -9.81);
  CHECK((simulation.bodies()->state().bodies[0].pose.p - expected).norm() < 1e-10 * expected.norm());
}

TEST_CASE("bodies that collide keep momentum and angular momentum, gain no energy, and never touch") {
  for (const double friction : {0.0, 0.4}) {
    for (const double restitution : {0.0, 0.7, 1.0}) {
      CAPTURE(friction, restitution);
      Scene scene = empty_scene(1.0 / 100);
      scene.settings.contact.friction = friction;
      scene.settings.contact.restitution = restitution;
      scene.bodies = {box_at({0.2, 0.3, 0.4}, {0, 0, 0}), box_at({0.3, 0.3, 0.1}, {0.6, 0.05, 0.1}, 900),
                      box_at({0.1, 0.6, 0.1}, {-0.5, 0.1, -0.05}, 200)};
      scene.bodies[0].angular_velocity = {3, -1, 2};
      scene.bodies[1].velocity = {-2, 0, 0};
      scene.bodies[1].pose.q = {0.9, 0.1, 0.3, -0.2};
      scene.bodies[2].velocity = {1.5, 0, 0.1};
      scene.bodies[2].angular_velocity = {0, 0, -8};
      Simulation simulation(scene, {});
      const Momentum before = momentum_of(simulation);
      double energy = simulation.energies().total();
      std::uint64_t contacts = 0;
      for (int i = 0; i < 60; ++i) {
        const BodyStates from = simulation.bodies()->state().bodies;
        const auto records = simulation.step();
        for (const auto& record : records) contacts += record.bodies.contacts + record.bodies.close;
        const double after = simulation.energies().total();
        CHECK(after <= energy * (1 + 1e-9));
        energy = after;
        if (records.size() == 1) REQUIRE(!any_touch(simulation.colliders(), from, simulation.bodies()->state().bodies));
      }
      CHECK(contacts > 0);
      const Momentum after = momentum_of(simulation);
      CHECK((after.linear - before.linear).norm() < 1e-12 * before.linear.norm());
      CHECK((after.angular - before.angular).norm() < 1e-12 * before.angular.norm());
      CHECK(simulation.crossings().empty());
    }
  }
}

TEST_CASE("a box slides on a slope as Coulomb says, and rests where friction holds it") {
  const double slope = 0.4;  // rad: tan is 0.4228
  for (const double friction : {0.2, 0.5}) {
    Scene scene = empty_scene(1.0 / 200);
    scene.settings.gravity = 9.81 * Vector3(std::sin(slope), 0, -std::cos(slope));
    scene.settings.contact.friction = friction;
    scene.settings.contact.restitution = 0;
    Body ground = box_at({20, 20, 1}, {0, 0, -0.5});
    ground.density = 0;
    ground.motion = BodyMotion::fixed;
    scene.bodies = {ground, box_at({0.4, 0.4, 0.2}, {0, 0, 0.101})};
    Simulation simulation(scene, {});
    for (int i = 0; i < 100; ++i) simulation.step();
    const double v0 = simulation.bodies()->state().bodies[1].velocity.x();
    const double x0 = simulation.bodies()->state().bodies[1].pose.p.x();
    for (int i = 0; i < 100; ++i) simulation.step();
    const BodyState& state = simulation.bodies()->state().bodies[1];
    if (friction > 0.42) {
      CHECK(std::abs(state.pose.p.x() - x0) < 1e-6);
    } else {
      const double expected = 9.81 * (std::sin(slope) - friction * std::cos(slope));
      CHECK((state.velocity.x() - v0) / 0.5 == Approx(expected).epsilon(0.01));
    }
    CHECK(state.pose.p.z() == Approx(0.101).epsilon(0.01));
  }
}

TEST_CASE("a ball bounces with the coefficient of restitution") {
  Scene scene = empty_scene(1.0 / 200);
  scene.settings.contact.restitution = 0.6;
  Body ground = box_at({4, 4, 1}, {0, 0, -0.5});
  ground.density = 0;
  ground.motion = BodyMotion::fixed;
  Body diamond = box_at({0.2, 0.2, 0.2}, {0.013, 0.021, 0.4});
  // It falls on a corner that is right below its centre.
  diamond.pose.q = rotation_by(std::atan(std::sqrt(2.0)) * Vector3(1, -1, 0).normalized());
  scene.bodies = {ground, diamond};
  scene.bodies[1].velocity = {0, 0, -2};
  Simulation simulation(scene, {});
  for (int i = 0; i < 60; ++i) simulation.step();
  CHECK(simulation.bodies()->state().bodies[1].velocity.z() == Approx(1.2).epsilon(1e-6));
}

TEST_CASE("bodies push particles and are pushed by them, and momentum is kept") {
  Scene scene = empty_scene(1.0 / 200);
  scene.bodies = {box_at({0.2, 0.2, 0.2}, {0, 0, 0})};
  const Index a = add_particle(scene, {-0.5, -0.3, 0.01}, 2), b = add_particle(scene, {-0.5, 0.35, 0.02}, 2);
  add_spring(scene, a, b, 100, 0, true);
  add_particle(scene, {0.5, 0.03, 0.02}, 0.5);
  for (const Index p : {a, b}) scene.particles[p].velocity = {1, 0, 0};
  scene.particles[2].velocity = {-2, 0, 0};
  Simulation simulation(scene, {});
  const Momentum before = momentum_of(simulation);
  std::uint64_t contacts = 0;
  for (int i = 0; i < 200; ++i) {
    for (const auto& record : simulation.step()) contacts += record.bodies.contacts + record.bodies.close;
  }
  CHECK(contacts > 0);
  CHECK(simulation.bodies()->state().bodies[0].velocity.norm() > 0.1);
  CHECK((momentum_of(simulation).linear - before.linear).norm() < 1e-9 * 4);
}

TEST_CASE("a driven body keeps to its path and pushes a free one before it") {
  Scene scene = empty_scene(1.0 / 100);
  Body pusher = box_at({0.2, 0.2, 0.2}, {0, 0, 0});
  pusher.density = 0;
  pusher.motion = BodyMotion::driven;
  pusher.path = {{0, {{1, 0, 0, 0}, {0, 0, 0}}}, {1, {{0.8, 0, 0, 0.6}, {0.5, 0, 0}}}};
  scene.bodies = {pusher, box_at({0.2, 0.2, 0.2}, {0.3, 0.02, 0})};
  Simulation simulation(scene, {});
  for (int i = 0; i < 120; ++i) simulation.step();
  const auto& bodies = simulation.bodies()->state().bodies;
  CHECK((bodies[0].pose.p - Vector3(0.5, 0, 0)).norm() == 0);
  CHECK(std::abs(dot(bodies[0].pose.q, {0.8, 0, 0, 0.6})) == Approx(1).epsilon(1e-15));
  CHECK(bodies[1].pose.p.x() > 0.55);
}

TEST_CASE("a checkpoint of bodies resumes to the last bit, and a changed one is refused") {
  Scene scene = make_shipped_scene("stack", 3);
  scene.bodies[2].angular_velocity = {0.3, -0.2, 1};
  scene.bodies[3].velocity = {0.1, 0.4, 1};
  Simulation whole(scene, {});
  for (int i = 0; i < 40; ++i) whole.step();
  const std::string half = checkpoint_to_json(whole);
  CHECK(!whole.bodies()->state().forces.empty());
  for (int i = 0; i < 40; ++i) whole.step();
  Checkpoint checkpoint = checkpoint_from_json(half);
  Simulation resumed(checkpoint.scene, {});
  resumed.resume(checkpoint.state, checkpoint.steps, checkpoint.bodies);
  for (int i = 0; i < 40; ++i) resumed.step();
  CHECK(checkpoint_to_json(resumed) == checkpoint_to_json(whole));

  const auto refused = [&](auto change, const char* message) {
    Checkpoint wrong = checkpoint_from_json(half);
    change(wrong.bodies);
    Simulation other(wrong.scene, {});
    CHECK_THROWS_WITH(other.resume(wrong.state, wrong.steps, wrong.bodies), Catch::Contains(message));
  };
  refused([](BodiesState& s) { s.bodies.pop_back(); }, "bodies: there are 3");
  refused([](BodiesState& s) { s.bodies[1].pose.q[0] += 1e-3; }, "bodies[1].orientation");
  refused([](BodiesState& s) { s.bodies[2].velocity.x() = std::nan(""); }, "bodies[2].velocity");
  refused([](BodiesState& s) { s.bodies[0].pose.p.x() += 1e-9; }, "bodies[0].position");
  refused([](BodiesState& s) { s.bodies[2].pose.p = s.bodies[1].pose.p; },
          "begins with elements that pierce each other");
  refused([](BodiesState& s) { s.forces[0].pair.i = 12345; }, "contact_forces[0]");
  refused([](BodiesState& s) { s.forces.push_back(s.forces[0]); }, "contact_forces[");
}

TEST_CASE("scenes with bodies that cannot be simulated are refused") {
  Scene scene = make_shipped_scene("stack", 2);
  scene.bodies[2].pose.p.z() -= 0.01;
  CHECK_THROWS_WITH(Simulation(scene, {}), Catch::Contains("begins with elements that pierce each other: ") &&
                                               Catch::Contains("of body 1") && Catch::Contains("of body 2"));
  scene = make_shipped_scene("stack", 1);
  SimulationOptions paper;
  paper.narrow_phase = NarrowPhase::paper;
  CHECK_THROWS_WITH(Simulation(scene, paper), Catch::Contains("bodies: the narrow phase of the paper"));
  scene.bodies[1].radius = 0.01;
  CHECK_THROWS_WITH(Simulation(scene, {}), Catch::Contains("begins with elements that are too near: the radii of ") &&
                                               Catch::Contains("more than 0.01 m"));
}

TEST_CASE("bodies and particles keep the distances that their radii ask for") {
  Scene scene = empty_scene(1.0 / 200);
  scene.settings.gravity = {0, 0, -9.81};
  scene.settings.contact.friction = 0.3;
  Body ground = box_at({4, 4, 1}, {0, 0, -0.5}, 0);
  ground.motion = BodyMotion::fixed;
  ground.radius = 0.01;
  Body ring;  // a wire as thick as a finger, that rolls and falls over
  for (Index i = 0; i < 12; ++i) {
    const double phi = 2 * std::numbers::pi * i / 12;
    ring.vertices.emplace_back(0.2 * std::cos(phi), 0, 0.2 * std::sin(phi));
    ring.edges.push_back({i, (i + 1) % 12});
  }
  ring.density = 1;
  ring.radius = 0.02;
  ring.pose.p = {0, 0, 0.26};
  ring.velocity = {0.5, 0.3, -1};
  ring.angular_velocity = {1, 3, 0.5};
  scene.bodies = {ground, ring};
  // A cable that falls through the ring and onto the ground, and a grain.
  Cable cable = straight_cable(scene, {-0.1, -0.3, 0.3}, {-0.05, 0.3, 0.32}, 6);
  set_material(cable, 1e6, 0.3, 0.005, 1000);
  cable.solid = true;
  scene.cables.push_back(cable);
  scene.particles[add_particle(scene, {0.1, 0.02, 0.6}, 0.01)].radius = 0.015;
  Simulation simulation(scene, {});
  const Colliders& colliders = simulation.colliders();
  // Every pair of a body with anything, without a broad phase, is asked by the solver about each substep's two ends,
  // and measured in doubles between them.
  std::uint64_t contacts = 0, asked = 0, separated = 0;
  double nearest = 1;
  for (std::size_t i = 0; i < effort(120); ++i) {
    const BodyStates from = simulation.bodies()->state().bodies;
    const VectorX x0 = simulation.state().q;
    const auto records = simulation.step();
    for (const auto& record : records) {
      contacts += record.bodies.close;
      separated += record.proof.separations.pairs;
    }
    if (records.size() != 1) continue;
    const SceneMotion motion{&x0, &simulation.state().q, &from, &simulation.bodies()->state().bodies};
    const auto ask = [&](const Pair& pair, double d) {
      const double kept = colliders.separation(pair);  // rounded up
      REQUIRE(kept >= d);
      REQUIRE(kept <= std::nextafter(d, 1.0));
      const CurvedQuery query = colliders.query(pair, motion);
      REQUIRE(!solve(query, {.separation = Separation{kept, Metric::euclidean}}).contact);
      ++asked;
      const auto near = closest(colliders, pair, motion, 1);
      if (near) nearest = std::min(nearest, near->gap);
    };
    // The particles, the block and the wire.
    const auto &block = colliders.before(1), &wire = colliders.before(2), &end = colliders.before(3);
    for (Index v = wire.vertices; v < end.vertices; ++v) {
      for (Index f = 0; f < 4; ++f) ask({touchstone::Kind::vertex_face, v, block.faces + f}, 0.01 + 0.02);
    }
    for (Index w = wire.edges; w < end.edges; ++w) {
      for (Index e = 0; e < block.edges; ++e) ask({touchstone::Kind::edge_edge, e, w}, 0.005 + 0.02);
      ask({touchstone::Kind::point_edge, 7, w}, 0.015 + 0.02);
    }
    for (Index f = block.faces; f < wire.faces; f += 4) ask({touchstone::Kind::vertex_face, 7, f}, 0.015 + 0.01);
  }
  CHECK(contacts > 0);
  CHECK(asked > 0);
  if (!whole_effort("contacts at a distance")) return;
  CHECK(separated > 0);
  CHECK(nearest < 2e-3);
}
