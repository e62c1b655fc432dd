// What a run follows in its table of energies: bodies, their vertices and particles, on a motion that is known.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies_support.hpp"
#include "sim/followed.hpp"
#include "sim/output_text.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;
using namespace touchstone::tests;

TEST_CASE("names of what is followed") {
  CHECK(followed_from("12") == Followed{12, {}, {}});
  CHECK(followed_from("body:3") == Followed{{}, 3, {}});
  CHECK(followed_from("body:3:7") == Followed{{}, 3, 7});
  for (const char* text : {"", "-1", "+1", "1.5", "1 ", " 1", "body", "body:", "body:x", "body:3:", "body:3:7:1",
                           "body::7", "Body:3", "3:7", "99999999999999999999", "body:99999999999999999999"}) {
    INFO("text: '" << text << "'");
    CHECK(!followed_from(text));
  }
}

TEST_CASE("a body that turns in a quarter of a second by a quarter, its vertex and a particle beside it") {
  // A cube: each axis through its centre is a principal one.
  Scene scene = empty_scene(1.0 / 100);
  scene.bodies.push_back(box_at({0.2, 0.2, 0.2}, {1, 2, 3}));
  scene.bodies[0].velocity = {4, 0, -8};
  scene.bodies[0].angular_velocity = {0, 0, 2 * std::numbers::pi};
  Particle particle;
  particle.mass = 1;
  particle.position = {50, 0, 0};
  particle.velocity = {0, 4, 0};
  scene.particles.push_back(particle);
  const Followed body{{}, 0, {}}, vertex{{}, 0, 0}, beside{0, {}, {}};
  CHECK(missing_in(scene, body).empty());
  CHECK(missing_in(scene, Followed{{}, 1, {}}) == "there is no such body: there are 1");
  CHECK(missing_in(scene, Followed{{}, 0, 8}) == "there is no such vertex: the body has 8");
  CHECK(missing_in(scene, Followed{1, {}, {}}) == "there is no such particle: there are 1");

  const Vector3 arm = scene.bodies[0].vertices[0];
  Simulation simulation(scene, {});
  for (int i = 0; i < 25; ++i) simulation.step();
  const auto near = [](const std::vector<double>& values, const std::vector<double>& expected) {
    REQUIRE(values.size() == expected.size());
    for (std::size_t i = 0; i < values.size(); ++i) CHECK(std::abs(values[i] - expected[i]) < 1e-6);
  };
  near(values_of(simulation, body), {2, 2, 1, std::sqrt(0.5), 0, 0, std::sqrt(0.5)});
  near(values_of(simulation, vertex), {2 - arm.y(), 2 + arm.x(), 1 + arm.z()});
  near(values_of(simulation, beside), {50, 1, 0});

  // Three quarters: the cosine of half the angle is negative, and the other quaternion is written.
  for (int i = 0; i < 50; ++i) simulation.step();
  near(values_of(simulation, body), {4, 2, -3, std::sqrt(0.5), 0, 0, -std::sqrt(0.5)});

  for (const Followed& followed : {body, vertex, beside}) {
    const auto cells = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
    CHECK(cells(energy_header(followed)) == cells(energy_row(simulation, {}, followed)));
  }
}
