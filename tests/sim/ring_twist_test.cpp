// A ring's twist and writhe: their sum is the linking number of its edges, which no motion changes.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "scene/parts.hpp"
#include "scene/shipped_scenes.hpp"
#include "seeded/rng.hpp"
#include "sim/linking.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// Turns of twist over all joints of a scene that is one ring.
double total_twist(const System& system, const State& state) {
  const VectorX strains = Energy(system).strains(state.q, state.frames, state.time);
  double sum = 0;
  for (std::size_t j = 0; j < system.joints.size(); ++j)
    sum += strains[static_cast<Eigen::Index>(system.stretch_elements.size() + 3 * j + 2)];
  return sum / (2 * std::numbers::pi);
}

/// Calugareanu, White and Fuller: an integer, because the ribbon closes, plus the inserted twist.
double linking_of_edges(const System& system, const State& state, const Loop& ring) {
  return total_twist(system, state) + gauss_integral(state.q, ring, ring);
}

Scene ring_of(const std::vector<Vector3>& corners) {
  Scene scene;
  scene.settings.gravity.setZero();
  Cable cable;
  for (const Vector3& corner : corners) cable.particles.push_back(add_particle(scene, corner, 0));
  cable.closed = true;
  set_material(cable, 1e5, 0.4, 0.01, 1000);
  scene.cables.push_back(cable);
  return scene;
}

}  // namespace

TEST_CASE("twist and writhe of any ring as it is placed add up to an integer") {
  touchstone::seeded::Rng random(5);
  double most_writhe = 0;
  for (int round = 0; round < 50; ++round) {
    std::vector<Vector3> corners;
    for (int i = 0; i < 12; ++i) {
      const double phi = std::numbers::pi * i / 6;
      corners.push_back({std::cos(phi) + 0.4 * random.symmetric(), std::sin(phi) + 0.4 * random.symmetric(),
                         0.8 * random.symmetric()});
    }
    const Scene scene = ring_of(corners);
    const System system(scene);
    const State state = Stepper(system, scene.settings).initial();
    const double sum = linking_of_edges(system, state, scene.cables[0].particles);
    CAPTURE(round, sum);
    CHECK(std::abs(sum - std::round(sum)) < 1e-9);
    most_writhe =
        std::max(most_writhe, std::abs(gauss_integral(state.q, scene.cables[0].particles, scene.cables[0].particles)));
  }
  CHECK(most_writhe > 0.3);
}

TEST_CASE("a ring that is wound up buckles and touches itself, and keeps the linking number of its edges", "[slow]") {
  const auto integrator = GENERATE(Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint);
  CAPTURE(integrator_name(integrator));
  Scene scene = make_shipped_scene("ring-twist", 24);
  scene.settings.integrator = integrator;
  const Cable& cable = scene.cables[0];
  const Loop& ring = cable.particles;
  Simulation simulation(scene, {});
  std::uint64_t contacts = 0;
  double most_writhe = 0;
  for (int i = 0; i < 300; ++i) {
    for (const auto& record : simulation.step()) contacts += record.response.contacts;
    const State& state = simulation.state();
    const double inserted =
        cable.closing_twist_rate * std::min(state.time, cable.closing_twist_until) / (2 * std::numbers::pi);
    CAPTURE(i);
    CHECK(linking_of_edges(simulation.system(), state, ring) == Approx(inserted).margin(1e-8));
    most_writhe = std::max(most_writhe, std::abs(gauss_integral(state.q, ring, ring)));
  }
  CHECK(contacts > 0);
  CHECK(most_writhe > 0.5);
  CHECK(simulation.crossings().empty());
}
