// The integrators on springs: period, damping, order, and the energy that they keep.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "dynamics/energy_budget.hpp"
#include "dynamics/stepper.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// A mass on a spring along x that is stretched by 0.1 m, released at rest. omega^2 = stiffness / mass.
Scene oscillator(Integrator integrator, double stiffness, double mass, double damping = 0) {
  Scene scene;
  scene.settings.integrator = integrator;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-12;
  Particle wall, bob;
  wall.fixed = {true, true, true};
  bob.position = {1.1, 0, 0};
  bob.mass = mass;
  scene.particles = {wall, bob};
  scene.springs.push_back({0, 1, stiffness, damping, 1.0, true});
  return scene;
}

struct Run {
  explicit Run(const Scene& scene) : system(scene), stepper(system, scene.settings), state(stepper.initial()) {}
  void step(double h) {
    const Advance advance = stepper.advance(state, h);
    REQUIRE(advance.converged);
    state = advance.state;
  }
  double energy() const { return energies(system, state).total(); }

  System system;
  Stepper stepper;
  State state;
};

/// The fraction of the energy that remains after one period, with steps of h omega.
double energy_kept(Integrator integrator, double h_omega) {
  Run run(oscillator(integrator, 9, 1));
  const double h = h_omega / 3;
  const int steps = static_cast<int>(std::ceil(2 * std::numbers::pi / h_omega));
  const double before = run.energy();
  for (int i = 0; i < steps; ++i) run.step(h);
  return std::pow(run.energy() / before, 2 * std::numbers::pi / h_omega / steps);
}

/// How far the bob is from where it should be after one second, h = 1 / steps.
double error_after_a_second(Integrator integrator, int steps) {
  const double omega = 3, decay = 0.4;  // c = 2 m decay
  Run run(oscillator(integrator, 9 * 2, 2, 2 * 2 * decay));
  for (int i = 0; i < steps; ++i) run.step(1.0 / steps);
  const double w = std::sqrt(omega * omega - decay * decay);
  const double exact = 0.1 * std::exp(-decay) * (std::cos(w) + decay / w * std::sin(w));
  return std::abs(run.state.q[3] - 1 - exact);
}

}  // namespace

TEST_CASE("energy kept after one period is that of each method's amplification factor") {
  struct Row {
    Integrator integrator;
    double h_omega, kept, tolerance;
  };
  const Row row =
      GENERATE(Row{Integrator::implicit_euler, 0.01, 0.939, 5e-4}, Row{Integrator::implicit_euler, 0.1, 0.535, 5e-4},
               Row{Integrator::implicit_euler, 1, 0.0128, 5e-5}, Row{Integrator::tr_bdf2, 0.01, 1.000, 5e-4},
               Row{Integrator::tr_bdf2, 0.1, 0.99995, 5e-6}, Row{Integrator::tr_bdf2, 1, 0.961, 5e-4},
               Row{Integrator::implicit_midpoint, 0.01, 1, 1e-9}, Row{Integrator::implicit_midpoint, 0.1, 1, 1e-9},
               Row{Integrator::implicit_midpoint, 1, 1, 1e-9});
  CAPTURE(integrator_name(row.integrator), row.h_omega);
  CHECK(std::abs(energy_kept(row.integrator, row.h_omega) - row.kept) <= row.tolerance);
}

TEST_CASE("a damped spring's motion converges with each method's order") {
  struct Row {
    Integrator integrator;
    double order;
  };
  const Row row = GENERATE(Row{Integrator::implicit_euler, 1}, Row{Integrator::tr_bdf2, 2},
                           Row{Integrator::implicit_midpoint, 2}, Row{Integrator::symplectic_euler, 1});
  CAPTURE(integrator_name(row.integrator));
  const double coarse = error_after_a_second(row.integrator, 200), fine = error_after_a_second(row.integrator, 400);
  CAPTURE(coarse, fine);
  CHECK(std::abs(std::log2(coarse / fine) - row.order) < 0.1);
  CHECK(fine < (row.order > 1 ? 2e-6 : 2e-3));
}

TEST_CASE("the period of a spring and its decay") {
  // c = 0.8 kg/s, m = 2 kg, k = 18 N/m: omega_d = sqrt(9 - 0.04), amplitude e^(-0.2 t).
  Run run(oscillator(Integrator::tr_bdf2, 18, 2, 0.8));
  const double h = 1e-3;
  std::vector<double> crossings;
  double before = run.state.q[3] - 1;
  while (crossings.size() < 3) {
    run.step(h);
    const double now = run.state.q[3] - 1;
    if (before > 0 && now <= 0) crossings.push_back(run.state.time - h * now / (now - before));
    before = now;
  }
  CHECK(crossings[2] - crossings[1] == Approx(2 * std::numbers::pi / std::sqrt(9 - 0.04)).epsilon(1e-5));
}

TEST_CASE("symplectic Euler keeps the energy within a bound, for ever") {
  Run run(oscillator(Integrator::symplectic_euler, 9, 1));
  const double before = run.energy(), h = 0.1 / 3;
  double least = before, most = before;
  for (int i = 0; i < 20000; ++i) {
    run.step(h);
    least = std::min(least, run.energy());
    most = std::max(most, run.energy());
  }
  // The conserved quantity is v^2 + omega^2 x^2 - h omega^2 x v: the energy stays within 1 +- h omega / 2 of it.
  CHECK(least > 0.94 * before);
  CHECK(most < 1.06 * before);
}

TEST_CASE("free fall and drag") {
  Scene scene;
  Particle stone;
  stone.mass = 3;
  stone.velocity = {2, 0, 0};
  scene.particles = {stone};
  scene.settings.integrator = Integrator::implicit_midpoint;
  {
    Run run(scene);
    for (int i = 0; i < 100; ++i) run.step(0.01);
    CHECK(run.state.q[0] == Approx(2));
    CHECK(run.state.q[2] == Approx(-0.5 * 9.81));  // the midpoint rule is exact for parabolas
  }
  scene.settings.drag = 2;
  for (const auto integrator :
       {Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint, Integrator::symplectic_euler}) {
    scene.settings.integrator = integrator;
    Run run(scene);
    for (int i = 0; i < 5000; ++i) run.step(0.001);
    CHECK(run.state.v[2] == Approx(-9.81 / 2).epsilon(1e-3));
    CHECK(run.state.q[0] == Approx(1).epsilon(3e-3));  // first order: 1 - drag h
  }
}

TEST_CASE("a pendulum released at 90 degrees") {
  // T / T0 = 1.18034; a stiff spring as the rod.
  Scene scene;
  scene.settings.integrator = Integrator::tr_bdf2;
  Particle pivot, bob;
  pivot.fixed = {true, true, true};
  bob.position = {1, 0, 0};
  bob.mass = 1;
  scene.particles = {pivot, bob};
  scene.springs.push_back({0, 1, 1e7, 0, 1, true});
  Run run(scene);
  const double h = 1e-3;
  double before = run.state.q[3], first = 0;
  for (int i = 0; i < 3000 && first == 0; ++i) {
    run.step(h);
    if (before > 0 && run.state.q[3] <= 0) first = run.state.time - h * run.state.q[3] / (run.state.q[3] - before);
    before = run.state.q[3];
  }
  CHECK(4 * first == Approx(1.18034 * 2 * std::numbers::pi / std::sqrt(9.81)).epsilon(2e-4));
}

TEST_CASE("a step that is too long for an explicit method is noticed, not accepted") {
  Scene scene = oscillator(Integrator::symplectic_euler, 1e12, 1);
  Run run(scene);
  bool refused = false;
  for (int i = 0; i < 200 && !refused; ++i) {
    const Advance advance = run.stepper.advance(run.state, 1.0);
    refused = !advance.converged;
    run.state = advance.state;
  }
  CHECK(refused);
}

TEST_CASE("all integrators move a bent, twisted, damped cable alike, the better the shorter the steps", "[slow]") {
  // It is bent in space, held at an end that is turned and pulled, and its bends and twists change into one another.
  const auto moved = [](Integrator integrator, double damping, double h) {
    Scene scene;
    scene.settings.integrator = integrator;
    scene.settings.drag = 0.5;
    scene.settings.newton_tolerance = 1e-9;
    Cable cable;
    for (int i = 0; i < 9; ++i) {
      const double s = 0.1 * i;
      cable.particles.push_back(static_cast<Index>(scene.particles.size()));
      Particle p;
      p.position = {s, 0.2 * std::sin(5 * s), 0.15 * std::cos(7 * s)};
      p.velocity = {0, 0.5 * s, -2 * s};
      scene.particles.push_back(p);
    }
    cable.radius = 0.05;
    cable.density = 200;
    cable.stretch = 300;
    cable.bend = 0.15;
    cable.twist = 0.1;
    cable.damping = damping;
    cable.natural_curvature = {2, -1};
    cable.start.clamped = true;
    cable.start.twist_rate = 6;
    scene.particles[0].fixed = {true, true, true};
    scene.particles[0].path = {{0, scene.particles[0].position}, {1, {0.1, 0.2, 0.3}}};
    scene.cables.push_back(cable);
    Run run(scene);
    const int steps = static_cast<int>(std::lround(0.4 / h));
    for (int i = 0; i < steps; ++i) run.step(h);
    return run.state.q;
  };
  struct Row {
    Integrator integrator;
    double damping, order, step, error;
  };
  // With damping the midpoint rule is of first order only: strains that turn have another rate at its middle than that
  // which it takes for it.
  const Row row =
      GENERATE(Row{Integrator::implicit_euler, 0.01, 1, 2e-4, 3e-3}, Row{Integrator::tr_bdf2, 0.01, 2, 1e-3, 1e-4},
               Row{Integrator::tr_bdf2, 0, 2, 1e-3, 1e-3}, Row{Integrator::implicit_midpoint, 0, 2, 1e-3, 2e-3},
               Row{Integrator::symplectic_euler, 0.01, 1, 2e-4, 3e-3});
  CAPTURE(integrator_name(row.integrator), row.damping);
  const VectorX exact = moved(Integrator::tr_bdf2, row.damping, 1e-4);
  const double coarse = (moved(row.integrator, row.damping, 2 * row.step) - exact).lpNorm<Eigen::Infinity>();
  const double fine = (moved(row.integrator, row.damping, row.step) - exact).lpNorm<Eigen::Infinity>();
  CAPTURE(coarse, fine);
  CHECK(fine < row.error);
  CHECK(std::abs(std::log2(coarse / fine) - row.order) < 0.1);
}
