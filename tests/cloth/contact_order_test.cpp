// The three answers to contacts of cloth, each alone and left out, and what they hold: folds, and a sheet on a slope.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>

#include "cloth/cloth_scenes.hpp"
#include "scene/scene_file.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::sim;

namespace {

constexpr double kRadius = 1e-3;

/// A sheet at this height above a floor of no thickness, which moves with this speed downwards.
Scene above_floor(double height, double speed) {
  SheetScene sheet = sheet_scene(0.2, 0.2, 4);
  sheet.surface().stretch = 20;
  sheet.surface().bend = 1e-4;
  sheet.surface().damping = 2e-3;
  sheet.surface().radius = kRadius;
  sheet.scene.settings.gravity = {0, 0, -9.81};
  sheet.scene.settings.time_step = 1.0 / 100;
  sheet.scene.settings.contact = {0, 0.3, 1e-3, 8};
  for (Particle& p : sheet.scene.particles) {
    p.position.z() = height;
    p.velocity.z() = -speed;
  }
  add_floor(sheet.scene, 2);
  return sheet.scene;
}

struct Answers {
  std::uint64_t close = 0, passes = 0, solves = 0, zones = 0;
};

Answers answers_of(Simulation& simulation, int steps) {
  Answers sum;
  for (int step = 0; step < steps; ++step) {
    for (const SubstepRecord& record : simulation.step()) {
      sum.close += record.response.close;
      sum.passes += static_cast<std::uint64_t>(record.response.passes);
      sum.solves += static_cast<std::uint64_t>(record.response.solves);
      sum.zones += static_cast<std::uint64_t>(record.response.zones);
    }
  }
  return sum;
}

double lowest(const Simulation& simulation) {
  double z = 1e9;
  for (const Face& face : simulation.scene().surfaces[0].faces) {
    for (const Index p : face) z = std::min(z, position(simulation.state().q, p).z());
  }
  return z;
}

/// The least distance of two edges, or of a particle and a face, of the surface that share no particle. All pairs, by
/// the library's exact distance and not by the simulator's candidates.
double least_distance(const Simulation& simulation) {
  const Surface& surface = simulation.scene().surfaces[0];
  const VectorX& q = simulation.state().q;
  const auto at = [&](Index p) { return Vec3{q[3 * p], q[3 * p + 1], q[3 * p + 2]}; };
  double least = 1e9;
  const auto measure = [&](Kind kind, const std::array<Index, 4>& p) {
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (p[a] == p[b]) return;
      }
    }
    Query query;
    query.kind = kind;
    for (std::size_t c = 0; c < 4; ++c) query.start[c] = query.end[c] = at(p[c]);
    least = std::min(least, touchstone::distance(query).value);
  };
  for (const Face& one : surface.faces) {
    for (const Face& two : surface.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        measure(Kind::vertex_face, {one[k], two[0], two[1], two[2]});
        for (std::size_t l = 0; l < 3; ++l)
          measure(Kind::edge_edge, {one[k], one[(k + 1) % 3], two[l], two[(l + 1) % 3]});
      }
    }
  }
  return least;
}

}  // namespace

TEST_CASE("each answer to contacts can be left out, and each alone stops a falling sheet or says that it cannot") {
  {
    Scene scene = above_floor(0.05, 1);  // all three
    Simulation simulation(scene, {});
    const Answers all = answers_of(simulation, 40);
    CHECK(all.close > 0);
    CHECK(all.solves + all.passes > 0);
    CHECK(lowest(simulation) > kRadius);
  }
  {
    // Repulsion alone holds what begins each substep in the thickness.
    Scene scene = above_floor(kRadius + 5e-4, 0);
    scene.settings.contact.impulses = scene.settings.contact.zones = false;
    Simulation simulation(scene, {});
    const Answers answers = answers_of(simulation, 40);
    CHECK(answers.close > 0);
    CHECK(answers.zones == 0);
    CHECK(answers.passes == 0);
    CHECK(lowest(simulation) > kRadius);
  }
  {
    Scene scene = above_floor(0.05, 1);
    scene.settings.contact.repulsion = scene.settings.contact.zones = false;
    Simulation simulation(scene, {});
    const Answers answers = answers_of(simulation, 40);
    CHECK(answers.close == 0);
    CHECK(answers.zones == 0);
    CHECK(answers.solves + answers.passes > 0);
    CHECK(lowest(simulation) > kRadius);
  }
  {
    Scene scene = above_floor(0.05, 1);
    scene.settings.contact.repulsion = scene.settings.contact.impulses = false;
    Simulation simulation(scene, {});
    const Answers answers = answers_of(simulation, 15);
    CHECK(answers.close == 0);
    CHECK(answers.passes == 0);
    CHECK(answers.zones > 0);
    CHECK(lowest(simulation) > kRadius);
  }
  {
    Scene scene = above_floor(0.05, 1);
    scene.settings.contact.repulsion = scene.settings.contact.impulses = scene.settings.contact.zones = false;
    Simulation simulation(scene, {});
    CHECK_THROWS_WITH(answers_of(simulation, 40),
                      Catch::Contains("found no response") && Catch::Contains("would come within 0.001 m"));
  }
}

TEST_CASE("the switches of contacts pass through JSON, and are there only when something is left out") {
  Scene scene = above_floor(0.05, 1);
  CHECK(scene_to_json(scene).find("repulsion") == std::string::npos);
  scene.settings.contact.zones = scene.settings.contact.repulsion = false;
  const Scene again = scene_from_json(scene_to_json(scene));
  CHECK(!again.settings.contact.zones);
  CHECK(!again.settings.contact.repulsion);
  CHECK(again.settings.contact.impulses);
  CHECK(scene_to_json(again) == scene_to_json(scene));
}

TEST_CASE("friction within the thickness holds a sheet on a slope, and lets it slide on a steeper one") {
  for (const double friction : {0.5, 0.1}) {
    Scene scene = above_floor(kRadius + 5e-4, 0);
    const double slope = 0.3;
    scene.settings.gravity = 9.81 * Vector3(std::sin(slope), 0, -std::cos(slope));
    scene.settings.contact.friction = friction;
    Simulation simulation(scene, {});
    answers_of(simulation, 50);
    const double moved = position(simulation.state().q, 0).x() - scene.particles[0].position.x();
    const double free = 0.5 * 9.81 * (std::sin(slope) - friction * std::cos(slope)) * 0.25;
    CAPTURE(friction, moved, free);
    if (free < 0) {
      CHECK(std::abs(moved) < 2e-3);
    } else {
      CHECK(moved == Approx(free).epsilon(0.1));
    }
  }
}

TEST_CASE("a folded sheet stays folded, and keeps its thickness", "[slow]") {
  // A strip that lies on the floor, turns back over a half circle, and lies on itself.
  SheetScene sheet = sheet_scene(0.1, 0.4, 4);
  constexpr double kTurn = 8e-3, kBottom = kRadius + 4e-4;  // radius of the fold; m
  for (Particle& p : sheet.scene.particles) {
    const double y = p.position.y(), half = 0.5 * 3.141592653589793 * kTurn;
    if (y < 0.2 - half) {
      p.position.z() = kBottom;
    } else if (y > 0.2 + half) {
      p.position.y() = 0.4 - y;
      p.position.z() = kBottom + 2 * kTurn;
    } else {
      const double angle = (y - 0.2 + half) / kTurn;
      p.position.y() = 0.2 - half + kTurn * std::sin(angle);
      p.position.z() = kBottom + kTurn * (1 - std::cos(angle));
    }
  }
  sheet.surface().stretch = 20;
  sheet.surface().bend = 1e-7;
  sheet.surface().damping = 5e-3;
  sheet.surface().radius = kRadius;
  sheet.scene.settings.gravity = {0, 0, -9.81};
  sheet.scene.settings.time_step = 1.0 / 100;
  sheet.scene.settings.drag = 1;
  sheet.scene.settings.contact = {0, 0.5, 5e-4, 8};
  add_floor(sheet.scene, 2);
  Simulation simulation(sheet.scene, {});
  const Index end = sheet.mesh.rows.back().front(), start = sheet.mesh.rows.front().front();
  const Vector3 before = position(simulation.state().q, end) - position(simulation.state().q, start);
  const Answers answers = answers_of(simulation, static_cast<int>(tests::effort(60)));
  CHECK(answers.close > 0);
  CHECK(simulation.crossings().empty());
  const Vector3 after = position(simulation.state().q, end) - position(simulation.state().q, start);
  CAPTURE(before.transpose(), after.transpose());
  CHECK(std::abs(after.y() - before.y()) < 0.03);  // it has not opened
  CHECK(after.z() > 2 * kRadius);                  // the end lies above the start, and on it
  if (tests::whole_effort("the fold comes to rest on itself")) CHECK(after.z() < 2 * kRadius + 2e-3);
  // Corners of a triangle are farther apart than (pi / 2) (2 r), so that only elements with a common particle are
  // neighbours.
  CHECK(least_distance(simulation) > 2 * kRadius);
}

TEST_CASE("cloth that is pulled to its limit of stretch is refused, and the refusal says so") {
  SheetScene sheet = sheet_scene(0.2, 0.2, 3);
  sheet.surface().strain_limit = 0.1;
  for (const Index p : sheet.mesh.rows.front()) sheet.scene.particles[p].fixed = {true, true, true};
  for (const Index p : sheet.mesh.rows.back()) {
    const Vector3 x = sheet.scene.particles[p].position;
    sheet.scene.particles[p].path = {{0, x}, {1, x + Vector3(0, 0.06, 0)}};
  }
  Simulation simulation(sheet.scene, {});
  const auto pull = [&] {
    for (int step = 0; step < 60; ++step) {
      simulation.step();
      CHECK(largest_stretch(sheet.scene, simulation.state().q) < 1.1 + 1e-12);
    }
  };
  CHECK_THROWS_WITH(pull(), Catch::Contains("strain_limit"));
  CHECK(simulation.state().time > 0.25);  // 8 % of stretch
  CHECK(simulation.state().time < 0.34);
}
