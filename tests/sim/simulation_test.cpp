// Whole runs: friction on an incline, bounces, fail-safe, proof.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include <touchstone/error.hpp>

#include "contact/impact_zones.hpp"
#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// A particle just above a large pinned face in the plane z = 0.
Scene particle_above_face(double height) {
  Scene scene;
  scene.settings.contact.thickness = 1e-4;
  Particle p;
  p.position = {0.01, 0.02, height};
  p.mass = 1;
  scene.particles.push_back(p);
  for (const Vector3& corner : {Vector3(-50, -50, 0), Vector3(50, -50, 0), Vector3(0, 80, 0)}) {
    add_pinned(scene, corner);
  }
  scene.faces.push_back({1, 2, 3});
  return scene;
}

/// Gravity turned by the angle of the incline.
Scene incline(double angle, double friction) {
  Scene scene = particle_above_face(0.9e-4);
  scene.settings.gravity = 9.81 * Vector3(std::sin(angle), 0, -std::cos(angle));
  scene.settings.contact.restitution = 0;
  scene.settings.contact.friction = friction;
  scene.settings.time_step = 1e-3;
  return scene;
}

double slid_after_a_second(const Scene& scene) {
  Simulation simulation(scene, {});
  for (int i = 0; i < 1000; ++i) simulation.step();
  CHECK(simulation.crossings().empty());
  return position(simulation.state().q, 0).x() - scene.particles[0].position.x();
}

}  // namespace

TEST_CASE("on an incline it sticks when tan theta <= mu, and slides as Coulomb says otherwise") {
  const double angle = 0.4;  // tan = 0.4228
  CHECK(std::abs(slid_after_a_second(incline(angle, 0.43))) < 1e-6);
  for (const double mu : {0.0, 0.2, 0.4}) {
    const double expected = 0.5 * 9.81 * (std::sin(angle) - mu * std::cos(angle));
    // Implicit Euler moves with the speed at each step's end: n (n + 1) / 2 in place of n^2 / 2.
    CHECK(slid_after_a_second(incline(angle, mu)) == Approx(expected * (1 + 1e-3)).epsilon(1e-5));
  }
}

TEST_CASE("it slides v^2 / (2 mu g) before it stops") {
  Scene scene = incline(0, 0.3);
  scene.particles[0].velocity = {2, 0, 0};
  // Implicit Euler slows it down half a step too early.
  CHECK(slid_after_a_second(scene) == Approx(4 / (2 * 0.3 * 9.81) - 2 * 1e-3 / 2).epsilon(1e-5));
}

TEST_CASE("it bounces to e^(2n) of its height") {
  Scene scene = particle_above_face(1);
  scene.settings.contact.restitution = 0.7;
  scene.settings.time_step = 1e-4;
  scene.settings.integrator = Integrator::implicit_midpoint;
  Simulation simulation(scene, {});
  std::vector<double> tops;
  double before = 0;
  while (tops.size() < 3) {
    simulation.step();
    const double speed = simulation.state().v[2];
    if (before > 0 && speed <= 0) tops.push_back(position(simulation.state().q, 0).z());
    before = speed;
    REQUIRE(simulation.state().time < 5);
  }
  for (int n = 1; n <= 3; ++n)
    CHECK(tops[static_cast<std::size_t>(n - 1)] == Approx(std::pow(0.7, 2 * n)).epsilon(5e-3));
}

TEST_CASE("it comes to rest after a time of sqrt(2 h / g) (1 + e) / (1 - e)") {
  // The sum of all bounces. The last ones are lower than the thickness, and are left out: they end after its own such
  // time at most.
  constexpr double kRestitution = 0.5, kHeight = 1;
  Scene scene = particle_above_face(kHeight);
  scene.settings.contact.restitution = kRestitution;
  scene.settings.contact.thickness = 1e-6;
  scene.settings.time_step = 1e-4;
  scene.settings.integrator = Integrator::implicit_midpoint;
  Simulation simulation(scene, {});
  const double total = std::sqrt(2 * kHeight / 9.81) * (1 + kRestitution) / (1 - kRestitution);
  double last_high = 0;  // when it was last higher than a tenth of a millimetre
  while (simulation.state().time < 1.5 * total) {
    simulation.step();
    if (position(simulation.state().q, 0).z() > 1e-4) last_high = simulation.state().time;
  }
  CHECK(last_high <= total * 1.001);
  CHECK(last_high >= total - std::sqrt(2e-4 / 9.81) * 2 / (1 - kRestitution));
  CHECK(std::abs(simulation.state().v[2]) < 1e-3);
}

TEST_CASE("the momentum of two edges that meet is kept, and they part again") {
  Simulation simulation(make_shipped_scene("two-edges", 1), {});
  const auto momentum = [&] {
    Vector3 sum = Vector3::Zero();
    for (Index p = 0; p < 4; ++p) sum += position(simulation.state().v, p);
    return sum;
  };
  const Vector3 before = momentum();
  std::uint64_t contacts = 0;
  for (int i = 0; i < 120; ++i) {
    for (const auto& record : simulation.step()) contacts += record.response.contacts;
  }
  CHECK(contacts >= 1);
  CHECK((momentum() - before).norm() < 1e-9);
  CHECK(simulation.crossings().empty());
  CHECK(position(simulation.state().v, 0).z() + position(simulation.state().v, 1).z() < -0.1);
}

TEST_CASE("scenes that begin with a contact are refused, by name") {
  Scene scene = make_shipped_scene("two-edges", 1);
  scene.particles[2].position = {0.2, -1, 0};
  scene.particles[3].position = {0.1, 1.2, 0};
  scene.particles[1].position = {1, 0, 0};
  CHECK_THROWS_WITH(Simulation(scene, {}), Catch::Contains("edge 0-1 and edge 2-3"));
}

TEST_CASE("what is driven through something pinned cannot be, and the run says so and stays where it was") {
  Scene scene;
  scene.settings.gravity.setZero();
  const Index a = add_pinned(scene, {-1, 0, 0}), b = add_pinned(scene, {1, 0, 0});
  const Index c = add_particle(scene, {0, -1, 0.1}, 1), d = add_particle(scene, {0.1, 1, 0.1}, 1);
  scene.particles[c].path = {{0, {0, -1, 0.1}}, {1, {0, -1, -1}}};
  scene.particles[d].path = {{0, {0.1, 1, 0.1}}, {1, {0.1, 1, -1}}};
  scene.wires = {{a, b}, {c, d}};
  Simulation simulation(scene, {});
  std::uint64_t steps = 0;
  VectorX before;
  const auto run_on = [&] {
    for (;; ++steps) {
      before = simulation.state().q;
      simulation.step();
    }
  };
  CHECK_THROWS_WITH(run_on(),
                    Catch::Contains("step 6 at 0.0909") &&
                        Catch::Contains(" (25 found no response): edge 0-1 and edge 2-3 would touch at (0.05, ") &&
                        Catch::Contains("nothing of them is free to give way"));
  CHECK(steps == 5);  // it would meet after 1 / 11 s, in the sixth step of a sixtieth of a second
  CHECK(simulation.steps() == steps);
  CHECK(simulation.state().q == before);
  CHECK(simulation.crossings().empty());
  CHECK(simulation.refused(Cause::not_resolved) > 0);
}

TEST_CASE("a zone moves rigidly, with its momentum and angular momentum") {
  Scene scene;
  scene.settings.gravity.setZero();
  for (int i = 0; i < 5; ++i) {
    add_particle(scene, {std::sin(3.0 * i), std::cos(5.0 * i), 0.3 * i}, 1 + i);
  }
  scene.wires = {{0, 1}, {2, 3}, {3, 4}};
  const System system(scene);
  const VectorX x0 = system.initial_position;
  VectorX x1 = x0, inverse = VectorX::Zero(15);
  for (Eigen::Index i = 0; i < 15; ++i) {
    x1[i] += 1e-3 * std::sin(7.0 * static_cast<double>(i));
    inverse[i] = 1 / system.mass[i];
  }
  const VectorX wanted = x1;
  REQUIRE(move_rigidly({0, 1, 2, 3, 4}, system, inverse, x0, x1));
  Vector3 momentum = Vector3::Zero(), angular = Vector3::Zero();
  for (Index p = 0; p < 5; ++p) {
    const Vector3 change = system.mass[3 * p] * (position(x1, p) - position(wanted, p));
    momentum += change;
    angular += position(x0, p).cross(change);
    for (Index o = 0; o < p; ++o) {
      CHECK((position(x1, p) - position(x1, o)).norm() ==
            Approx((position(x0, p) - position(x0, o)).norm()).epsilon(1e-12));
    }
  }
  CHECK(momentum.norm() < 1e-14);
  CHECK(angular.norm() < 1e-6);  // a rotation by 1e-3 is its displacement but for its square
}

TEST_CASE("a zone with something held does not move, or moves with what is driven") {
  Scene scene;
  for (int i = 0; i < 4; ++i) add_particle(scene, {std::sin(3.0 * i), std::cos(5.0 * i), 0.3 * i}, 1 + i);
  scene.particles[2].fixed = {true, true, true};
  const System system(scene);
  const VectorX x0 = system.initial_position;
  VectorX wanted = x0, inverse = VectorX::Zero(12);
  for (const Index p : {0, 1, 3}) {
    wanted.segment<3>(3 * p) += Vector3(0.1, 0.2 * p, -0.1);
    inverse.segment<3>(3 * p).setConstant(1 / system.mass[3 * p]);
  }
  VectorX x1 = wanted;
  REQUIRE(move_rigidly({0, 1, 2}, system, inverse, x0, x1));
  CHECK(x1.head<9>() == x0.head<9>());
  CHECK(x1.tail<3>() == wanted.tail<3>());  // in no zone
  // Driven: 2 is elsewhere at the end of the step.
  const Vector3 way(0.3, -0.2, 0.1);
  wanted.segment<3>(6) += way;
  x1 = wanted;
  REQUIRE(move_rigidly({0, 1, 2}, system, inverse, x0, x1));
  for (const Index p : {0, 1, 2}) CHECK((position(x1, p) - position(x0, p) - way).norm() < 1e-15);
  // Two that are driven apart have no common motion.
  inverse.segment<3>(0).setZero();
  x1 = wanted;
  CHECK_FALSE(move_rigidly({0, 1, 2}, system, inverse, x0, x1));
}

TEST_CASE("a contact's particles all join its zone") {
  ImpactZones zones(9);
  Contact contact;
  contact.particles = {1, 4, 6, 8};
  contact.corners = 4;
  CHECK(zones.join(contact));
  CHECK_FALSE(zones.join(contact));
  contact.particles = {0, 2, 3, 8};
  contact.corners = 3;
  CHECK(zones.join(contact));
  CHECK(zones.zones() == std::vector<std::vector<Index>>{{0, 2, 3}, {1, 4, 6, 8}});
  contact.particles = {3, 6, 0, 0};
  contact.corners = 2;
  CHECK(zones.join(contact));
  CHECK(zones.zones() == std::vector<std::vector<Index>>{{0, 1, 2, 3, 4, 6, 8}});
}

TEST_CASE("what hangs on springs that do not collide is stopped by a face, unless it is said not to collide") {
  Scene scene;
  scene.settings.duration = 1;
  add_floor(scene, 5);
  const Index a = add_particle(scene, {0, 1, 0.5}, 1), b = add_particle(scene, {0.5, 1, 0.5}, 1);
  add_spring(scene, a, b, 100, 0, false);
  const auto lowest = [&] {
    Simulation simulation(scene, {});
    for (int i = 0; i < 60; ++i) simulation.step();
    CHECK(simulation.crossings().empty());
    return std::min(position(simulation.state().q, a).z(), position(simulation.state().q, b).z());
  };
  CHECK(lowest() > 0);
  scene.particles[a].collides = scene.particles[b].collides = false;
  CHECK(lowest() < -1);
}

TEST_CASE("the thickness follows the shortest edge that can move") {
  Scene scene;
  scene.particles.reserve(4);
  const Index a = add_pinned(scene, {0, 0, 0}), b = add_pinned(scene, {0.01, 0, 0});
  scene.wires.push_back({a, b});
  CHECK(Simulation(scene, {}).thickness() == Approx(0.01 / 50));
  const Index c = add_particle(scene, {0, 0, 1}, 1), d = add_particle(scene, {2, 0, 1}, 1);
  scene.wires.push_back({c, d});
  CHECK(Simulation(scene, {}).thickness() == Approx(2.0 / 50));
}
