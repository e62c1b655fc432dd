// The three limits on the length of an explicit step of a rod, each from both sides.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

// Steel, r = 1 mm, in segments of 1 cm.
constexpr double kSectionYoung = 2e11, kPoisson = 0.3, kDensity = 7800, kRadius = 1e-3, kLength = 0.01;
constexpr double kShear = kSectionYoung / (2 * (1 + kPoisson));
constexpr Index kSegments = 40;

enum class SpringMotion { stretch, twist, bend };

/// How much faster the fastest motion of this kind is after 200 explicit steps of h.
double growth(SpringMotion motion, double h) {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.integrator = Integrator::symplectic_euler;
  Cable& cable = add_cable(scene, {0, 0, 0}, {kSegments * kLength, 0, 0}, kSegments);
  set_material(cable, kSectionYoung, kPoisson, kRadius, kDensity);
  // A motion with a shorter limit than the tested one is made soft.
  if (motion != SpringMotion::stretch) cable.stretch *= motion == SpringMotion::twist ? 1e-2 : 1e-4;
  if (motion != SpringMotion::twist) cable.twist = 0;
  const System system(scene);
  Stepper stepper(system, scene.settings);
  State state = stepper.initial();
  // Neighbours move against each other: the fastest motion that the segments know.
  constexpr double kSpeed = 1e-6;
  for (Index i = 0; i < kSegments; ++i) {
    const double speed = i % 2 == 0 ? kSpeed : -kSpeed;
    if (motion == SpringMotion::twist) {
      state.v[system.angle(i)] = speed;
    } else {
      state.v[3 * static_cast<Eigen::Index>(i) + (motion == SpringMotion::stretch ? 0 : 1)] = speed;
    }
  }
  for (int step = 0; step < 200; ++step) {
    const Advance advance = stepper.advance(state, h);
    if (!advance.converged) return 1e300;
    state = advance.state;
  }
  return state.v.lpNorm<Eigen::Infinity>() / kSpeed;
}

}  // namespace

TEST_CASE("explicit steps are stable up to the limits of stretch, twist and bending, and not beyond") {
  const double area = std::numbers::pi * kRadius * kRadius, moment = area * kRadius * kRadius / 4;
  struct Row {
    SpringMotion motion;
    double limit, known;
  };
  // 2 / omega of the fastest motion. The known values are rounded to three digits.
  const Row row =
      GENERATE_COPY(Row{SpringMotion::stretch, kLength * std::sqrt(kDensity / kSectionYoung), 1.98e-6},
                    Row{SpringMotion::twist, kLength * std::sqrt(kDensity / kShear), 3.19e-6},
                    Row{SpringMotion::bend,
                        0.5 * kLength * kLength * std::sqrt(kDensity * area / (kSectionYoung * moment)), 19.8e-6});
  CAPTURE(static_cast<int>(row.motion), row.limit);
  CHECK(row.limit == Approx(row.known).epsilon(4e-3));
  CHECK(growth(row.motion, 0.98 * row.limit) < 10);
  CHECK(growth(row.motion, 1.02 * row.limit) > 1e6);
}
