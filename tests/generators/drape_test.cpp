// The scene `drape` is free of contact at every speed, and a planted crossing is found in its two steps and no other.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <touchstone/mesh.hpp>

#include "generators/step.hpp"
#include "generators/vectors.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::generators;

namespace {

touchstone::Mesh mesh_of(const Step& step) {
  MeshElements elements;
  elements.vertex_count = step.mesh().corner_count;
  elements.faces = step.mesh().faces;
  return touchstone::Mesh(elements);
}

FirstContact contact_of(const Step& step) {
  return first_contact(mesh_of(step), Positions(step.start()), Positions(step.end()));
}

/// The vertices of the cloth come first.
Index cloth_vertices(const Step& step) {
  REQUIRE(step.mesh().objects.size() == 2);
  const auto& faces = step.mesh().faces;
  const std::size_t sphere = step.mesh().objects[1].first_face;
  Index least = faces[sphere][0];
  for (std::size_t f = sphere; f < faces.size(); ++f) least = std::min({least, faces[f][0], faces[f][1], faces[f][2]});
  return least;
}

}  // namespace

TEST_CASE("a drape is free of contact in every step, at rest and at every speed") {
  const double speed = GENERATE(0.0, 1.0, 7.0, 1000.0);
  const std::size_t edges = GENERATE(100u, 300u, 1500u, 6000u);
  std::size_t near = 0;
  const std::size_t seeds = tests::effort(edges < 1000 ? 12 : edges < 2000 ? 4 : 1);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Step step(SceneName::drape, seed, edges, speed);
    const Index cloth = cloth_vertices(step);
    for (int i = 1; i <= 4; ++i) {
      step.advance();
      CAPTURE(speed, edges, seed, i);
      REQUIRE(contact_of(step).free());
      REQUIRE(intersections(mesh_of(step), Positions(step.end())).empty());
      step.for_each_candidate(Kind::vertex_face, false, [&](Index vertex, Index face) {
        near += (vertex < cloth) != (step.mesh().faces[face][0] < cloth) ? 1 : 0;
      });
    }
  }
  if (edges > 1000) CHECK(near > 0);  // or the cloth is so far away that nothing is shown
}

TEST_CASE("a planted crossing is found in its two steps, by the vertex that was named") {
  const double speed = GENERATE(0.0, 1.0, 20.0);
  const std::size_t edges = GENERATE(100u, 700u, 3000u);
  const std::size_t seeds = tests::effort(edges < 1000 ? 12 : 3);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Step step(SceneName::drape, seed, edges, speed);
    std::optional<Index> planted;
    for (int i = 1; i <= 5; ++i) {
      step.advance();
      CAPTURE(speed, edges, seed, i);
      if (i == 3) {
        const std::vector<Vec3> before = step.end();
        planted = step.plant_crossing();
        REQUIRE(planted.has_value());
        for (Index v = 0; v < before.size(); ++v) {
          REQUIRE((length(step.end()[v] - before[v]) == 0) == (v != *planted));
        }
        REQUIRE_FALSE(intersections(mesh_of(step), Positions(step.end())).empty());
      } else {
        REQUIRE(intersections(mesh_of(step), Positions(step.end())).empty());
      }
      const FirstContact found = contact_of(step);
      REQUIRE(found.free() == (i != 3 && i != 4));
      if (found.free()) continue;
      REQUIRE(found.at_start.empty());
      const touchstone::Mesh mesh = mesh_of(step);
      for (const MeshContact& contact : all_contacts(mesh, Positions(step.start()), Positions(step.end()))) {
        const auto corners = mesh.corners(contact.pair);
        REQUIRE(std::count(corners.begin(), corners.end(), *planted) == 1);
      }
      if (edges < 500) continue;  // in a coarse scene, an edge of the vertex may be the first
      REQUIRE(found.earliest.size() == 1);
      REQUIRE(found.earliest[0].pair.kind == Kind::vertex_face);
      REQUIRE(found.earliest[0].pair.first == *planted);
      REQUIRE(found.earliest[0].pair.second >= step.mesh().objects[1].first_face);
    }
  }
}

TEST_CASE("only a drape has a crossing to plant") {
  for (const SceneName name : kScenes) {
    Step step(name, 1, 200, 1);
    step.advance();
    const std::vector<Vec3> before = step.end();
    CHECK_FALSE(step.plant_crossing().has_value());
    for (Index v = 0; v < before.size(); ++v) CHECK(length(step.end()[v] - before[v]) == 0);
  }
}
