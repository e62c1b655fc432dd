// Rules about bodies, and what is refused.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <touchstone/touchstone.hpp>

#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// Three boxes in a row that touch, at rest.
struct Row {
  Bodies bodies;
  std::vector<RigidMotion> motions = std::vector<RigidMotion>(3);
  Row() {
    for (std::size_t i = 0; i < 3; ++i) {
      bodies.bodies.push_back(box(1, 1, 1));
      motions[i].p0 = motions[i].p1 = {2.0 * static_cast<double>(i), 0, 0};
    }
  }
  std::size_t touching() const {  // pairs of bodies
    std::size_t pairs = 0;
    BodyIndex last = 9;
    for (const BodyContact& contact : first_contact(bodies, motions).at_start) {
      const BodyIndex a = std::min(contact.pair.first.body, contact.pair.second.body);
      if (a != last) ++pairs;
      last = a;
    }
    return pairs;
  }
};

template <class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("rules leave pairs of bodies out, and their number is told") {
  Row row;
  CHECK(first_contact(row.bodies, row.motions).excluded == 0);
  CHECK(!first_contact(row.bodies, row.motions).free());
  row.bodies.rules.body_pairs = {{1, 0}, {0, 1}};
  for (const BodyContact& contact : first_contact(row.bodies, row.motions).at_start) {
    CHECK(contact.pair.first.body + contact.pair.second.body == 3);  // 1 and 2
  }
  CHECK(first_contact(row.bodies, row.motions).excluded == 1);
  row.bodies.rules = {};
  row.bodies.rules.groups = {5, 5, 7};
  row.bodies.rules.group_pairs = {{5, 7}};
  FirstBodyContact found = first_contact(row.bodies, row.motions);
  CHECK(found.excluded == 2);
  for (const BodyContact& contact : found.at_start) {
    CHECK(contact.pair.first.body + contact.pair.second.body == 1);  // 0 and 1
  }
  row.bodies.rules.group_rule = GroupRule::only_listed;
  found = first_contact(row.bodies, row.motions);
  CHECK(found.excluded == 1);
  CHECK(!found.at_start.empty());
  row.bodies.rules.body_pairs = {{1, 2}, {0, 2}};
  CHECK(first_contact(row.bodies, row.motions).free());
  CHECK(first_contact(row.bodies, row.motions).excluded == 3);
}

TEST_CASE("what has no meaning for bodies is refused with its place") {
  Row row;
  const auto ask = [&] { return message_of([&] { first_contact(row.bodies, row.motions); }); };
  row.motions.pop_back();
  CHECK(ask() == "2 motions do not fit: there are 3 bodies (0 to 2), and each needs one");
  row.motions.emplace_back();
  row.motions[2].q1 = {0, 0, 0, 0};
  CHECK(ask() == "body 2: the quaternion q1 is zero; an orientation needs a component that is not 0");
  row.motions[2].q1 = {-1, 0, 0, 0};
  CHECK(ask().find("body 2: q1 is q0 times a negative number") == 0);
  row.motions[2].q1 = {1, 0, 0, 0};
  row.motions[1].p1.y = NAN;
  CHECK(ask() == "body 1: the position p1 has y = nan; coordinates must be finite");
  MeshElements edge;
  edge.vertex_count = 2, edge.edges = {{0, 1}};
  CHECK(message_of([&] {
          Body(Mesh(edge), std::vector<Vec3>{{}, {0, INFINITY, 0}});
        }) == "vertex 1 has y = inf; coordinates must be finite");
  CHECK(message_of([&] { Body(Mesh(edge), std::vector<Vec3>{{}}); }) ==
        "the positions, which are those of 1 vertices, do not fit a mesh of 2 vertices");
  row.motions[1].p1.y = 0;
  row.bodies.separation.distance = -1;
  CHECK(ask().find("-1") != std::string::npos);
  row.bodies.separation.distance = 0;
  row.bodies.rules.body_pairs = {{0, 3}};
  CHECK(ask() == "the rules name body 3, and there are 3 bodies (0 to 2)");
  row.bodies.rules.body_pairs = {{1, 1}};
  CHECK(ask().find("a body is never asked about with itself") != std::string::npos);
  row.bodies.rules.body_pairs = {};
  row.bodies.rules.groups = {1};
  CHECK(ask().find("the rules have the groups of 1 bodies") == 0);
  row.bodies.rules.groups = {};
  row.bodies.rules.group_pairs = {{1, 2}};
  CHECK(ask() == "the rules are about pairs of groups, and the bodies have no groups");
  MeshElements plane;
  plane.vertex_count = 2;
  plane.dimension = 2;
  plane.edges = {{0, 1}};
  const std::vector<double> x{0, 0, 1, 1};
  CHECK(message_of([&] { Body(Mesh(plane), Positions(x, 2)); }).find("in the plane") != std::string::npos);
  BodyStepOptions options;
  options.t_max = 0.5;
  row.bodies.rules = {};
  CHECK(message_of([&] { free_step(row.bodies, row.motions, options); }) ==
        "t_max is 0.5; a free step is asked about with 1");
}

TEST_CASE("a pair of bodies' elements is described, and its query has both motions") {
  const Row row;
  const BodyPair pair{Kind::vertex_face, {2, 3}, {0, 5}};
  CHECK(describe(row.bodies, pair) == "vertex 3 of body 2 and face 5 (0-5-1) of body 0");
  const CurvedQuery query = query_of(row.bodies, pair, row.motions);
  CHECK(query.corners[0].motion == 0);
  CHECK(query.corners[3].motion == 1);
  CHECK(query.motions[0].p0.x == 4);
  CHECK(query.motions[1].p0.x == 0);
  CHECK(message_of([&] {
          describe(row.bodies, {Kind::edge_edge, {0, 99}, {1, 0}});
        }) == "the pair names edge 99 of body 0, which has 18 of them");
  CHECK(message_of([&] {
          describe(row.bodies, {Kind::edge_edge, {3, 0}, {1, 0}});
        }) == "the pair names body 3, and there are 3 bodies (0 to 2)");
}

TEST_CASE("no bodies, and bodies without elements, are free") {
  CHECK(first_contact({}, {}).free());
  Bodies bodies;
  bodies.bodies = {Body(), box(1, 1, 1), Body()};
  const std::vector<RigidMotion> motions(3);
  CHECK(first_contact(bodies, motions).free());
  CHECK(free_step(bodies, motions).outcome == StepOutcome::whole);
}
