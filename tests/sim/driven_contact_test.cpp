// Contact with driven elements does work. It must neither cut steps short nor let the scene gain other energy.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/response.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// A large face in the plane z = height that moves along z.
void add_plate(Scene& scene, double height, double speed, double until) {
  std::array<Index, 3> corners{};
  std::size_t n = 0;
  for (const Vector3& corner : {Vector3(-5, -5, height), Vector3(5, -5, height), Vector3(0, 8, height)}) {
    corners[n] = add_pinned(scene, corner);
    scene.particles[corners[n++]].path = {{0, corner}, {until, corner + Vector3(0, 0, speed * until)}};
  }
  scene.faces.push_back({corners});
}

/// An octahedron of springs, which are stiff for the step or not.
void add_ball(Scene& scene, double radius, double stiffness) {
  Index first = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      // Turned a little, so that nothing is aligned with the plates.
      const Vector3 at = radius * side * Vector3::Unit(axis) + 0.02 * radius * side * Vector3(1, 2, 3);
      const Index p = add_particle(scene, at, 0.01);
      if (axis == 0 && side < 0) first = p;
    }
  }
  for (Index i = 0; i < 6; ++i) {
    for (Index j = i + 1; j < 6; ++j) add_spring(scene, first + i, first + j, stiffness, 0.01, false);
  }
  for (const Index a : {0U, 1U}) {
    for (const Index b : {2U, 3U}) {
      for (const Index c : {4U, 5U}) scene.faces.push_back({first + a, first + b, first + c});
    }
  }
}

struct DrivenCourse {
  std::size_t parts = 0;
  std::uint64_t contacts = 0;
};

DrivenCourse run_driven(Simulation& simulation, int steps) {
  DrivenCourse course;
  for (int i = 0; i < steps; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      ++course.parts;
      course.contacts += record.response.contacts + record.response.close;
    }
  }
  CHECK(simulation.crossings().empty());
  return course;
}

}  // namespace

TEST_CASE("a rising face carries a particle at its own speed, in whole steps") {
  for (const double speed : {0.5, 5.0}) {
    Scene scene;
    scene.settings.contact.restitution = 0;
    const Index p = add_particle(scene, {0, 0, 0.1}, 1);
    add_plate(scene, 0, speed, 10);
    Simulation simulation(scene, {});
    const DrivenCourse course = run_driven(simulation, 60);
    CAPTURE(speed);
    CHECK(course.parts <= 66);
    CHECK(course.contacts > 40);
    CHECK(simulation.refused(Cause::gained_energy) == 0);
    CHECK(simulation.state().v[3 * p + 2] == Approx(speed).epsilon(1e-3));
    CHECK(position(simulation.state().q, p).z() - speed >= 0);
    CHECK(position(simulation.state().q, p).z() - speed < 2 * simulation.thickness());
  }
}

TEST_CASE("a ball is squeezed between two faces in about as many parts as steps") {
  // Soft for the step, and stiff: impulses, and contacts in the potential.
  for (const double stiffness : {1.0, 1000.0}) {
    Scene scene;
    scene.settings.contact.friction = 0.5;
    add_ball(scene, 0.1, stiffness);
    add_plate(scene, -0.15, 0.1, 1);
    add_plate(scene, 0.15, -0.1, 1);
    Simulation simulation(scene, {});
    const DrivenCourse course = run_driven(simulation, 72);
    CAPTURE(stiffness);
    CHECK(course.contacts > 72);
    CHECK(course.parts <= 3 * 72);
  }
}

TEST_CASE("what a driven face gives is its force times how far it moves") {
  Scene scene;
  scene.settings.gravity.setZero();
  add_ball(scene, 0.1, 1000);
  add_plate(scene, -0.107, 0.6, 10);
  const System system(scene);
  Stepper stepper(system, scene.settings);
  const double h = scene.settings.time_step;
  const State start = stepper.initial();

  ContactTerm term;
  term.particles = {4, 6, 7, 8};  // the ball's lowest particle and the plate
  term.corners = 4;
  term.omega = {1, -0.4, -0.3, -0.3};
  term.normal = {0, 0, 1};
  term.goal = 0.002;
  term.stiffness = 50;
  const Advance with = stepper.advance_with(start, h, std::span(&term, 1), start.q);
  REQUIRE(with.converged);
  const double force = normal_force(term, start.q, with.state.q), moved = 0.6 * h;
  CHECK(force > 0);
  const double work = stepper.driven_work(start, h, std::span(&term, 1), with.state);
  CHECK(work == Approx(force * moved).epsilon(1e-9));
  const double gained = energies(system, with.state).total() - energies(system, start).total();
  CHECK(gained > 0);
  CHECK(gained <= work * (1 + 1e-9));
}

TEST_CASE("a step in which a contact gives more than the driven face does is refused") {
  for (const double stiffness : {1.0, 1000.0}) {
    // Where elements are stiff for the step, a particle that leaves a contact too fast strains its neighbours.
    for (const double restitution : {stiffness > 1 ? 0.0 : 1.0, 1.5}) {
      Scene scene;
      scene.settings.gravity.setZero();
      scene.settings.contact.restitution = restitution;  // no scene's is above 1
      add_ball(scene, 0.1, stiffness);
      for (Particle& particle : scene.particles) particle.velocity = {0, 0, -3};
      add_plate(scene, -0.107, 0.6, 10);
      const System system(scene);
      const Colliders colliders(scene, system);
      Stepper stepper(system, scene.settings);
      const State start = stepper.initial();
      Response response(colliders, system, scene.settings, NarrowPhase::exact, 1, stepper);
      const double h = scene.settings.time_step;
      const Advance free = stepper.advance(start, h);
      REQUIRE(free.converged);
      CAPTURE(stiffness, restitution);
      const ResponseResult result = response.respond({&start, h, free.state});
      REQUIRE(result.refused.has_value() == (restitution > 1));
      if (result.refused) CHECK(result.refused->cause == Cause::gained_energy);
      CHECK(result.counts.contacts > 0);
    }
  }
}
