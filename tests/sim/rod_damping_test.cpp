// The energy that a cable's internal damping takes, and the motion of its ends.
// SPDX-License-Identifier: MIT
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <string>

#include "dynamics/energy_budget.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

enum class RodMotion { stretch, bend, bend_across, twist };
constexpr RodMotion kMotions[] = {RodMotion::stretch, RodMotion::bend, RodMotion::bend_across, RodMotion::twist};
const char* name(RodMotion motion) {
  constexpr const char* kNames[] = {"stretch", "bend", "bend across", "twist"};
  return kNames[static_cast<int>(motion)];
}

/// Clamped at one end, free at the other; all frequencies are of the order of 10 rad/s.
Scene damped_cantilever(double damping) {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-12;
  Cable& cable = add_cable(scene, {0, 0, 0}, {1, 0, 0}, 8);
  cable.radius = 0.1;
  cable.density = 1 / (std::numbers::pi * 0.01);  // 1 kg/m
  cable.stretch = 50;
  cable.bend = 10;
  cable.twist = 0.3;
  cable.damping = damping;
  cable.start.clamped = true;
  scene.particles.front().fixed = {true, true, true};
  return scene;
}

/// The slowest motion of its kind, of unit size, and its frequency.
struct Mode {
  VectorX shape;
  double omega = 0;
};

Mode slowest(const System& system, const State& state, RodMotion motion) {
  const Eigen::MatrixXd all = stiffness_matrix(system, state);
  const std::vector<Eigen::Index> free = free_coordinates(system);
  const auto angles = static_cast<Eigen::Index>(3 * system.particle_count());
  std::vector<Eigen::Index> own;  // in `free`
  for (std::size_t i = 0; i < free.size(); ++i) {
    const bool is_own = motion == RodMotion::twist
                            ? free[i] >= angles
                            : free[i] < angles && free[i] % 3 == static_cast<Eigen::Index>(motion);
    if (is_own) own.push_back(static_cast<Eigen::Index>(i));
  }
  const auto mass = [&](Eigen::Index i) { return system.mass[free[static_cast<std::size_t>(i)]]; };
  const auto count = static_cast<Eigen::Index>(own.size());
  Eigen::MatrixXd matrix(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const Eigen::Index a = own[static_cast<std::size_t>(i)], b = own[static_cast<std::size_t>(j)];
      matrix(i, j) = all(a, b) / std::sqrt(mass(a) * mass(b));
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix);
  Mode mode{VectorX::Zero(system.size()), std::sqrt(modes.eigenvalues()[0])};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index a = own[static_cast<std::size_t>(i)];
    mode.shape[free[static_cast<std::size_t>(a)]] = modes.eigenvectors()(i, 0) / std::sqrt(mass(a));
  }
  return mode;
}

}  // namespace

TEST_CASE("internal damping takes the energy of each kind of motion at the rate tau omega^2", "[slow]") {
  // Stress is stiffness * (strain + tau strain rate): x'' + tau omega^2 x' + omega^2 x = 0.
  const RodMotion motion = GENERATE(from_range(std::begin(kMotions), std::end(kMotions)));
  struct Method {
    Integrator integrator;
    double step;       // times omega
    double own;        // damping of the method itself: its share of a step's length as tau
    double tolerance;  // of the logarithm of the remaining amplitude
  };
  const Method method = GENERATE(
      Method{Integrator::implicit_euler, 1e-3, 1, 2e-3}, Method{Integrator::tr_bdf2, 2e-2, 0, 1e-3},
      Method{Integrator::implicit_midpoint, 2e-2, 0, 1e-3}, Method{Integrator::symplectic_euler, 2e-3, 0, 2e-3});
  CAPTURE(name(motion), integrator_name(method.integrator));
  constexpr double ratio = 0.02;  // of critical damping
  const double omega = [&] {
    const System undamped(damped_cantilever(0));
    return slowest(undamped, Stepper(undamped, {}).initial(), motion).omega;
  }();
  Scene scene = damped_cantilever(2 * ratio / omega);
  scene.settings.integrator = method.integrator;
  const System system(scene);
  Stepper stepper(system, scene.settings);
  State state = stepper.initial();
  const Mode mode = slowest(system, state, motion);
  // So small that it is as good as linear.
  state.v = 1e-4 * mode.shape;
  const double before = energies(system, state).total(), h = method.step / omega;
  const int steps = static_cast<int>(std::lround(4 * std::numbers::pi / method.step));  // two periods
  for (int i = 0; i < steps; ++i) {
    const Advance advance = stepper.advance(state, h);
    REQUIRE(advance.converged);
    state = advance.state;
  }
  // Over whole periods of the damped motion energy falls by e^(-tau omega^2 t).
  const double expected = (2 * ratio + method.own * method.step) * omega * steps * h;
  CHECK(-std::log(energies(system, state).total() / before) == Approx(expected).epsilon(method.tolerance));
  // It stayed in its mode.
  const double along = state.v.cwiseProduct(system.mass).dot(mode.shape) / 1e-4;
  CHECK(along == Approx(std::exp(-expected / 2)).epsilon(5e-3));
}

TEST_CASE("a clamped end that is driven along a path keeps its direction") {
  for (const bool at_start : {true, false}) {
    CAPTURE(at_start);
    Scene scene = damped_cantilever(0.05);
    Cable& cable = scene.cables[0];
    const Vector3 way(0.1, -0.3, 0.2);
    if (!at_start) {
      std::swap(cable.start, cable.end);
      std::swap(scene.particles.front().fixed, scene.particles.back().fixed);
    }
    Particle& held = at_start ? scene.particles.front() : scene.particles.back();
    held.path = {{0, held.position}, {2, held.position + way}};
    scene.settings.drag = 3;
    const System system(scene);
    Stepper stepper(system, scene.settings);
    State state = stepper.initial();
    for (int i = 0; i < 1200; ++i) {
      const Advance advance = stepper.advance(state, 1.0 / 60);
      REQUIRE(advance.converged);
      // In the middle of the way, and at the speed of the path.
      if (i == 59) {
        const Index p = at_start ? 0 : 8;
        CHECK((position(advance.state.q, p) - (held.position + 0.5 * way)).norm() < 1e-12);
        CHECK((position(advance.state.v, p) - 0.5 * way).norm() < 1e-9);
      }
      state = advance.state;
    }
    for (Index p = 0; p < 9; ++p) {
      CHECK((position(state.q, p) - (scene.particles[p].position + way)).norm() < 1e-6);
    }
  }
}

TEST_CASE("an end is turned, and a ring wound up, until it is said to rest") {
  Scene scene = damped_cantilever(0.05);
  scene.settings.drag = 3;
  scene.cables[0].end.clamped = true;
  scene.cables[0].end.twist_rate = 0.8;
  scene.cables[0].end.twist_until = 0.5;
  scene.particles.back().fixed = {true, true, true};
  const System system(scene);
  // G J / L times the square of the angle, halved.
  CHECK(energies(system, at_rest(system, scene)).twist == Approx(0.5 * 0.3 * 0.4 * 0.4).epsilon(1e-9));

  Scene ring;
  ring.settings.gravity.setZero();
  Cable cable;
  for (int i = 0; i < 12; ++i) {
    cable.particles.push_back(
        add_particle(ring, {std::cos(std::numbers::pi * i / 6), std::sin(std::numbers::pi * i / 6), 0}, 0));
  }
  set_material(cable, 1e6, 0.3, 0.01, 1000);
  cable.closed = true;
  cable.closing_twist_rate = 0.7;
  cable.closing_twist_until = 2;
  ring.cables.push_back(cable);
  const System wound(ring);
  const Energy energy(wound);
  const VectorX& q = wound.initial_position;
  const Frames frames = wound.initial_frames(q);
  const auto total_twist = [&](double time) {
    const VectorX strains = energy.strains(q, frames, time);
    double sum = 0;
    for (std::size_t j = 0; j < wound.joints.size(); ++j)
      sum += strains[static_cast<Eigen::Index>(wound.stretch_elements.size() + 3 * j + 2)];
    return sum;
  };
  CHECK(std::abs(total_twist(0)) < 1e-12);
  CHECK(total_twist(1) == Approx(0.7));
  CHECK(total_twist(2) == Approx(1.4));
  CHECK(total_twist(50) == Approx(1.4));
}
