// Contacts of meshes of a few elements: verdicts that hang on one double, exact times, and input that is refused.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/touchstone.hpp>

#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("a vertex moved by one unit in its last place changes the verdict") {
  Scene scene;
  scene.elements.vertex_count = 4;
  scene.elements.faces = {{0, 1, 2}};
  // The vertex falls from z = 1 to the face's plane, whose least double above it is out of reach.
  scene.x0 = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1};
  scene.x1 = scene.x0;
  scene.x1[11] = 0;
  const Mesh mesh(scene.elements);
  const FirstContact touching = first_contact(mesh, scene.start(), scene.end());
  CHECK(touching.contact);
  CHECK(touching.toi == 1);
  REQUIRE(touching.earliest.size() == 1);
  CHECK(touching.earliest[0].pair == MeshPair{Kind::vertex_face, 3, 0});
  scene.x1[11] = std::numeric_limits<double>::denorm_min();
  CHECK(first_contact(mesh, scene.start(), scene.end()).free());

  // Beside the face's border x = 0, and on it.
  scene.x1[11] = -1;
  scene.x0[9] = scene.x1[9] = 0;
  CHECK(first_contact(mesh, scene.start(), scene.end()).contact);
  scene.x0[9] = scene.x1[9] = -std::numeric_limits<double>::denorm_min();
  CHECK(first_contact(mesh, scene.start(), scene.end()).free());

  // A separation of one half: the vertex stops there, or one double above.
  scene.x0[9] = scene.x1[9] = 0.25;
  scene.x1[11] = 0.5;
  scene.elements.separation.distance = 0.5;
  CHECK(first_contact(Mesh(scene.elements), scene.start(), scene.end()).contact);
  scene.x1[11] = std::nextafter(0.5, 1);
  CHECK(first_contact(Mesh(scene.elements), scene.start(), scene.end()).free());
}

TEST_CASE("two points exactly as far apart as their separation are in contact, however it is rounded") {
  seeded::Rng random(106);
  std::size_t missed = 0, phantom = 0, rounded = 0;
  for (std::size_t round = 0; round < effort(3000); ++round) {
    MeshElements elements;
    elements.vertex_count = 2;
    elements.separation.metric = random.one_in(2) ? Metric::max : Metric::euclidean;
    const int exponent = random.one_in(4) ? -1070 : random.between(-40, 40);
    for (int i = 0; i < 2; ++i) elements.radii.push_back(std::ldexp(random.unit(), exponent + random.between(0, 3)));
    const Mesh mesh(elements);
    const double distance = mesh.separation({Kind::point_point, 0, 1}).distance;
    rounded += distance != elements.radii[0] + elements.radii[1] ? 1 : 0;
    std::vector<double> x(6, 0.0);
    const auto axis = static_cast<std::size_t>(random.below(3));
    x[3 + axis] = distance;
    missed += first_contact(mesh, {x, 3}, {x, 3}).at_start.size() == 1 ? 0 : 1;
    x[3 + axis] = std::nextafter(distance, INFINITY);
    phantom += first_contact(mesh, {x, 3}, {x, 3}).free() ? 0 : 1;

    // The same with one separation for all.
    MeshElements same = elements;
    same.radii.clear();
    same.separation.distance = distance;
    phantom += first_contact(Mesh(same), {x, 3}, {x, 3}).free() ? 0 : 1;
    x[3 + axis] = distance;
    missed += first_contact(Mesh(same), {x, 3}, {x, 3}).at_start.size() == 1 ? 0 : 1;
  }
  CHECK(missed == 0);
  CHECK(phantom == 0);
  CHECK((rounded > 0 || !whole_effort("that a sum of radii is rounded up")));
}

TEST_CASE("times that no double tells apart are compared exactly") {
  // Two points fly at two faces. At first both meet them at 1/3; then the second meets its face later, by less than a
  // double's spacing.
  Scene scene;
  scene.elements.vertex_count = 8;
  scene.elements.faces = {{0, 1, 2}, {3, 4, 5}};
  scene.x0 = {0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0, 0.25, 0.25, 1, 5.25, 0.25, 1};
  scene.x1 = scene.x0;
  scene.x1[20] = scene.x1[23] = -2;  // both at 1/3
  FirstContact both = first_contact(Mesh(scene.elements), scene.start(), scene.end());
  CHECK(both.earliest.size() == 2);
  CHECK(both.toi < both.toi_upper);
  CHECK(both.toi == 1.0 / 3);
  // 2^52 / (3 2^52 - 1) is later than 1/3 by about 2^-55.2. Doubles there are 2^-54 apart, and 1/3 lies a third of that
  // above a double.
  scene.x0[20] = scene.x0[23] = 0x1p52;
  scene.x1[20] = -0x1p53;
  scene.x1[23] = -0x1p53 + 1;  // later
  const FirstContact one = first_contact(Mesh(scene.elements), scene.start(), scene.end());
  const auto parts = parts_of(scene.elements);
  const MeshPair earlier{Kind::vertex_face, 6, 0}, later{Kind::vertex_face, 7, 1};
  const Answer a = solve(query_between(scene, parts, earlier, scene.x0, scene.x1));
  const Answer b = solve(query_between(scene, parts, later, scene.x0, scene.x1));
  REQUIRE(a.toi == b.toi);  // or the case shows nothing
  REQUIRE(a.toi_upper == b.toi_upper);
  REQUIRE(one.earliest.size() == 1);
  CHECK(one.earliest[0].pair == earlier);
}

TEST_CASE("a coordinate that is not finite is named, and positions that do not fit are refused") {
  Scene scene;
  scene.elements.vertex_count = 3;
  scene.elements.faces = {{0, 1, 2}};
  scene.x0 = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  scene.x1 = scene.x0;
  const Mesh mesh(scene.elements);
  const auto message = [&] {
    try {
      first_contact(mesh, scene.start(), scene.end());
    } catch (const InvalidQuery& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  CHECK(message() == "no error");
  scene.x1[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK(message() == "vertex 2 has y = nan at t = 1; coordinates must be finite");
  scene.x0[3] = -std::numeric_limits<double>::infinity();
  CHECK(message() == "vertex 1 has x = -inf at t = 0; coordinates must be finite");
  scene.x0.push_back(0);
  CHECK(message().find("those of 4 vertices, do not fit a mesh of 3 vertices") != std::string::npos);
  CHECK_THROWS_AS(first_contact(mesh, {scene.x1, 2}, {scene.x1, 2}), InvalidQuery);
  CHECK_THROWS_AS(first_contact(mesh, {nullptr, 3}, {nullptr, 3}), InvalidQuery);
  scene.x1[7] = 1;
  FirstContactOptions options;
  options.threads = 1025;
  CHECK_THROWS_AS(first_contact(mesh, scene.end(), scene.end(), options), InvalidQuery);
  options.threads = 1;
  options.t_max = 1.5;
  CHECK_THROWS_AS(all_contacts(mesh, scene.end(), scene.end(), options), InvalidQuery);
}
