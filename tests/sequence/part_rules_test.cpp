// The parts that are asked about: names and patterns, and what they mean for vertices.
// SPDX-License-Identifier: MIT
#include "sequence/parts/part_rules.hpp"

#include "sequence/checks.hpp"
#include "sequence/refusal.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::sequence;

namespace {

using Pairs = std::vector<std::array<std::string, 2>>;

/// Four triangles, one a part, and an edge that is in none.
frames::Topology four_parts() {
  frames::Topology topology;
  topology.vertex_count = 14;
  topology.faces = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
  topology.edges = {{12, 13}};
  topology.parts = {"wheel left", "wheel right", "body", "a,b"};
  topology.face_parts = {0, 1, 2, 3};
  topology.first_number = 1;
  return topology;
}

PartRules rules(const PartOptions& options) { return part_rules_of(four_parts(), options, "car.obj"); }

std::string refused(const PartOptions& options) {
  return refusal_of([&] { static_cast<void>(rules(options)); });
}

bool may_collide(const PartOptions& options, MeshIndex vertex, MeshIndex face) {
  return mesh_of(four_parts(), {}, "car.obj", rules(options)).may_collide({Kind::vertex_face, vertex, face});
}

}  // namespace

TEST_CASE("parts are named, by patterns too, and each pair once") {
  CHECK(rules({}).empty());
  CHECK(rules({.ignored = {"body,wheel left"}}).pairs == Pairs{{"wheel left", "body"}});
  CHECK(rules({.ignored = {"wheel*,body", "body,wheel right"}}).pairs ==
        Pairs{{"wheel left", "body"}, {"wheel right", "body"}});
  CHECK(rules({.ignored = {"body,body"}}).pairs == Pairs{{"body", "body"}});
  CHECK(rules({.ignored = {"*,*"}}).pairs.size() == 10);
  CHECK(rules({.ignored = {"wheel [lr]*,body"}}).pairs.size() == 2);
  CHECK(rules({.only_between = {"a,b,body"}}).pairs == Pairs{{"body", "a,b"}});  // a name with a comma
  CHECK(rules({.only_between = {"body,wheel left"}}).rule == GroupRule::only_listed);
  CHECK_FALSE(rules({.between_parts = true}).within);
}

TEST_CASE("what names no two parts is refused, and the message has the parts") {
  const std::string parts = "the parts are wheel left, wheel right, body, a,b";
  for (const char* text : {"body,bodi", ",", "body,", "", "body", "[,body"}) {
    CAPTURE(text);
    const std::string message = refused({.ignored = {text}});
    CHECK(has(message, "car.obj: '" + std::string(text) + "' names no two parts"));
    CHECK(has(message, parts));
  }
  CHECK(has(refused({.ignored = {"*,*,*"}}), "names parts in several ways"));
  frames::Topology nameless = four_parts();
  nameless.parts.clear();
  nameless.face_parts.clear();
  CHECK(has(refusal_of([&] { static_cast<void>(part_rules_of(nameless, {.between_parts = true}, "x.obj")); }),
            "names no parts"));
}

TEST_CASE("the vertices of a part are a group, and what is in no part collides unless only pairs are asked about") {
  CHECK(may_collide({}, 0, 2));
  CHECK_FALSE(may_collide({.ignored = {"wheel*,body"}}, 0, 2));
  CHECK(may_collide({.ignored = {"wheel*,body"}}, 0, 1));
  CHECK(may_collide({.only_between = {"wheel*,body"}}, 0, 2));
  CHECK_FALSE(may_collide({.only_between = {"wheel*,body"}}, 0, 1));
  CHECK(may_collide({.between_parts = true}, 0, 1));
  for (const bool only : {false, true}) {
    const PartOptions options =
        only ? PartOptions{.only_between = {"wheel*,body"}} : PartOptions{.between_parts = true};
    const Mesh mesh = mesh_of(four_parts(), {}, "car.obj", rules(options));
    CHECK(mesh.may_collide({Kind::edge_edge, 0, 1}) == !only);  // the edge comes first
  }
}

TEST_CASE("parts that share a vertex cannot be told apart, and rules that leave nothing are refused") {
  frames::Topology shared = four_parts();
  shared.faces[1][0] = 2;
  const PartRules between = part_rules_of(shared, {.between_parts = true}, "x.obj");
  const std::string message = refusal_of([&] { static_cast<void>(collision_rules(shared, between, "x.obj")); });
  CHECK(has(message, "x.obj: vertex 3 is in the parts wheel left and wheel right"));
  CHECK(collision_rules(shared, {}, "x.obj").groups.empty());

  frames::Topology one = four_parts();
  one.edges.clear();
  CHECK(has(refusal_of([&] {
              static_cast<void>(mesh_of(one, {}, "x.obj", part_rules_of(one, {.ignored = {"*,*"}}, "x.obj")));
            }),
            "no two parts that are left"));
}

TEST_CASE("a verdict names the parts that it leaves out, ten pairs at most") {
  CHECK(left_out_by({}).empty());
  CHECK(left_out_by(rules({.between_parts = true})) == std::vector<std::string>{"pairs within one part were left out"});
  CHECK(left_out_by(rules({.ignored = {"body,wheel*"}})) ==
        std::vector<std::string>{"these parts were not asked about: wheel left and body, wheel right and body"});
  CHECK(left_out_by(rules({.only_between = {"body,wheel left"}})) ==
        std::vector<std::string>{"nothing but these parts was asked about: wheel left and body"});
  PartRules many = rules({.ignored = {"*,*"}});
  many.pairs.push_back({"x", "y"});
  many.pairs.push_back({"y", "z"});
  CHECK(has(left_out_by(many)[0], " and 2 pairs more"));
}
