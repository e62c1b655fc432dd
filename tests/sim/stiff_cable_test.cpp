// Cables that hardly stretch: Newton's method follows their bends, and methods of second order gain no energy.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// A cable without bending stiffness that is held at one end and falls.
Scene falling_cable(Integrator integrator, double stretch, double time_step) {
  Scene scene;
  scene.settings.integrator = integrator;
  scene.settings.time_step = time_step;
  Cable& cable = add_cable(scene, {0, 0, 0}, {-0.07, -0.36, 0.35}, 60);
  cable.radius = 9e-4;
  cable.density = 5400;
  cable.stretch = stretch;
  cable.damping = 0.04;
  scene.particles[cable.particles.front()].fixed = {true, true, true};
  return scene;
}

struct CableCourse {
  double most_gained = 0;  // J, in one step
  double fallen = 0;       // J
  int parts = 0, first_order = 0;
};

CableCourse run_cable(const Scene& scene, int steps) {
  Simulation simulation(scene, {});
  CableCourse course;
  const double first = simulation.energies().load;
  double before = simulation.energies().total();
  for (int i = 0; i < steps; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      ++course.parts;
      course.first_order += record.first_order;
    }
    const Energies now = simulation.energies();
    course.most_gained = std::max(course.most_gained, now.total() - before);
    before = now.total();
  }
  course.fallen = first - simulation.energies().load;
  return course;
}

}  // namespace

TEST_CASE("a stiff cable falls in steps of second order without gaining energy") {
  const Integrator integrator = GENERATE(Integrator::tr_bdf2, Integrator::implicit_midpoint);
  CAPTURE(static_cast<int>(integrator));
  const CableCourse course = run_cable(falling_cable(integrator, 2.4e5, 1.0 / 30), 20);
  CHECK(course.fallen > 0.01);
  CHECK(course.most_gained <= 2e-3 * course.fallen * course.parts / 20);
  CHECK(course.first_order > 0);
}

TEST_CASE("a soft cable is moved by the method that was asked for") {
  const Integrator integrator = GENERATE(Integrator::tr_bdf2, Integrator::implicit_midpoint);
  CAPTURE(static_cast<int>(integrator));
  // Steps of a fifth of a radian of its fastest vibration.
  Scene scene = falling_cable(integrator, 3.8, 1e-4);
  scene.cables.front().damping = 0;
  const CableCourse course = run_cable(scene, 300);
  CHECK(course.fallen > 1e-4);
  CHECK(course.parts == 300);
  CHECK(course.first_order == 0);
}

TEST_CASE("a cable that hardly stretches falls in almost whole steps, far though it turns in each") {
  const CableCourse course = run_cable(falling_cable(Integrator::implicit_euler, 2.4e5, 1.0 / 30), 30);
  CHECK(course.fallen > 0.01);
  CHECK(course.parts <= 3 * 30);
  CHECK(course.most_gained <= 0);
}
