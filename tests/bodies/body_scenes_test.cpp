// The shipped scenes of bodies: links stay linked, boxes stay where they are, a nut turns as its thread leads it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "scene/shipped_scenes.hpp"
#include "sim/linking.hpp"
#include "sim/simulation.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone::sim;
using touchstone::tests::effort;
using touchstone::tests::whole_effort;

namespace {

/// The corners of all bodies, and of each body the numbers of its corners, which follow its wire.
struct Placed {
  VectorX corners;
  std::vector<Loop> loops;
};

Placed placed_corners(const Simulation& simulation) {
  Placed all;
  const auto& bodies = simulation.bodies()->system().bodies();
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Loop& loop = all.loops.emplace_back();
    for (const Vector3& x : bodies[i].points) {
      loop.push_back(static_cast<Index>(points.size()));
      points.push_back(placed(simulation.bodies()->state().bodies[i].pose, x));
    }
  }
  all.corners.resize(static_cast<Eigen::Index>(3 * points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) all.corners.segment<3>(3 * static_cast<Eigen::Index>(i)) = points[i];
  return all;
}

std::vector<int> linking_numbers(const Simulation& simulation) {
  const Placed all = placed_corners(simulation);
  std::vector<int> numbers;
  for (std::size_t i = 0; i < all.loops.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) numbers.push_back(linking_number(all.corners, all.loops[i], all.loops[j]));
  }
  return numbers;
}

}  // namespace

TEST_CASE("a falling chain of links stays linked: each linking number is what it was") {
  Simulation simulation(make_shipped_scene("link-chain", 8), {});
  const std::vector<int> before = linking_numbers(simulation);
  std::size_t at = 0;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < i; ++j) CHECK(std::abs(before[at++]) == (i - j == 1 ? 1 : 0));
  }
  const double energy = simulation.energies().total();
  std::uint64_t contacts = 0;
  const std::size_t steps = effort(600);
  for (std::size_t i = 0; i < steps; ++i) {
    for (const auto& record : simulation.step()) contacts += record.bodies.contacts + record.bodies.close;
  }
  CHECK((contacts > 0 || !whole_effort("that links meet")));
  CHECK(linking_numbers(simulation) == before);
  CHECK((simulation.energies().total() < energy || !whole_effort("that links which meet lose energy")));
  CHECK(simulation.crossings().empty());
}

TEST_CASE("boxes on one another stay at rest") {
  Simulation simulation(make_shipped_scene("stack", 4), {});
  const BodyStates before = simulation.bodies()->state().bodies;
  for (std::size_t i = 0; i < effort(300); ++i) simulation.step();
  const BodyStates& after = simulation.bodies()->state().bodies;
  for (std::size_t i = 0; i < after.size(); ++i) {
    CHECK((after[i].pose.p - before[i].pose.p).norm() < 1e-5);
    CHECK(turn_between(before[i].pose.q, after[i].pose.q).norm() < 1e-5);
  }
  CHECK(simulation.refused(Cause::not_resolved) == 0);
}

TEST_CASE("a nut turns and descends as its thread leads it") {
  Simulation simulation(make_shipped_scene("nut-and-bolt", 24), {});
  const Pose before = simulation.bodies()->state().bodies[1].pose;
  const std::size_t steps = effort(100);
  for (std::size_t i = 0; i < steps; ++i) simulation.step();
  const Pose after = simulation.bodies()->state().bodies[1].pose;
  const double down = before.p.z() - after.p.z();
  const double turn = std::abs(turn_between(before.q, after.q).z());
  CAPTURE(down, turn);
  if (touchstone::tests::whole_effort("the nut's descent")) {
    CHECK(down > 2e-4);
    CHECK(turn > 0.05);
  }
  // The thread's play lets it be off by the clearance along the axis.
  CHECK(std::abs(down - turn / (2 * std::numbers::pi) * 0.010) < 1e-3);
  CHECK(std::abs(after.p.x()) + std::abs(after.p.y()) < 1e-3);
}

TEST_CASE("a ball of springs bounces off a board and a rigid rim, and goes through the net") {
  Simulation simulation(make_shipped_scene("hoop-rim", 560), {});
  const auto& particles = simulation.scene().particles;
  const auto found = std::find_if(particles.begin(), particles.end(), [](const Particle& p) { return !p.collides; });
  REQUIRE(found != particles.end());
  const auto middle = static_cast<Index>(found - particles.begin());
  constexpr double kNetEnd = 1.2, kRim = 0.225;  // m: height of the net's lower end, radius of the rim
  bool met_board = false;
  std::uint64_t after_board = 0;  // contacts with the rim, above the net
  const std::size_t steps = effort(960);
  for (std::size_t i = 0; i < steps && position(simulation.state().q, middle).z() > kNetEnd; ++i) {
    const double before = position(simulation.state().v, middle).x();
    for (const auto& record : simulation.step()) {
      if (met_board) after_board += record.bodies.contacts + record.bodies.close;
    }
    const double after = position(simulation.state().v, middle).x();
    met_board |= before > 0 && after < 0;
  }
  CHECK(simulation.crossings().empty());
  if (!touchstone::tests::whole_effort("the ball's way through the net")) return;
  CHECK(met_board);
  CHECK(after_board > 0);
  const Vector3 end = position(simulation.state().q, middle);
  CHECK(end.z() <= kNetEnd);
  CHECK(end.head<2>().norm() < kRim);
}
