// Cables against the theory of rods: the elastica, buckling, rings, waves.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "dynamics/stepper.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

constexpr double kCableYoung = 1e7, kRadius = 0.005, kDensity = 1000;
const double kArea = std::numbers::pi * kRadius * kRadius;
const double kBend = kCableYoung * kArea * kRadius * kRadius / 4;  // E I

/// A horizontal cantilever of length 1 without weight, clamped at the origin.
Scene cantilever(Index segments) {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-10;
  Cable& cable = add_cable(scene, {0, 0, 0}, {1, 0, 0}, segments);
  set_material(cable, kCableYoung, 0.3, kRadius, kDensity);
  cable.stretch *= 10;  // the elastica does not stretch
  cable.twist = 0;
  cable.start.clamped = true;
  scene.particles.front().fixed = {true, true, true};
  return scene;
}

struct Tip {
  double drop, shortening;
};
Tip tip_of_elastica(double alpha, Index segments) {
  Scene scene = cantilever(segments);
  scene.particles.back().force = {0, 0, -alpha * kBend};
  const State state = at_rest(scene);
  const Vector3 tip = position(state.q, segments);
  return {-tip.z(), 1 - tip.x()};
}

/// The load at which the straight column stops being stable, by bisection on the smallest eigenvalue.
template <class MakeScene>
double critical_load(MakeScene scene_with_load, double low, double high) {
  for (int i = 0; i < 22; ++i) {
    const double middle = 0.5 * (low + high);
    const Scene scene = scene_with_load(middle);
    const System system(scene);
    // On the axis the column is in equilibrium, stable or not: nothing pushes it sideways. It only shortens.
    Settings settings = scene.settings;
    Stepper stepper(system, settings);
    const Advance advance = stepper.advance(stepper.initial(), 1e4);
    REQUIRE(advance.converged);
    for (std::size_t p = 0; p < system.particle_count(); ++p)
      REQUIRE(std::abs(advance.state.q[static_cast<Eigen::Index>(3 * p + 1)]) < 1e-9);
    (smallest_eigenvalue(stiffness_matrix(system, advance.state)) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

enum class Support { cantilever, pinned, clamped };

/// A vertical column; its upper end, if it is held at all, may still move along the axis.
Scene column(Support support, double load, Index segments) {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-9;
  Cable& cable = add_cable(scene, {0, 0, 0}, {0, 0, 1}, segments);
  set_material(cable, kCableYoung, 0.3, kRadius, kDensity);
  cable.stretch *= 1e3;
  cable.twist = 0;
  scene.particles.front().fixed = {true, true, true};
  scene.particles.back().force = {0, 0, -load};
  if (support != Support::pinned) cable.start.clamped = true;
  if (support != Support::cantilever) scene.particles.back().fixed = {true, true, false};
  return scene;
}

/// The total twist at which a ring of radius 1 stops being stable in its plane.
double ring_buckling_twist(double poisson, Index count) {
  Scene scene;
  scene.settings.gravity.setZero();
  Cable ring;
  for (Index i = 0; i < count; ++i) {
    ring.particles.push_back(add_particle(
        scene, {std::cos(2 * std::numbers::pi * i / count), std::sin(2 * std::numbers::pi * i / count), 0}, 0));
  }
  ring.closed = true;
  set_material(ring, kCableYoung, poisson, kRadius, kDensity);
  ring.stretch *= 10;
  scene.cables.push_back(ring);
  // Six rigid motions have eigenvalue 0, and so has the turning of all sections about the centre line.
  const auto unstable = [&](double twist) {
    scene.cables[0].closing_twist_rate = twist;
    scene.cables[0].closing_twist_until = 1;
    const System system(scene);
    Stepper stepper(system, scene.settings);
    State state = stepper.initial();
    state.time = 2;
    // Joint j lies between edges j and j + 1; the last one holds the inserted twist. Evenly spread, it is
    // in equilibrium except for the ring's size: the ring widens a little.
    for (Index j = 0; j < count; ++j) state.q[system.angle(j)] = twist * j / count;
    const Advance advance = stepper.advance(state, 10);
    REQUIRE(advance.converged);
    for (Index j = 0; j < count; ++j) REQUIRE(std::abs(position(advance.state.q, j).z()) < 1e-4);
    return smallest_eigenvalue(stiffness_matrix(system, advance.state)) < -1e-6 * kBend;
  };
  double low = 5, high = 30;
  REQUIRE_FALSE(unstable(low));
  REQUIRE(unstable(high));
  for (int i = 0; i < 16; ++i) (unstable(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return low;
}

}  // namespace

TEST_CASE("the elastica: tip of a cantilever at three loads") {
  struct Row {
    double alpha, drop, shortening;
  };
  const Row row = GENERATE(Row{1, 0.301721, 0.056433}, Row{2, 0.493457, 0.160642}, Row{10, 0.810609, 0.554996});
  CAPTURE(row.alpha);
  const Tip coarse = tip_of_elastica(row.alpha, 10), middle = tip_of_elastica(row.alpha, 20),
            fine = tip_of_elastica(row.alpha, 40);
  CAPTURE(coarse.drop, middle.drop, fine.drop);
  CHECK(fine.drop == Approx(row.drop).epsilon(1e-3));
  CHECK(fine.shortening == Approx(row.shortening).epsilon(2e-3));
  CHECK(limit_of_second_order(middle.drop, fine.drop) == Approx(row.drop).epsilon(1e-4));
  CHECK(limit_of_second_order(middle.shortening, fine.shortening) == Approx(row.shortening).epsilon(2e-4));
  // Refinement converges with order 2 at least: at the largest load two errors of
  // that order nearly cancel.
  CHECK(std::log2((coarse.drop - middle.drop) / (middle.drop - fine.drop)) > 1.8);
}

TEST_CASE("small loads and own weight bend a cantilever as beam theory says") {
  const double load = 1e-3 * kBend;
  CHECK(tip_of_elastica(1e-3, 60).drop == Approx(load / (3 * kBend)).epsilon(2e-4));
  Scene scene = cantilever(60);
  const double weight = kDensity * kArea * 1e-3;  // N/m
  scene.settings.gravity = {0, 0, -1e-3};
  CHECK(-position(at_rest(scene).q, 60).z() == Approx(weight / (8 * kBend)).epsilon(1e-3));
}

TEST_CASE("a natural curvature of 2 pi / L closes a cable to a circle") {
  constexpr Index kSegments = 80;
  Scene scene = cantilever(kSegments);
  set_material(scene.cables[0], kCableYoung, 0.3, kRadius, kDensity);
  scene.cables[0].stretch *= 10;
  scene.cables[0].natural_curvature = {2 * std::numbers::pi, 0};
  const State state = at_rest(scene);
  CHECK(position(state.q, kSegments).norm() < 2e-3);
  CHECK((position(state.q, kSegments / 2)).norm() == Approx(1 / std::numbers::pi).epsilon(2e-3));
}

TEST_CASE("Euler's critical loads") {
  const double euler = std::numbers::pi * std::numbers::pi * kBend;
  struct Row {
    Support support;
    double factor;
  };
  const Row row = GENERATE(Row{Support::cantilever, 0.25}, Row{Support::pinned, 1}, Row{Support::clamped, 4});
  CAPTURE(row.factor);
  const auto scene = [&](double load) {
    Scene made = column(row.support, load, 40);
    if (row.support == Support::clamped) {
      // A clamp that moves along with the end: two particles at the top that cannot leave the axis, an end joint of
      // half a length apart from the pin's.
      made.particles[39].fixed = {true, true, false};
    }
    return made;
  };
  const double load = critical_load(scene, 0.5 * row.factor * euler, 1.5 * row.factor * euler);
  // The clamp by two particles on the axis makes that end half a segment shorter.
  const double length = row.support == Support::clamped ? 1 - 1.0 / 80 : 1, half_waves = std::sqrt(row.factor);
  // Of n segments a half wave of the column holds x / pi each: sin^2 (x / 2) stands where (x / 2)^2 should.
  const double x = std::numbers::pi * half_waves / (40 * length), discrete = std::pow(2 * std::sin(x / 2) / x, 2);
  CHECK(load / euler == Approx(row.factor / (length * length)).epsilon(3e-3));
  CHECK(load / euler == Approx(discrete * row.factor / (length * length)).epsilon(1e-4));
}

TEST_CASE("a column buckles under its own weight at rho A g L^3 / (E I) = 7.837") {
  const auto scene = [](double number) {
    Scene made = column(Support::cantilever, 0, 40);
    made.settings.gravity = {0, 0, -number * kBend / (kDensity * kArea)};
    return made;
  };
  CHECK(critical_load(scene, 4, 12) == Approx(7.837).epsilon(5e-4));
}

TEST_CASE("a clamped column buckles under end twist at 8.98682 E I / L") {
  // G J is large beside E I, so that the twist stays small and the moment is G J / L times it.
  const auto critical_moment = [](Index segments) {
    const auto scene = [=](double moment) {
      Scene made = column(Support::pinned, 0, segments);
      Cable& cable = made.cables[0];
      cable.stretch *= 1e3;
      cable.twist = 1e3 * kBend;
      cable.start.clamped = cable.end.clamped = true;
      made.particles.back().fixed = {true, true, true};
      cable.end.twist_rate = moment * kBend / cable.twist;  // for one second
      cable.end.twist_until = 1;
      return made;
    };
    return critical_load(scene, 6, 12);
  };
  const double coarse = critical_moment(20), fine = critical_moment(40);
  CAPTURE(coarse, fine);
  CHECK(fine == Approx(8.98682).epsilon(5e-3));
  CHECK(limit_of_second_order(coarse, fine) == Approx(8.98682).epsilon(2e-4));
}

TEST_CASE("Michell's ring buckles at a total twist of 2 pi sqrt(3) E I / (G J)") {
  const double poisson = GENERATE(0.3, 0.5), known = poisson == 0.3 ? 14.1476 : 16.3242;
  CAPTURE(poisson);
  const double coarse = ring_buckling_twist(poisson, 24), fine = ring_buckling_twist(poisson, 48);
  CAPTURE(coarse, fine);
  CHECK(fine == Approx(known).epsilon(0.01));
  CHECK(limit_of_second_order(coarse, fine) == Approx(known).epsilon(1e-3));
}

TEST_CASE("a twisted cable, fixed at one end and free at the other, swings back with frequency c / (4 L)") {
  constexpr Index kSegments = 40;
  Scene scene = cantilever(kSegments);
  Cable& cable = scene.cables[0];
  set_material(cable, kCableYoung, 0.3, kRadius, kDensity);
  scene.settings.integrator = Integrator::tr_bdf2;
  const System system(scene);
  Stepper stepper(system, scene.settings);
  State state = stepper.initial();
  for (Index j = 0; j < kSegments; ++j) {
    state.q[system.angle(j)] = 0.1 * std::sin(std::numbers::pi / 2 * (j + 0.5) / kSegments);
  }
  const double shear = kCableYoung / 2.6, period = 4 / std::sqrt(shear / kDensity), h = period / 400;
  const Eigen::Index last = system.angle(kSegments - 1);
  double before = state.q[last], first = 0;
  while (first == 0 && state.time < period) {
    const Advance advance = stepper.advance(state, h);
    REQUIRE(advance.converged);
    state = advance.state;
    if (state.q[last] <= 0) first = state.time - h * state.q[last] / (state.q[last] - before);
    before = state.q[last];
  }
  CHECK(4 * first == Approx(period).epsilon(2e-4));
}

TEST_CASE("a cantilever's first frequency") {
  constexpr Index kSegments = 40;
  Scene scene = cantilever(kSegments);
  scene.particles.back().force = {0, 0, -0.01 * kBend};
  State state = at_rest(scene);
  scene.particles.back().force.setZero();
  scene.settings.integrator = Integrator::tr_bdf2;
  const System system(scene);
  Stepper stepper(system, scene.settings);
  const double omega = 1.8751 * 1.8751 * std::sqrt(kBend / (kDensity * kArea)), period = 2 * std::numbers::pi / omega;
  const double h = period / 500;
  state.time = 0;
  const Eigen::Index tip = 3 * kSegments + 2;
  double before = state.q[tip];
  std::vector<double> crossings;
  while (crossings.size() < 3) {
    const Advance advance = stepper.advance(state, h);
    REQUIRE(advance.converged);
    state = advance.state;
    if ((before < 0) != (state.q[tip] < 0))
      crossings.push_back(state.time - h * state.q[tip] / (state.q[tip] - before));
    before = state.q[tip];
    REQUIRE(state.time < 3 * period);
  }
  CHECK(crossings[2] - crossings[0] ==
        Approx(period).epsilon(2e-2));  // a static shape holds a little of the higher modes
}
