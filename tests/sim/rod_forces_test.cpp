// The forces and moments that hold a cable in shape, against theory.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/energy_budget.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// A cantilever of length 1 along x with E I = 1, that hardly stretches.
Scene loaded_cantilever(Index segments) {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-10;
  Cable& cable = add_cable(scene, {0, 0, 0}, {1, 0, 0}, segments);
  cable.radius = 0.01;
  cable.density = 1000;
  cable.stretch = 1e5;
  cable.bend = 1;
  cable.start.clamped = true;
  scene.particles.front().fixed = {true, true, true};
  return scene;
}

struct Bent {
  State state;
  Energies stored;
  double turned;  // rad, by the last segment
};

/// Its shape under a moment about y at the end, which is a couple of forces across its last segment, and turns with it.
/// A scene has no such forces, so they are set in the system while it comes to rest.
Bent under_end_moment(double moment, Index segments) {
  const Scene scene = loaded_cantilever(segments);
  System system(scene);
  Stepper stepper(system, scene.settings);
  State state = stepper.initial();
  const Index a = segments - 1, b = segments;
  double turned = 0;
  Vector3 before = Vector3::UnitX();
  for (int step = 0; step < 4000; ++step) {
    const Vector3 segment = position(state.q, b) - position(state.q, a);
    turned += std::atan2(before.cross(segment).y(), before.dot(segment));
    before = segment;
    // In full after 400 steps; the last ones are as long as it takes to leave no motion.
    const double now = moment * std::min(1.0, step / 400.0);
    const Vector3 across = Vector3::UnitY().cross(segment) / segment.squaredNorm();
    system.force.segment<3>(3 * static_cast<Eigen::Index>(a)) = -now * across;
    system.force.segment<3>(3 * static_cast<Eigen::Index>(b)) = now * across;
    const Advance advance = stepper.advance(state, 0.05);
    REQUIRE(advance.converged);
    const double moved = (advance.state.q - state.q).lpNorm<Eigen::Infinity>();
    state = advance.state;
    state.v.setZero();
    if (step > 500 && moved < 1e-10) return {state, energies(system, state), turned};
  }
  FAIL("it does not come to rest");
  return {};
}

struct Hung {
  double sag = 0;                                        // over the span
  double least_horizontal = 1e300, most_horizontal = 0;  // pull, over the weight of a span's length
};

/// A cable 1.2 times as long as its span; at first it hangs as a V of the same length.
Hung hung(Index segments) {
  Scene scene;
  scene.settings.newton_tolerance = 1e-10;
  Cable cable;
  const double depth = std::sqrt(0.6 * 0.6 - 0.5 * 0.5);
  for (Index i = 0; i <= segments; ++i) {
    const double s = static_cast<double>(i) / segments;
    cable.particles.push_back(add_particle(scene, {s, 0, -depth * (1 - std::abs(2 * s - 1))}, 0));
  }
  scene.particles.front().fixed = scene.particles.back().fixed = {true, true, true};
  set_material(cable, 1e11, 0.3, 0.005, 1000);
  cable.bend = cable.twist = 0;
  scene.cables.push_back(cable);
  const System system(scene);
  const State state = at_rest(system, scene);
  const double weight = 1000 * std::numbers::pi * 0.005 * 0.005 * 9.81;  // N/m
  Hung hung;
  hung.sag = -position(state.q, segments / 2).z();
  for (const StretchElement& element : system.stretch_elements) {
    const Vector3 along = position(state.q, element.b) - position(state.q, element.a);
    const double pull = element.stiffness * (along.norm() - element.rest) * along.x() / along.norm() / weight;
    hung.least_horizontal = std::min(hung.least_horizontal, pull);
    hung.most_horizontal = std::max(hung.most_horizontal, pull);
  }
  return hung;
}

}  // namespace

TEST_CASE("an end moment of 2 pi E I / L closes a cable to a circle") {
  const Index segments = 40;
  const Bent coarse = under_end_moment(2 * std::numbers::pi, segments),
             fine = under_end_moment(2 * std::numbers::pi, 2 * segments);
  const auto gap = [](const Bent& bent, Index n) { return position(bent.state.q, n).norm(); };
  const auto diameter = [](const Bent& bent, Index n) { return position(bent.state.q, n / 2).norm(); };
  // The last segment's middle is half a segment before the end, and turns by so much less.
  const auto share = [](Index n) { return 1 - 0.5 / n; };
  CAPTURE(gap(coarse, segments), gap(fine, 2 * segments));
  CHECK(gap(fine, 2 * segments) < 2.2e-3);
  CHECK(std::log2(gap(coarse, segments) / gap(fine, 2 * segments)) == Approx(2).margin(0.05));
  CHECK(limit_of_second_order(diameter(coarse, segments), diameter(fine, 2 * segments)) ==
        Approx(1 / std::numbers::pi).epsilon(1e-4));
  CHECK(limit_of_second_order(coarse.turned / share(segments), fine.turned / share(2 * segments)) ==
        Approx(2 * std::numbers::pi).epsilon(1e-4));
  CHECK(limit_of_second_order(coarse.stored.bend / share(segments), fine.stored.bend / share(2 * segments)) ==
        Approx(2 * std::numbers::pi * std::numbers::pi).epsilon(2e-4));  // E I / 2 times the square of the curvature
}

TEST_CASE("a hanging cable takes the shape of a catenary, and pulls as one") {
  const Hung coarse = hung(30), fine = hung(60);
  CAPTURE(coarse.sag, fine.sag, coarse.least_horizontal, fine.least_horizontal);
  CHECK(fine.sag == Approx(0.2923438).epsilon(3e-4));
  CHECK(limit_of_second_order(coarse.sag, fine.sag) == Approx(0.2923438).epsilon(1e-6));
  // The horizontal pull is the same everywhere: a times the weight per length.
  CHECK(fine.most_horizontal == Approx(fine.least_horizontal).epsilon(1e-6));
  CHECK(limit_of_second_order(coarse.least_horizontal, fine.least_horizontal) == Approx(0.4695415).epsilon(2e-6));
}
