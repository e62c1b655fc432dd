// A mesh is checked once, and each fault has a message that names the place and what would be right.
// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <string>
#include <typeinfo>

#include <touchstone/touchstone.hpp>

#include "mesh/scenes.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// Two triangles with a common edge, an edge of its own, and a vertex in no edge.
MeshElements sound() {
  MeshElements elements;
  elements.vertex_count = 7;
  elements.faces = {{0, 1, 2}, {2, 1, 3}};
  elements.edges = {{4, 5}, {3, 1}};
  return elements;
}

std::string fault(const MeshElements& elements) {
  try {
    const Mesh mesh(elements);
  } catch (const InvalidMesh& error) {
    return error.what();
  } catch (const InvalidQuery& error) {
    return std::string("query: ") + error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("edges of faces are found, merged with those given, and vertices in no edge are loose points") {
  const Mesh mesh(sound());
  CHECK(mesh.vertex_count() == 7);
  CHECK(mesh.dimension() == 3);
  CHECK(mesh.edges() == std::vector<std::array<MeshIndex, 2>>{{4, 5}, {3, 1}, {0, 1}, {0, 2}, {1, 2}, {2, 3}});
  CHECK(mesh.points() == std::vector<MeshIndex>{6});
  CHECK(mesh.describe({Kind::edge_edge, 0, 3}) == "edge 0 (4-5) and edge 3 (0-2)");
  CHECK(mesh.describe({Kind::vertex_face, 5, 1}) == "vertex 5 and face 1 (2-1-3)");
  CHECK(mesh.describe({Kind::point_edge, 6, 0}) == "vertex 6 and edge 0 (4-5)");
  CHECK(mesh.describe({Kind::point_point, 6, 5}) == "vertex 6 and vertex 5");
  CHECK_THROWS_AS(mesh.describe({Kind::edge_edge, 0, 6}), InvalidMesh);
  CHECK_THROWS_AS(mesh.may_collide({Kind::vertex_face, 7, 0}), InvalidMesh);

  MeshElements listed = sound();
  listed.points.emplace();
  CHECK(Mesh(listed).points().empty());
  CHECK(Mesh().vertex_count() == 0);
  CHECK(first_contact(Mesh(), Positions(), Positions()).free());
}

TEST_CASE("each fault of a mesh is named") {
  CHECK(fault(sound()) == "none");
  MeshElements bad = sound();
  bad.faces[1][0] = 9000;
  CHECK(fault(bad) == "face 1 names vertex 9000, and the mesh has 7 vertices (0 to 6)");
  bad.vertex_count = 0;
  CHECK(fault(bad) == "face 0 names vertex 0, and the mesh has no vertex");
  bad = sound();
  bad.edges[1][1] = 7;
  CHECK(fault(bad) == "edge 1 names vertex 7, and the mesh has 7 vertices (0 to 6)");
  bad = sound();
  bad.faces.push_back({4, 6, 4});
  CHECK(fault(bad) == "face 2 names vertex 4 twice; its corners must be 3 different vertices");
  bad = sound();
  bad.edges.push_back({6, 6});
  CHECK(fault(bad) == "edge 2 names vertex 6 twice; its corners must be 2 different vertices");
  bad = sound();
  bad.faces.push_back({1, 2, 0});
  CHECK(fault(bad) == "face 2 has the same corners as face 0: vertices 0 1 2; each face may be given once");
  bad = sound();
  bad.edges.push_back({5, 4});
  CHECK(fault(bad) == "edge 2 has the same corners as edge 0: vertices 4 5; each edge may be given once");
  bad = sound();
  bad.points = {6, 0};
  CHECK(fault(bad) == "loose point 1 is vertex 0, which is a corner of edge 2; a loose point is in no edge");
  bad.points = {6, 6};
  CHECK(fault(bad) == "loose point 1 is vertex 6 again; each loose point may be given once");
  bad.points = {7};
  CHECK(fault(bad) == "loose point 0 names vertex 7, and the mesh has 7 vertices (0 to 6)");
  bad = sound();
  bad.dimension = 4;
  CHECK(fault(bad) == "the dimension is 4; it must be 2 or 3");
  bad.dimension = 2;
  CHECK(fault(bad) ==
        "a mesh in two dimensions has edges and loose points only, and there are 2 faces; give their edges, or the "
        "dimension 3");
  bad = sound();
  bad.radii = {1, 2};
  CHECK(fault(bad) ==
        "there are 2 radii, and the mesh has 7 vertices (0 to 6); give one radius for each vertex, or none");
  bad.radii.assign(7, 0.5);
  bad.separation.distance = 1;
  CHECK(fault(bad) == "there is both a separation for all pairs and a radius for each vertex; give one of them");
  bad.separation.distance = 0;
  bad.radii[3] = -1;
  CHECK(fault(bad).find("vertex 3 has the radius -1; a radius must be finite, not negative") == 0);
  bad = sound();
  bad.separation.distance = std::numeric_limits<double>::quiet_NaN();
  CHECK(fault(bad).find("query: the separation is nan") == 0);
  bad = sound();
  bad.rules.groups = {1};
  CHECK(
      fault(bad) ==
      "there are 1 groups of vertices, and the mesh has 7 vertices (0 to 6); give one group for each vertex, or none");
  bad = sound();
  bad.rules.group_pairs = {{0, 1}};
  CHECK(fault(bad) == "there are rules about groups, and no vertex has a group; give one group for each vertex");
  bad = sound();
  bad.rules.vertex_pairs = {{0, 1}, {2, 7}};
  CHECK(fault(bad) == "vertex pair 1 of the rules names vertex 7, and the mesh has 7 vertices (0 to 6)");
  bad = sound();
  bad.rules.element_pairs = {{Kind::edge_edge, 0, 6}};
  CHECK(fault(bad) == "element pair 0 of the rules names edge 6, and the mesh has 6 edges (0 to 5)");
  bad.pair_separations = {{{Kind::vertex_face, 3, 0}, 1}, {{Kind::edge_edge, 0, 9}, 1}};
  bad.rules.element_pairs.clear();
  CHECK(fault(bad) == "pair separation 1 names edge 9, and the mesh has 6 edges (0 to 5)");
  bad.pair_separations = {{{Kind::edge_edge, 0, 3}, 1}, {{Kind::edge_edge, 3, 0}, 2}};
  CHECK(fault(bad) == "two pair separations are about one pair, edge-edge 0 and 3; each pair may be given once");
  bad.pair_separations = {{{Kind::edge_edge, 0, 3}, -1}};
  CHECK(fault(bad).find("pair separation 0 is -1; it must be finite, not negative") == 0);
  bad.pair_separations.clear();
  bad.rules.element_pairs = {{static_cast<Kind>(9), 0, 0}};
  CHECK(fault(bad).find("query: the kind is 9") == 0);
}

TEST_CASE("random hostile meshes have an error with a place, or are sound") {
  seeded::Rng random(7);
  const auto hostile_index = [&](std::size_t count) {
    switch (random.between(0, 11)) {
      case 0: return std::numeric_limits<MeshIndex>::max();
      case 1: return static_cast<MeshIndex>(count);
      case 2: return static_cast<MeshIndex>(random.bits());
      default: return static_cast<MeshIndex>(random.below(count + 1));
    }
  };
  int faults = 0, sound_ones = 0;
  for (std::size_t round = 0; round < effort(2000); ++round) {
    MeshElements elements;
    elements.vertex_count = random.below(30);
    if (random.one_in(6)) elements.dimension = random.between(-1, 4);
    const auto few = [&] { return random.one_in(2) ? 0 : random.below(4); };
    const std::size_t faces = few();
    for (std::size_t i = 0; i < faces; ++i) {
      std::array<MeshIndex, 3> face;
      for (MeshIndex& v : face) v = hostile_index(elements.vertex_count);
      elements.faces.push_back(face);
    }
    const std::size_t edges = few();
    for (std::size_t i = 0; i < edges; ++i) {
      std::array<MeshIndex, 2> edge;
      for (MeshIndex& v : edge) v = hostile_index(elements.vertex_count);
      elements.edges.push_back(edge);
    }
    if (random.one_in(4)) elements.points = {{hostile_index(elements.vertex_count), 0}};
    if (random.one_in(6)) elements.radii.assign(random.below(30), random.one_in(2) ? 1e308 : 0.5);
    if (random.one_in(6)) elements.rules.groups.assign(random.below(30), hostile_index(3));
    if (random.one_in(6)) elements.rules.group_rule = static_cast<GroupRule>(random.between(0, 3));
    if (random.one_in(6)) {
      const MeshIndex a = hostile_index(elements.vertex_count);
      const MeshIndex b = hostile_index(elements.vertex_count);
      elements.rules.vertex_pairs.push_back({a, b});
      elements.rules.element_pairs.push_back({static_cast<Kind>(random.between(0, 5)), b, a});
    }
    const std::string message = fault(elements);
    CAPTURE(round, message);
    if (message == "none") {
      ++sound_ones;
      const Mesh mesh(elements);
      std::vector<double> x(mesh.vertex_count() * static_cast<std::size_t>(mesh.dimension()));
      for (double& coordinate : x) coordinate = random.symmetric();
      first_contact(mesh, {x, mesh.dimension()}, {x, mesh.dimension()});
      intersections(mesh, {x, mesh.dimension()});
    } else {
      ++faults;
      REQUIRE(message.size() > 20);
    }
  }
  CHECK(faults > 0);
  CHECK(sound_ones > 0);
}
