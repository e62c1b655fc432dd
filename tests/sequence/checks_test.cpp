// The check of a step, in the numbers and names of its file, against all pairs by `solve`; errors about elements.
// SPDX-License-Identifier: MIT
#include "sequence/checks.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "mesh/coinciding.hpp"
#include "seeded/rng.hpp"
#include "sequence/element_names.hpp"
#include "sequence/refusal.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sequence;
using frames::Frame;
using frames::Topology;
using seeded::Rng;
using touchstone::tests::has;
using touchstone::tests::refusal_of;

namespace {

/// Separate triangles with three vertices each, in two parts, whose numbers in the file begin at 1 and skip the odd
/// ones.
std::shared_ptr<Topology> triangles(std::size_t count) {
  auto topology = std::make_shared<Topology>();
  topology->vertex_count = 3 * count;
  topology->first_number = 1;
  topology->parts = {"left", "right"};
  for (MeshIndex f = 0; f < count; ++f) {
    topology->faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    topology->face_numbers.push_back(2 * f + 10);
    topology->face_parts.push_back(f % 2);
  }
  return topology;
}

Frame random_frame(const std::shared_ptr<Topology>& topology, Rng& rng, double size) {
  Frame frame;
  frame.topology = topology;
  for (std::size_t i = 0; i < 3 * topology->vertex_count; ++i) frame.positions.push_back(rng.uniform(-size, size));
  return frame;
}

Vec3 corner(const Frame& frame, std::size_t v) {
  return {frame.positions[3 * v], frame.positions[3 * v + 1], frame.positions[3 * v + 2]};
}

/// The least toi of all pairs of two triangles, by `solve` of each of their edges and corners.
double first_by_solve(const Frame& before, const Frame& after, bool& starts) {
  const std::size_t count = before.topology->faces.size();
  double toi = std::numeric_limits<double>::infinity();
  const auto ask = [&](Kind kind, const std::array<std::size_t, 4>& corners) {
    Query query;
    query.kind = kind;
    for (std::size_t c = 0; c < 4; ++c) {
      query.start[c] = corner(before, corners[c]);
      query.end[c] = corner(after, corners[c]);
    }
    const Answer answer = solve(query);
    starts = starts || answer.starts_within;
    if (answer.contact) toi = std::min(toi, answer.toi);
  };
  for (std::size_t f = 0; f < count; ++f) {
    for (std::size_t g = 0; g < count; ++g) {
      if (f == g) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        ask(Kind::vertex_face, {3 * f + i, 3 * g, 3 * g + 1, 3 * g + 2});
        for (std::size_t j = 0; j < 3; ++j) {
          ask(Kind::edge_edge, {3 * f + i, 3 * f + (i + 1) % 3, 3 * g + j, 3 * g + (j + 1) % 3});
        }
      }
    }
  }
  return toi;
}

}  // namespace

TEST_CASE("a step has the first contact of all pairs, and its pairs are queries with that time") {
  Rng rng(20260113);
  int with_contact = 0, without = 0;
  for (int round = 0; round < 60; ++round) {
    const auto topology = triangles(4);
    const Mesh mesh = mesh_of(*topology, {}, "x.obj");
    const Frame before = random_frame(topology, rng, 1);
    Frame after = before;
    const double speed = round % 2 == 0 ? 0.02 : 0.5;
    for (double& x : after.positions) x += rng.uniform(-speed, speed);
    bool starts = false;
    const double toi = first_by_solve(before, after, starts);
    const Result result = check_step(mesh, before, after, 7, {});
    REQUIRE_FALSE(starts);  // random triangles do not touch
    CHECK(result.step);
    CHECK(result.frame == 7);
    CHECK(result.toi == toi);
    CHECK(result.free() == (toi > 1));
    for (const PairContact& pair : result.first) {
      CHECK(solve(query_of(pair, before, after)).toi == toi);
      for (const NamedElement* element : {&pair.first, &pair.second}) {
        for (std::size_t i = 0; i < element->corner_count(); ++i) {
          const std::uint64_t face = (element->vertices[i] - 1) / 3;
          CHECK(element->part == (face % 2 == 0 ? "left" : "right"));
          if (element->element == MeshElement::face) CHECK(element->face == 2 * face + 10);
        }
      }
    }
    (result.free() ? without : with_contact) += 1;
  }
  CHECK(with_contact >= 10);
  CHECK(without >= 10);
}

TEST_CASE("elements that make no mesh are named by the numbers of the file") {
  Topology topology = *triangles(3);
  const auto refused = [&] { return refusal_of([&] { static_cast<void>(mesh_of(topology, {}, "a/x.obj")); }); };
  CHECK(refused().empty());
  topology.faces[1] = {3, 4, 3};
  CHECK(refused() ==
        "a/x.obj: face 12 names vertex 4 twice; its corners must be 3 different vertices (mesh "
        "--drop-degenerate leaves such elements out)");
  topology.faces[1] = {3, 4, 9};
  CHECK(refused() == "a/x.obj: face 12 names vertex 10, and there are only 9");
  topology.faces[1] = {2, 0, 1};
  CHECK(refused() ==
        "a/x.obj: face 12 has the same corners as face 10, vertices 1 2 3; each face may be given once (mesh "
        "--drop-degenerate leaves the others out)");
  topology = *triangles(3);
  topology.edges = {{0, 4}, {4, 0}};
  CHECK(has(refused(), "a/x.obj: edge 5 1 has the same corners as edge 1 5, vertices 1 5"));
  topology.edges = {{4, 4}};
  CHECK(has(refused(), "names vertex 5 twice"));
}

TEST_CASE("points of the file that are corners of elements are not loose, and vertices in no element do not collide") {
  Topology topology = *triangles(1);
  topology.vertex_count = 6;
  topology.points = {4, 1, 4};
  CHECK(mesh_of(topology, {}, "x").points() == std::vector<MeshIndex>{4});
  topology.points = {};
  CHECK(mesh_of(topology, {}, "x").points().empty());
  topology = Topology();
  topology.vertex_count = 3;
  CHECK(mesh_of(topology, {}, "x").points().size() == 3);
}

TEST_CASE("two frames with other elements are refused with both names and the first difference") {
  const Topology one = *triangles(3);
  Topology two = one;
  const FrameName first{"d/c-1.obj", 0, false}, second{"d/c-2.obj", 0, false};
  const auto refused = [&] { return refusal_of([&] { check_same_elements(one, first, two, second); }); };
  const std::string start = "d/c-2.obj: c-2.obj differs from c-1.obj: ";
  CHECK(refused().empty());
  two.parts = {"other", "names"};  // names may change
  CHECK(refused().empty());
  two.vertex_count = 10;
  CHECK(refused().rfind(start + "10 vertices, not 9;", 0) == 0);
  two = one;
  two.faces.pop_back();
  CHECK(refused().rfind(start + "2 faces, not 3;", 0) == 0);
  two = one;
  std::swap(two.faces[1][0], two.faces[1][1]);
  CHECK(refused().rfind(start + "face 12 has the vertices 5 4 6, not 4 5 6;", 0) == 0);
  two = one;
  two.points = {3};
  CHECK(refused().rfind(start + "1 points, not 0;", 0) == 0);
  two = one;
  two.dimension = 2;
  CHECK(refused().rfind(start + "2 coordinates a vertex, not 3;", 0) == 0);
}

TEST_CASE("a coordinate that is not finite is named") {
  const auto topology = triangles(2);
  Frame frame;
  frame.topology = topology;
  frame.positions.assign(18, 0);
  frame.positions[3 * 4 + 1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal_of([&] {
          check_positions(frame, {"x.obj", 0, false});
        }) == "x.obj: vertex 5 has y = nan; coordinates must be finite");
  CHECK(has(refusal_of([&] { check_positions(frame, {"x.npy", 3, true}); }), "x.npy: in frame 3, vertex 5"));
}

namespace {

template <std::size_t N, std::size_t M>
bool share(const std::array<MeshIndex, N>& a, const std::array<MeshIndex, M>& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// How many pairs of the kinds of a step share a vertex, by all pairs.
std::size_t sharing_pairs(const Mesh& mesh) {
  std::size_t count = 0;
  const bool in_space = mesh.dimension() == 3;
  for (MeshIndex v = 0; v < mesh.vertex_count(); ++v) {
    for (const auto& face : mesh.faces()) count += share(std::array{v}, face) ? 1 : 0;
    for (const auto& edge : mesh.edges()) count += !in_space && share(std::array{v}, edge) ? 1 : 0;
  }
  for (std::size_t i = 0; in_space && i < mesh.edges().size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) count += share(mesh.edges()[i], mesh.edges()[j]) ? 1 : 0;
  }
  return count;
}

/// Whether any pair may collide.
bool any_may_collide(const Mesh& mesh) {
  const std::size_t counts[3] = {mesh.vertex_count(), mesh.edges().size(), mesh.faces().size()};
  const auto any = [&](Kind kind, std::size_t first, std::size_t second) {
    for (MeshIndex i = 0; i < counts[first]; ++i) {
      for (MeshIndex j = 0; j < counts[second]; ++j) {
        if (mesh.may_collide({kind, i, j})) return true;
      }
    }
    return false;
  };
  return any(Kind::edge_edge, 1, 1) || any(Kind::vertex_face, 0, 2) || any(Kind::point_edge, 0, 1) ||
         any(Kind::point_point, 0, 0);
}

}  // namespace

TEST_CASE("what a mesh leaves out is counted as by all pairs of elements") {
  Rng rng(20260118);
  int without_pairs = 0, with_idle = 0;
  for (int round = 0; round < 400; ++round) {
    Topology topology;
    topology.dimension = rng.one_in(3) ? 2 : 3;
    topology.vertex_count = 1 + rng.below(6);
    const auto vertex = [&] { return static_cast<MeshIndex>(rng.below(topology.vertex_count)); };
    const std::size_t faces = topology.dimension == 3 ? rng.below(3) : 0, edges = rng.below(3), points = rng.below(3);
    for (std::size_t i = 0; i < faces; ++i) {
      const MeshIndex a = vertex(), b = vertex(), c = vertex();
      if (a != b && b != c && c != a) topology.faces.push_back({a, b, c});
    }
    for (std::size_t i = 0; i < edges; ++i) {
      const MeshIndex a = vertex(), b = vertex();
      if (a != b) topology.edges.push_back({a, b});
    }
    for (std::size_t i = 0; i < points; ++i) topology.points.push_back(vertex());
    Mesh mesh;
    if (!refusal_of([&] { mesh = mesh_of(topology, {}, "x"); }).empty()) continue;  // an element that is there twice
    const MeshFacts facts = facts_of(mesh, topology);
    CAPTURE(round, facts.vertices, facts.edges, facts.faces, facts.points, facts.idle);
    CHECK(facts.neighbours == sharing_pairs(mesh));
    CHECK(facts.has_pairs() == any_may_collide(mesh));
    without_pairs += facts.has_pairs() ? 0 : 1;
    with_idle += facts.idle > 0 ? 1 : 0;
  }
  CHECK(without_pairs >= 20);
  CHECK(with_idle >= 20);
}

TEST_CASE("vertices at equal positions are counted exactly, and only those that collide") {
  Topology topology = *triangles(2);
  topology.vertex_count = 8;
  const Mesh mesh = mesh_of(topology, {}, "x");
  const double least = std::numeric_limits<double>::denorm_min();
  std::vector<double> x = {0, 0, 0, 1, 0, 0, 0, 1, 0, -0.0, 0, -0.0, 1, least, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0};
  CHECK(coinciding_vertices(mesh, {x, 3}) == 4);  // 0 and 3, 2 and 5; not 1 and 4, and not 6 and 7
  x[3 * 4 + 1] = -0.0;
  CHECK(coinciding_vertices(mesh, {x, 3}) == 6);
  for (std::size_t v = 0; v < 8; ++v) x[3 * v] = static_cast<double>(v);
  CHECK(coinciding_vertices(mesh, {x, 3}) == 0);
}

TEST_CASE("the digest of a mesh is that of its elements alone") {
  const Topology one = *triangles(3);
  const auto digest = [](const Topology& topology) { return facts_of(mesh_of(topology, {}, "x"), topology).digest; };
  Topology two = one;
  two.parts = {"a", "b"};
  CHECK(digest(two) == digest(one));
  std::swap(two.faces[0], two.faces[1]);
  CHECK(digest(two) != digest(one));
  two = one;
  two.vertex_count = 10;
  two.points = {9};
  CHECK(digest(two) != digest(one));
}
