// Meshes that are mended: vertices at one position, and elements that are none.
// SPDX-License-Identifier: MIT
#include "sequence/repairs.hpp"

#include <cmath>

#include "sequence/checks.hpp"
#include "sequence/element_names.hpp"
#include "sequence/refusal.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::sequence;

namespace {

/// Two triangles with corners of their own, which meet in the vertices 1 and 3, and 2 and 5; and an edge along them.
frames::Frame split_square() {
  auto topology = std::make_shared<frames::Topology>();
  topology->vertex_count = 6;
  topology->faces = {{0, 1, 2}, {3, 4, 5}};
  topology->edges = {{3, 5}};
  topology->first_number = 1;
  frames::Frame frame;
  frame.topology = topology;
  frame.positions = {0, 0, 0, 1, 0, -0.0, 0, 1, 0, 1, 0, 0, 1, 1, 0, -0.0, 1, 0};
  return frame;
}

frames::Frame mended(const RepairOptions& options, frames::Frame frame) {
  Repairs repairs(options, false);
  repairs.mend(frame, {"a.obj"});
  return frame;
}

MeshFacts facts(const frames::Frame& frame) { return facts_of(mesh_of(*frame.topology, {}, "a.obj"), *frame.topology); }

}  // namespace

TEST_CASE("welded elements name the first vertex at a position, and numbers stay") {
  const frames::Frame frame = mended({.weld = true}, split_square());
  CHECK(frame.topology->faces == std::vector<std::array<MeshIndex, 3>>{{0, 1, 2}, {1, 4, 2}});
  CHECK(frame.topology->edges == std::vector<std::array<MeshIndex, 2>>{{1, 2}});
  CHECK(frame.topology->vertex_count == 6);
  CHECK(facts(frame).welded == 2);
  CHECK(facts(frame).idle == 0);
  CHECK(facts(frame).edges == 5);
  CHECK(*mended({}, split_square()).topology == *split_square().topology);
}

TEST_CASE("vertices of two parts at one position stay two, but where the mesh is one part") {
  frames::Frame frame = split_square();
  auto topology = *frame.topology;
  topology.edges.clear();
  topology.parts = {"a", "b"};
  topology.face_parts = {0, 1};
  frame.topology = std::make_shared<const frames::Topology>(topology);
  CHECK(*mended({.weld = true}, frame).topology == topology);
  CHECK(mended({.weld = true, .is_one_part = true}, frame).topology->welded_vertices == 2);
  topology.face_parts = {1, 1};
  frame.topology = std::make_shared<const frames::Topology>(topology);
  CHECK(mended({.weld = true}, frame).topology->welded_vertices == 2);
  // An edge that is in no face is in no part.
  topology.edges = {{3, 5}};
  topology.faces = {{0, 1, 2}};
  topology.face_parts = {0};
  frame.topology = std::make_shared<const frames::Topology>(topology);
  CHECK(mended({.weld = true}, frame).topology->welded_vertices == 0);
}

TEST_CASE("frames share the welds of the first one, and vertices that come apart are named") {
  Repairs repairs({.weld = true}, false);
  frames::Frame first = split_square(), second = split_square(), apart = split_square();
  second.positions[3] = second.positions[9] = 2;  // both vertices move
  apart.positions[9] = std::nextafter(1.0, 2.0);
  repairs.mend(first, {"f-1.obj"});
  repairs.mend(second, {"f-2.obj"});
  CHECK(second.topology == first.topology);
  const std::string message = refusal_of([&] { repairs.mend(apart, {"f-3.obj"}); });
  CHECK(has(message, "f-3.obj: vertices 2 and 4 are apart in f-3.obj, and at one position in f-1.obj"));
  Repairs each({.weld = true}, true);
  each.mend(first = split_square(), {"f-1.obj"});
  each.mend(apart, {"f-3.obj"});
  CHECK(apart.topology->welded_vertices == 1);
}

TEST_CASE("what names a vertex twice, or the vertices of another element, is left out and counted") {
  frames::Frame frame = split_square();
  auto topology = *frame.topology;
  topology.faces = {{0, 1, 1}, {0, 1, 2}, {2, 0, 1}, {3, 4, 5}};
  topology.edges = {{3, 5}, {5, 3}, {4, 4}, {0, 4}};
  topology.parts = {"a", "b"};
  topology.face_parts = {0, 0, 1, 1};
  frame.topology = std::make_shared<const frames::Topology>(topology);
  CHECK(has(refusal_of([&] { static_cast<void>(facts(frame)); }), "--drop-degenerate leaves such elements out"));
  const frames::Frame kept = mended({.drop_degenerate = true}, frame);
  CHECK(kept.topology->faces == std::vector<std::array<MeshIndex, 3>>{{0, 1, 2}, {3, 4, 5}});
  CHECK(kept.topology->face_numbers == std::vector<MeshIndex>{2, 4});
  CHECK(kept.topology->face_parts == std::vector<std::uint32_t>{0, 1});
  CHECK(kept.topology->edges == std::vector<std::array<MeshIndex, 2>>{{3, 5}, {0, 4}});
  CHECK(facts(kept).dropped == 4);
  // Sound ones keep the numbers that they have by themselves.
  CHECK(mended({.drop_degenerate = true}, split_square()).topology->face_numbers.empty());
  // Both: a sliver whose corners are at two positions.
  frame.positions = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  topology = *split_square().topology;
  topology.edges.clear();
  frame.topology = std::make_shared<const frames::Topology>(topology);
  CHECK(has(refusal_of([&] { static_cast<void>(facts(mended({.weld = true}, frame))); }), "names vertex 2 twice"));
  CHECK(facts(mended({.weld = true, .drop_degenerate = true}, frame)).faces == 1);
}

TEST_CASE("elements with vertices that are not there are refused, mended or not") {
  frames::Frame frame = split_square();
  auto topology = *frame.topology;
  topology.faces[0][0] = 77;
  frame.topology = std::make_shared<const frames::Topology>(topology);
  CHECK(has(refusal_of([&] { static_cast<void>(facts(mended({.weld = true, .drop_degenerate = true}, frame))); }),
            "there are only 6"));
}
