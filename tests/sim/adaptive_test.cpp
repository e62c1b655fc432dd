// Steps that are cut to keep a bound on the error: the bound, the number of substeps, contacts, and checkpoints.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <touchstone/error.hpp>

#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/sim_scenes.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// A mass on a spring along x that is stretched by 0.1 m; omega in rad/s.
Scene adaptive_oscillator(Integrator integrator, double omega, double tolerance) {
  Scene scene;
  scene.settings.integrator = integrator;
  scene.settings.time_step = 0.1;
  scene.settings.tolerance = tolerance;
  scene.settings.least_step = 1e-5;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-12;
  add_pinned(scene, {0, 0, 0});
  add_particle(scene, {1.1, 0, 0}, 2);
  scene.springs.push_back({0, 1, 2 * omega * omega, 0, 1.0, true});
  return scene;
}

/// A bob on a spring that is stiff as a rod, released at 90 degrees.
Scene pendulum(double time_step, double tolerance) {
  Scene scene;
  scene.settings.integrator = Integrator::tr_bdf2;
  scene.settings.time_step = time_step;
  scene.settings.tolerance = tolerance;
  scene.settings.newton_tolerance = 1e-9;
  add_pinned(scene, {0, 0, 0});
  add_particle(scene, {1, 0, 0}, 1);
  scene.springs.push_back({0, 1, 1e6, 0, 1.0, true});
  return scene;
}

struct Worst {
  double error_a_second = 0;  // m/s, the largest at the end of a step
  std::size_t substeps = 0, inaccurate = 0;
};

/// @param exact  the x of particle 1 at a time
template <class Exact>
Worst worst_of_run(const Scene& scene, int steps, Exact exact) {
  Simulation simulation(scene, {});
  Worst worst;
  for (int i = 1; i <= steps; ++i) {
    for (const SubstepRecord& record : simulation.step()) {
      ++worst.substeps;
      if (record.excess > 1) ++worst.inaccurate;
    }
    const double time = simulation.state().time;
    CHECK(time == i * scene.settings.time_step);  // frames come when they would come
    worst.error_a_second = std::max(worst.error_a_second, std::abs(simulation.state().q[3] - exact(time)) / time);
  }
  return worst;
}

}  // namespace

TEST_CASE("an oscillator's error a second stays below the tolerance, and the substeps are as many as the order says") {
  struct Row {
    Integrator integrator;
    double omega, tolerance, finer;
    int steps;
  };
  const Row row = GENERATE(
      Row{Integrator::implicit_euler, 2, 2e-2, 4, 30}, Row{Integrator::symplectic_euler, 2, 2e-2, 4, 30},
      Row{Integrator::tr_bdf2, 2, 2e-4, 16, 60}, Row{Integrator::tr_bdf2, 40, 1e-2, 16, 15},
      Row{Integrator::implicit_midpoint, 2, 2e-4, 16, 60}, Row{Integrator::implicit_midpoint, 40, 1e-2, 16, 15});
  CAPTURE(integrator_name(row.integrator), row.omega);
  const auto exact = [&](double t) { return 1 + 0.1 * std::cos(row.omega * t); };
  const Worst coarse = worst_of_run(adaptive_oscillator(row.integrator, row.omega, row.tolerance), row.steps, exact);
  const Worst fine =
      worst_of_run(adaptive_oscillator(row.integrator, row.omega, row.tolerance / row.finer), row.steps, exact);
  CAPTURE(coarse.error_a_second, coarse.substeps, fine.error_a_second, fine.substeps);
  CHECK(coarse.inaccurate == 0);
  CHECK(fine.inaccurate == 0);
  CHECK(coarse.error_a_second <= row.tolerance);
  CHECK(fine.error_a_second <= row.tolerance / row.finer);
  // The bound is no exaggeration: it is kept by less than a hundred times.
  CHECK(fine.error_a_second >= 0.01 * row.tolerance / row.finer);
  // Both tolerances ask for substeps that are four times as many; they come in powers of two.
  CHECK(coarse.substeps > static_cast<std::size_t>(row.steps));
  const double ratio = static_cast<double>(fine.substeps) / static_cast<double>(coarse.substeps);
  CHECK(ratio > 2.5);
  CHECK(ratio < 6.5);
}

TEST_CASE("a stiff pendulum keeps the bound") {
  Simulation reference(pendulum(2.5e-4, 0), {});
  std::vector<Vector3> exact{position(reference.state().q, 1)};
  for (int i = 1; i <= 2 * 4000; ++i) {
    reference.step();
    if (i % 200 == 0) exact.push_back(position(reference.state().q, 1));
  }
  for (const double tolerance : {1e-2, 1e-3}) {
    Simulation simulation(pendulum(0.05, tolerance), {});
    std::size_t substeps = 0;
    for (std::size_t i = 1; i < exact.size(); ++i) {
      substeps += simulation.step().size();
      const double error = (position(simulation.state().q, 1) - exact[i]).norm();
      CHECK(error <= tolerance * simulation.state().time);
    }
    CAPTURE(tolerance, substeps);
    // A step of the spring's own vibration would be 2 ms / pi: the method does not follow it.
    CHECK(substeps > (tolerance < 5e-3 ? 3 : 1) * exact.size());
    CHECK(substeps < 40 * exact.size());
  }
}

TEST_CASE("a light chain with a heavy weight: a tolerance costs substeps where it whirls, and little at rest") {
  Scene scene = make_chain(8);
  scene.settings.integrator = Integrator::tr_bdf2;
  scene.settings.time_step = 1.0 / 60;
  scene.settings.drag = 4;
  scene.settings.tolerance = 1e-2;
  Simulation simulation(scene, {});
  std::vector<std::size_t> parts;
  for (int i = 0; i < 500; ++i) {
    std::size_t inaccurate = 0;
    const auto records = simulation.step();
    for (const SubstepRecord& record : records) inaccurate += record.excess > 1 ? 1 : 0;
    CHECK(inaccurate == 0);
    parts.push_back(records.size());
  }
  const std::size_t most = *std::max_element(parts.begin(), parts.end());
  std::size_t last = 0;
  for (std::size_t i = parts.size() - 50; i < parts.size(); ++i) last += parts[i];
  CAPTURE(most, last);
  CHECK(most >= 8);
  CHECK(last <= 100);
}

TEST_CASE("the least substep is taken as it is, and says so") {
  Scene scene = adaptive_oscillator(Integrator::tr_bdf2, 10, 1e-12);
  scene.settings.least_step = 0.012;
  Simulation simulation(scene, {});
  for (int i = 0; i < 3; ++i) {
    const auto records = simulation.step();
    CHECK(records.size() == 8);  // an eighth is the shortest part of 0.1 s that is no shorter than 0.012 s
    for (const SubstepRecord& record : records) CHECK(record.excess > 1);
  }
  CHECK(simulation.refused(Cause::inaccurate) > 0);
}

TEST_CASE("contacts, a tolerance and a checkpoint: the run that goes on is the same to the last bit") {
  Scene scene = make_two_edges(1);
  scene.settings.integrator = Integrator::tr_bdf2;
  scene.settings.tolerance = 1e-6;
  Simulation whole(scene, {});
  std::uint64_t contacts = 0;
  State half;
  std::size_t parts = 0;
  for (int i = 0; i < 80; ++i) {
    if (i == 50) half = whole.state();
    for (const SubstepRecord& record : whole.step()) {
      contacts += record.response.contacts;
      CHECK(record.proof.crossings == 0);
      ++parts;
    }
  }
  CHECK(contacts > 0);
  CHECK(parts > 100);
  Simulation rest(scene, {});
  rest.resume(half, 50);
  for (int i = 50; i < 80; ++i) rest.step();
  CHECK(rest.state().q == whole.state().q);
  CHECK(rest.state().v == whole.state().v);
}

TEST_CASE("a tolerance that makes no sense is refused") {
  Scene scene = adaptive_oscillator(Integrator::tr_bdf2, 1, 1e-3);
  scene.settings.tolerance = -1;
  CHECK_THROWS_WITH(check_scene(scene), "settings.tolerance: -1 is not in [0, 1000000000]");
  scene.settings.tolerance = 0;
  CHECK_THROWS_WITH(check_scene(scene), "settings.least_step: goes with a tolerance");
  scene.settings.tolerance = 1;
  scene.settings.least_step = 0.2;
  CHECK_THROWS_WITH(check_scene(scene), "settings.least_step: 0.2 is not in [0, 0.1]");
}
