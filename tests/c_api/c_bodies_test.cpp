// Bodies through the C interface: the answers of the C++ one, and what is wrong as a status and a message.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/touchstone.hpp>

#include "c_api/c_api_support.hpp"
#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Indices = std::vector<std::uint32_t>;

template <std::size_t N>
Indices flat(const std::vector<std::array<std::uint32_t, N>>& rows) {
  Indices all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

touchstone_body* c_body(const Body& body) {
  const Mesh& mesh = body.mesh();
  const Indices faces = flat(mesh.faces()), edges = flat(mesh.edges());
  touchstone_mesh_elements elements = TOUCHSTONE_MESH_ELEMENTS_INIT;
  elements.vertex_count = mesh.vertex_count();
  elements.faces = faces.data(), elements.face_count = mesh.faces().size();
  elements.edges = edges.data(), elements.edge_count = mesh.edges().size();
  std::vector<double> points;
  for (const Vec3& p : body.points()) points.insert(points.end(), {p.x, p.y, p.z});
  touchstone_mesh* handle = nullptr;
  touchstone_body* made = nullptr;
  REQUIRE(touchstone_mesh_create(&elements, &handle) == TOUCHSTONE_OK);
  REQUIRE(touchstone_body_create(handle, points.data(), points.size(), &made) == TOUCHSTONE_OK);
  touchstone_mesh_destroy(handle);
  return made;
}

/// Rows of x y z and the quaternion.
std::vector<double> rows(const std::vector<Pose>& poses, QuaternionOrder order) {
  std::vector<double> all;
  for (const auto& [q, p] : poses) {
    all.insert(all.end(), {p.x, p.y, p.z});
    if (order == QuaternionOrder::wxyz) all.insert(all.end(), q.begin(), q.end());
    if (order == QuaternionOrder::xyzw) all.insert(all.end(), {q[1], q[2], q[3], q[0]});
  }
  return all;
}

touchstone_bodies_elements elements_of_none() { return TOUCHSTONE_BODIES_ELEMENTS_INIT; }

/// Bodies of C++ and their twins.
struct Twins {
  std::vector<touchstone_body*> bodies;
  Indices excluded;
  touchstone_bodies_elements elements = elements_of_none();
  touchstone_bodies* handle = nullptr;

  explicit Twins(const Bodies& of, int quaternion = TOUCHSTONE_QUATERNION_WXYZ, int turn = TOUCHSTONE_TURN_SHORTER)
      : excluded(flat(of.rules.body_pairs)) {
    for (const Body& body : of.bodies) bodies.push_back(c_body(body));
    elements.bodies = bodies.data(), elements.body_count = bodies.size();
    elements.separation = of.separation.distance;
    elements.metric = of.separation.metric == Metric::max ? TOUCHSTONE_METRIC_MAX : TOUCHSTONE_METRIC_EUCLIDEAN;
    elements.quaternion = quaternion;
    elements.turn = turn;
    elements.excluded_bodies = excluded.data(), elements.excluded_body_count = of.rules.body_pairs.size();
    REQUIRE(touchstone_bodies_create(&elements, &handle) == TOUCHSTONE_OK);
  }
  ~Twins() {
    touchstone_bodies_destroy(handle);
    for (touchstone_body* body : bodies) touchstone_body_destroy(body);
  }
  Twins(const Twins&) = delete;
  Twins& operator=(const Twins&) = delete;
};

bool same_contacts(const std::vector<BodyContact>& expected, touchstone_body_contacts* found) {
  bool all = touchstone_body_contacts_count(found) == expected.size();
  for (std::size_t i = 0; all && i < expected.size(); ++i) {
    touchstone_body_pair pair;
    touchstone_answer answer;
    REQUIRE(touchstone_body_contacts_get(found, i, &pair, &answer) == TOUCHSTONE_OK);
    const BodyPair told{static_cast<Kind>(pair.kind), {pair.first_body, pair.first}, {pair.second_body, pair.second}};
    all = told == expected[i].pair && same(expected[i].answer, answer);
  }
  touchstone_body_contacts_destroy(found);
  return all;
}

/// Two boxes, of which the first moves a little beside the second.
struct TwoBoxes {
  Bodies of;
  std::vector<double> start = {0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 1, 0, 0, 0};
  std::vector<double> end = {0.5, 0, 0, 1, 0, 0, 0, 3, 0, 0, 1, 0, 0, 0};
  TwoBoxes() { of.bodies = {box(1, 1, 1), box(1, 1, 1)}; }
};

}  // namespace

TEST_CASE("bodies answer in C as those of C++") {
  seeded::Rng random(4141);
  std::size_t turned = 0, contacts = 0;
  for (std::size_t i = 0; i < effort(60); ++i) {
    RandomBodies scene = random_bodies(random);
    const bool xyzw = i % 2 == 1, as_given = i % 3 == 0;
    const QuaternionOrder order = xyzw ? QuaternionOrder::xyzw : QuaternionOrder::wxyz;
    for (Body& body : scene.bodies.bodies) {  // without radii
      MeshElements elements;
      elements.vertex_count = body.mesh().vertex_count();
      elements.faces = body.mesh().faces(), elements.edges = body.mesh().edges();
      body = Body(Mesh(elements), body.points());
    }
    std::vector<Pose> start, end;
    std::vector<RigidMotion> motions;
    for (const RigidMotion& motion : scene.motions) {
      start.push_back({motion.q0, motion.p0});
      end.push_back({motion.q1, motion.p1});
      motions.push_back(motion_between(start.back(), end.back(), as_given ? Turn::as_given : Turn::shorter));
      turned += motions.back().q1 == motion.q1 ? 0 : 1;
    }
    const std::vector<double> from = rows(start, order), to = rows(end, order);
    const Twins twins(scene.bodies, xyzw ? TOUCHSTONE_QUATERNION_XYZW : TOUCHSTONE_QUATERNION_WXYZ,
                      as_given ? TOUCHSTONE_TURN_AS_GIVEN : TOUCHSTONE_TURN_SHORTER);
    BodyStepOptions options;
    options.check_start = i % 4 != 0;
    const FirstBodyContact expected = first_contact(scene.bodies, motions, options);
    touchstone_options asked = default_options();
    asked.check_start = options.check_start ? 1 : 0;
    touchstone_first_body_contact found = TOUCHSTONE_FIRST_BODY_CONTACT_INIT;
    touchstone_body_contacts *first = nullptr, *at_start = nullptr, *all = nullptr;
    CAPTURE(i);
    REQUIRE(touchstone_bodies_first_contact(twins.handle, from.data(), to.data(), from.size(), &asked, &found, &first,
                                            &at_start) == TOUCHSTONE_OK);
    CHECK(found.contact == (expected.contact ? 1 : 0));
    CHECK(found.free == (expected.free() ? 1 : 0));
    CHECK(found.toi == expected.toi);
    CHECK(found.toi_upper == expected.toi_upper);
    CHECK(found.start_checked == (options.check_start ? 1 : 0));
    CHECK(found.start_intersections == expected.start_intersections.size());
    CHECK(found.in_open == expected.in_open);
    CHECK(found.cancelled == expected.cancelled);
    CHECK(found.excluded == expected.excluded);
    CHECK(same_contacts(expected.earliest, first));
    CHECK(same_contacts(expected.at_start, at_start));
    REQUIRE(touchstone_bodies_all_contacts(twins.handle, from.data(), to.data(), from.size(), nullptr, &all) ==
            TOUCHSTONE_OK);
    CHECK(same_contacts(all_contacts(scene.bodies, motions), all));
    contacts += expected.contact ? 1 : 0;

    const FreeBodyStep step = free_step(scene.bodies, motions, options);
    std::vector<double> poses = from;
    double length = -1;
    int outcome = -1;
    REQUIRE(touchstone_bodies_free_step(twins.handle, poses.data(), to.data(), from.size(), &asked, poses.data(),
                                        &length, &outcome, &found) == TOUCHSTONE_OK);
    CHECK(poses == rows(step.poses, order));
    CHECK(length == step.length);
    CHECK(outcome == static_cast<int>(step.outcome));
    CHECK(found.toi == expected.toi);
  }
  if (!whole_effort("that bodies meet and that turns are changed")) return;
  CHECK(turned > 0);
  CHECK(contacts > 0);
}

TEST_CASE("a body inside another is free in C unless the start is asked about, and turns are counted") {
  TwoBoxes boxes;
  boxes.of.bodies[1] = box(4, 4, 4);
  boxes.start[7] = boxes.end[7] = 0;
  boxes.end[3] = -1;  // the same orientation
  const Twins twins(boxes.of);
  touchstone_first_body_contact found = TOUCHSTONE_FIRST_BODY_CONTACT_INIT;
  touchstone_options options = default_options();
  const auto ask = [&] {
    REQUIRE(touchstone_bodies_first_contact(twins.handle, boxes.start.data(), boxes.end.data(), 14, &options, &found,
                                            nullptr, nullptr) == TOUCHSTONE_OK);
  };
  ask();
  CHECK(found.free == 1);
  CHECK(found.turned == 1);
  options.check_start = 1;
  ask();
  CHECK(found.free == 0);
  CHECK(found.contact == 0);
  CHECK(found.start_intersections > 0);
}

TEST_CASE("groups and pairs of bodies that never collide arrive") {
  TwoBoxes boxes;
  boxes.end[0] = 3;
  Twins twins(boxes.of);
  const auto ask = [&] {
    touchstone_bodies_destroy(twins.handle);
    touchstone_first_body_contact found = TOUCHSTONE_FIRST_BODY_CONTACT_INIT;
    REQUIRE(touchstone_bodies_create(&twins.elements, &twins.handle) == TOUCHSTONE_OK);
    REQUIRE(touchstone_bodies_first_contact(twins.handle, boxes.start.data(), boxes.end.data(), 14, nullptr, &found,
                                            nullptr, nullptr) == TOUCHSTONE_OK);
    CHECK(found.excluded == (found.contact == 1 ? 0 : 1));
    return found.contact;
  };
  CHECK(ask() == 1);
  const Indices bodies = {1, 0}, groups = {5, 7}, pair = {7, 5};
  twins.elements.excluded_bodies = bodies.data(), twins.elements.excluded_body_count = 1;
  CHECK(ask() == 0);
  twins.elements.excluded_body_count = 0;
  twins.elements.groups = groups.data(), twins.elements.group_count = 2;
  twins.elements.group_pairs = pair.data(), twins.elements.group_pair_count = 1;
  CHECK(ask() == 0);
  twins.elements.only_listed_groups = 1;
  CHECK(ask() == 1);
}

TEST_CASE("what is wrong with bodies is a status and a message, and no handle") {
  TwoBoxes boxes;
  Twins twins(boxes.of);
  touchstone_bodies* made = twins.handle;
  const auto create = [&](const std::function<void(touchstone_bodies_elements&)>& change) {
    touchstone_bodies_elements elements = twins.elements;
    change(elements);
    made = twins.handle;
    const int status = touchstone_bodies_create(&elements, &made);
    CHECK(made == nullptr);
    return status;
  };
  CHECK(create([](auto& e) { e.quaternion = 0; }) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("TOUCHSTONE_QUATERNION_WXYZ (1) or TOUCHSTONE_QUATERNION_XYZW (2)"));
  CHECK(create([](auto& e) { e.quaternion = 3; }) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(create([](auto& e) { e.turn = 2; }) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("turn is 2"));
  CHECK(create([](auto& e) { e.metric = 2; }) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(create([](auto& e) { e.only_listed_groups = 2; }) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(create([](auto& e) { e.bodies = nullptr; }) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(create([](auto& e) { e.size = 0; }) == TOUCHSTONE_INVALID_ARGUMENT);
  const touchstone_body* const none[2] = {twins.bodies[0], nullptr};
  CHECK(create([&](auto& e) { e.bodies = none; }) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("bodies[1] is a null pointer"));
  CHECK(touchstone_bodies_create(nullptr, &made) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_bodies_create(&twins.elements, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);

  touchstone_first_body_contact found = TOUCHSTONE_FIRST_BODY_CONTACT_INIT;
  touchstone_body_contacts* list = reinterpret_cast<touchstone_body_contacts*>(&found);
  const auto first = [&](const double* start, std::size_t count) {
    return touchstone_bodies_first_contact(twins.handle, start, boxes.end.data(), count, nullptr, &found, &list,
                                           nullptr);
  };
  CHECK(first(nullptr, 14) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(list == nullptr);
  CHECK(first(boxes.start.data(), 13) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("the poses have 13 values, and there are 2 bodies with 7 values each"));
  found.size = 8;
  CHECK(first(boxes.start.data(), 14) == TOUCHSTONE_INVALID_ARGUMENT);
  found = TOUCHSTONE_FIRST_BODY_CONTACT_INIT;
  boxes.start[10] = 0;  // w
  CHECK(first(boxes.start.data(), 14) == TOUCHSTONE_INVALID_QUERY);
  CHECK(message_has("body 1"));
  boxes.start[10] = std::nan("");
  CHECK(first(boxes.start.data(), 14) == TOUCHSTONE_INVALID_QUERY);
  boxes.start[10] = 1;
  std::vector<double> poses(14);
  CHECK(touchstone_bodies_free_step(twins.handle, boxes.start.data(), boxes.end.data(), 14, nullptr, nullptr, nullptr,
                                    nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_bodies_all_contacts(twins.handle, boxes.start.data(), boxes.end.data(), 14, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_body_contacts_get(nullptr, 0, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_body_contacts_count(nullptr) == 0);
  touchstone_body_contacts_destroy(nullptr);
  touchstone_bodies_destroy(nullptr);
  touchstone_body_destroy(nullptr);
  const Indices wrong = {0, 2};
  twins.elements.excluded_bodies = wrong.data(), twins.elements.excluded_body_count = 1;
  touchstone_bodies_destroy(twins.handle);
  REQUIRE(touchstone_bodies_create(&twins.elements, &twins.handle) == TOUCHSTONE_OK);
  CHECK(first(boxes.start.data(), 14) == TOUCHSTONE_INVALID_QUERY);
  CHECK(message_has("the rules name body 2"));

  touchstone_mesh_elements flat_elements = TOUCHSTONE_MESH_ELEMENTS_INIT;
  flat_elements.dimension = 2, flat_elements.vertex_count = 1;
  touchstone_mesh* mesh = nullptr;
  touchstone_body* body = twins.bodies[0];
  REQUIRE(touchstone_mesh_create(&flat_elements, &mesh) == TOUCHSTONE_OK);
  CHECK(touchstone_body_create(mesh, poses.data(), 2, &body) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(body == nullptr);
  CHECK(touchstone_body_create(mesh, poses.data(), 3, &body) == TOUCHSTONE_INVALID_MESH);
  CHECK(touchstone_body_create(nullptr, poses.data(), 3, &body) == TOUCHSTONE_INVALID_ARGUMENT);
  touchstone_mesh_destroy(mesh);
}
