// Cloth in motion: momentum, energy, islands, checkpoints, the limit of stretch, and folds that keep their thickness.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "cloth/cloth_scenes.hpp"
#include "sim/checkpoint.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

/// A sheet that is thrown, crumpled and stretched.
SheetScene thrown(Index columns) {
  SheetScene sheet = sheet_scene(0.4, 0.3, columns);
  Rng random(5);
  sheet.surface().damping = 1e-3;
  for (Particle& p : sheet.scene.particles) {
    p.position.z() = 0.02 * std::sin(20 * p.position.x()) + 1;
    p.velocity = {1, -0.5, 0.3 + 2 * std::cos(9 * p.position.y())};
  }
  return sheet;
}

Vector3 momentum(const Simulation& simulation) {
  Vector3 sum = Vector3::Zero();
  const VectorX product = simulation.system().mass.cwiseProduct(simulation.state().v);
  for (Eigen::Index at = 0; at + 2 < product.size(); at += 3) sum += product.segment<3>(at);
  return sum;
}

}  // namespace

TEST_CASE("a free sheet keeps its momentum, and no integrator gives it energy") {
  for (const auto integrator : {Integrator::implicit_euler, Integrator::tr_bdf2, Integrator::implicit_midpoint}) {
    SheetScene sheet = thrown(5);
    sheet.scene.settings.integrator = integrator;
    sheet.scene.settings.newton_tolerance = 1e-12;
    sheet.scene.settings.time_step = 1.0 / 200;
    Simulation simulation(sheet.scene, {});
    const Vector3 before = momentum(simulation);
    double energy = simulation.energies().total();
    CAPTURE(integrator_name(integrator));
    for (int step = 0; step < 20; ++step) {
      simulation.step();
      const double now = simulation.energies().total();
      CHECK(now <= energy * (1 + 2e-3));  // S of the energy bound
      energy = now;
    }
    CHECK((momentum(simulation) - before).norm() < 1e-9 * before.norm());
    CHECK(simulation.energies().bend > 0);
    CHECK(simulation.energies().stretch > 0);
  }
}

TEST_CASE("two large sheets are islands of their own, and move as each does alone") {
  SheetScene one = thrown(20);
  Scene both = one.scene;
  const auto shift = static_cast<Index>(both.particles.size());
  for (const Particle& p : one.scene.particles) {
    both.particles.push_back(p);
    both.particles.back().position.z() += 5;
  }
  Surface second = both.surfaces[0];
  for (Face& face : second.faces) {
    for (Index& p : face) p += shift;
  }
  both.surfaces.push_back(second);
  REQUIRE(3 * shift > 1000);
  const auto ends = [](const Scene& scene) {
    const System system(scene);
    Stepper stepper(system, scene.settings);
    State state = stepper.initial();
    for (int step = 0; step < 3; ++step) {
      const Advance advance = stepper.advance(state, 0.005);
      REQUIRE(advance.converged);
      state = advance.state;
    }
    return state.q;
  };
  const VectorX alone = ends(one.scene), together = ends(both);
  CHECK((together.head(alone.size()) - alone).lpNorm<Eigen::Infinity>() < 1e-6);
  CHECK((together.head(alone.size()) - together.tail(alone.size())).norm() ==
        Approx(5 * std::sqrt(static_cast<double>(shift))));
}

TEST_CASE("a checkpoint of cloth in contact resumes to the same bits") {
  SheetScene sheet = thrown(4);
  sheet.scene.settings.gravity = {0, 0, -9.81};
  sheet.scene.settings.contact.friction = 0.4;
  sheet.surface().radius = 1e-3;
  sheet.surface().strain_limit = 0.2;
  for (Particle& p : sheet.scene.particles) p.position.z() -= 0.97;
  add_floor(sheet.scene, 2);
  Simulation whole(sheet.scene, {}), first(sheet.scene, {});
  std::uint64_t close = 0;
  for (int step = 0; step < 16; ++step) {
    for (const SubstepRecord& record : whole.step()) close += record.response.close;
  }
  CHECK(close > 0);
  for (int step = 0; step < 8; ++step) first.step();
  Checkpoint checkpoint = checkpoint_from_json(checkpoint_to_json(first));
  Simulation second(checkpoint.scene, {});
  second.resume(checkpoint.state, checkpoint.steps);
  for (int step = 0; step < 8; ++step) second.step();
  CHECK(checkpoint_to_json(second) == checkpoint_to_json(whole));
}

TEST_CASE("no principal stretch reaches its limit, whatever hangs on the sheet", "[slow]") {
  for (const double limit : {0.1, 0.02}) {
    SheetScene sheet = sheet_scene(0.4, 0.4, 5);
    sheet.surface().stretch = 20;
    sheet.surface().strain_limit = limit;
    sheet.scene.settings.gravity = {0, 0, -9.81};
    // Two corners hold the sheet, and a weight of 40 times its own pulls at a third one.
    for (const Index p : {sheet.mesh.rows.front().front(), sheet.mesh.rows.front().back()})
      sheet.scene.particles[p].fixed = {true, true, true};
    sheet.scene.particles[sheet.mesh.rows.back().back()].mass = 1.3;
    Simulation simulation(sheet.scene, {});
    double most = 0;
    for (int step = 0; step < 60; ++step) {
      simulation.step();
      most = std::max(most, largest_stretch(sheet.scene, simulation.state().q));
      CHECK(most < 1 + limit + 1e-12);
    }
    CAPTURE(limit, most);
    CHECK(most > 1 + 0.8 * limit);

    // Without a limit, it is stretched much further.
    sheet.surface().strain_limit = 0;
    Simulation free(sheet.scene, {});
    for (int step = 0; step < 60; ++step) free.step();
    CHECK(largest_stretch(sheet.scene, free.state().q) > 1 + 2 * limit);
  }
}
