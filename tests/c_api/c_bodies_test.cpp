// Bodies through the C interface: the answers of the C++ one, and what is wrong as a status and a message.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
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

bool same_pair(const BodyPair& expected, const touchstone_body_pair& found) {
  return expected ==
         BodyPair{static_cast<Kind>(found.kind), {found.first_body, found.first}, {found.second_body, found.second}};
}

bool same_contacts(const std::vector<BodyContact>& expected, touchstone_body_contacts* found) {
  bool all = touchstone_body_contacts_count(found) == expected.size();
  for (std::size_t i = 0; all && i < expected.size(); ++i) {
    touchstone_body_pair pair;
    touchstone_answer answer;
    REQUIRE(touchstone_body_contacts_get(found, i, &pair, &answer) == TOUCHSTONE_OK);
    all = same_pair(expected[i].pair, pair) && same(expected[i].answer, answer);
  }
  CHECK(touchstone_body_contacts_get(found, expected.size(), nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  touchstone_body_contacts_destroy(found);
  return all;
}

bool same_pairs(const std::vector<BodyPair>& expected, touchstone_body_pairs* found) {
  bool all = touchstone_body_pairs_count(found) == expected.size();
  touchstone_body_pair pair;
  for (std::size_t i = 0; all && i < expected.size(); ++i) {
    REQUIRE(touchstone_body_pairs_get(found, i, &pair) == TOUCHSTONE_OK);
    all = same_pair(expected[i], pair);
  }
  CHECK(touchstone_body_pairs_get(found, expected.size(), &pair) == TOUCHSTONE_INVALID_ARGUMENT);
  touchstone_body_pairs_destroy(found);
  return all;
}

bool same_intersections(const std::vector<BodyIntersection>& expected, touchstone_body_intersections* found) {
  bool all = touchstone_body_intersections_count(found) == expected.size();
  touchstone_body_intersection told;
  for (std::size_t i = 0; all && i < expected.size(); ++i) {
    REQUIRE(touchstone_body_intersections_get(found, i, &told) == TOUCHSTONE_OK);
    const BodyIntersection& one = expected[i];
    all = told.first_element == static_cast<int>(one.first_element) &&
          BodyElement{told.first_body, told.first} == one.first &&
          told.second_element == static_cast<int>(one.second_element) &&
          BodyElement{told.second_body, told.second} == one.second && told.sort == static_cast<int>(one.sort);
  }
  CHECK(touchstone_body_intersections_get(found, expected.size(), &told) == TOUCHSTONE_INVALID_ARGUMENT);
  touchstone_body_intersections_destroy(found);
  return all;
}

bool same_screws(const std::vector<BodyScrewContact>& expected, touchstone_body_screws* found) {
  bool all = touchstone_body_screws_count(found) == expected.size();
  for (std::size_t i = 0; all && i < expected.size(); ++i) {
    touchstone_body_pair pair;
    touchstone_screw_answer told;
    REQUIRE(touchstone_body_screws_get(found, i, &pair, &told) == TOUCHSTONE_OK);
    const ScrewAnswer& answer = expected[i].answer;
    all = same_pair(expected[i].pair, pair) && told.verdict == static_cast<int>(answer.verdict) &&
          told.arcs == answer.arcs && told.free_until == answer.free_until && told.contact_by == answer.contact_by &&
          told.deviation == answer.deviation;
  }
  CHECK(touchstone_body_screws_get(found, expected.size(), nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  touchstone_body_screws_destroy(found);
  return all;
}

/// A scene with poses as both interfaces take them, and the twins of its bodies.
struct TwinScene {
  Bodies bodies;
  std::vector<Pose> start, end;
  std::vector<RigidMotion> motions;
  std::size_t turned = 0;  ///< bodies that take the other turn than their signs say
  QuaternionOrder order;
  std::vector<double> from, to;
  Twins twins;

  TwinScene(const RandomBodies& scene, bool xyzw, bool as_given)
      : bodies(without_radii(scene.bodies)),
        order(xyzw ? QuaternionOrder::xyzw : QuaternionOrder::wxyz),
        twins(bodies, xyzw ? TOUCHSTONE_QUATERNION_XYZW : TOUCHSTONE_QUATERNION_WXYZ,
              as_given ? TOUCHSTONE_TURN_AS_GIVEN : TOUCHSTONE_TURN_SHORTER) {
    for (const RigidMotion& motion : scene.motions) {
      start.push_back({motion.q0, motion.p0});
      end.push_back({motion.q1, motion.p1});
      motions.push_back(motion_between(start.back(), end.back(), as_given ? Turn::as_given : Turn::shorter));
      turned += motions.back().q1 == motion.q1 ? 0 : 1;
    }
    from = rows(start, order), to = rows(end, order);
  }

 private:
  static Bodies without_radii(Bodies bodies) {
    for (Body& body : bodies.bodies) {
      MeshElements elements;
      elements.vertex_count = body.mesh().vertex_count();
      elements.faces = body.mesh().faces(), elements.edges = body.mesh().edges();
      body = Body(Mesh(elements), body.points());
    }
    return bodies;
  }
};

/// Edges of a box that makes a quarter turn graze another box, as near as doubles have it.
RandomBodies grazing_boxes() {
  RandomBodies scene;
  scene.bodies.bodies = {box(1, 1, 1), box(1, 1, 1)};
  scene.motions.resize(2);
  scene.motions[0].q1 = {1, 0, 0, 1};
  scene.motions[1].p0.x = scene.motions[1].p1.x = 1 + std::sqrt(2.0);
  return scene;
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
    const TwinScene scene(random_bodies(random), i % 2 == 1, i % 3 == 0);
    const auto& [bodies, start, end, motions, scene_turned, order, from, to, twins] = scene;
    turned += scene_turned;
    BodyStepOptions options;
    options.check_start = i % 4 != 0;
    const FirstBodyContact expected = first_contact(bodies, motions, options);
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
    CHECK(found.turned == scene_turned);
    CHECK(same_contacts(expected.earliest, first));
    CHECK(same_contacts(expected.at_start, at_start));
    REQUIRE(touchstone_bodies_all_contacts(twins.handle, from.data(), to.data(), from.size(), nullptr, &all) ==
            TOUCHSTONE_OK);
    CHECK(same_contacts(all_contacts(bodies, motions), all));
    touchstone_body_pairs* pairs = nullptr;
    REQUIRE(touchstone_bodies_candidates(twins.handle, from.data(), to.data(), from.size(), nullptr, &pairs) ==
            TOUCHSTONE_OK);
    CHECK(same_pairs(candidates(bodies, motions), pairs));
    contacts += expected.contact ? 1 : 0;

    const FreeBodyStep step = free_step(bodies, motions, options);
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

TEST_CASE("screws, intersections and distances of bodies answer in C as those of C++") {
  seeded::Rng random(4142);
  std::array<std::size_t, 3> verdicts{};
  std::size_t intersecting = 0, apart = 0, turned = 0;
  for (std::size_t i = 0; i < effort(60); ++i) {
    const TwinScene scene(i == 0 ? grazing_boxes() : random_bodies(random), i % 2 == 1, i % 3 == 0);
    const auto& [bodies, start, end, motions, scene_turned, order, from, to, twins] = scene;
    CAPTURE(i);
    touchstone_options asked = default_options();
    BodyScrewOptions options;
    options.check_start = i % 4 != 0, options.arcs = 4, options.most_arcs = i % 5 == 0 ? 4 : 32;
    options.t_max = i % 2 == 0 ? 1 : random.uniform(0, 1);
    asked.check_start = options.check_start ? 1 : 0;
    asked.arcs = options.arcs, asked.most_arcs = options.most_arcs, asked.t_max = options.t_max;
    std::vector<RigidMotion> curved = motions;
    std::vector<double> inner;
    for (RigidMotion& motion : curved) {
      motion.control_points = 2 + static_cast<int>(i % 3);
      for (int k = 2; k < motion.control_points; ++k) {
        const Vec3 x = motion.inner[static_cast<std::size_t>(k - 2)] = some_point(random, random.one_in(2), 3);
        inner.insert(inner.end(), {x.x, x.y, x.z});
      }
    }
    const BodyScrewAnswer screw = solve_screw(bodies, curved, options);
    touchstone_body_screw_answer told = TOUCHSTONE_BODY_SCREW_ANSWER_INIT;
    touchstone_body_screws* open = nullptr;
    REQUIRE(touchstone_bodies_solve_screw(twins.handle, from.data(), to.data(), from.size(),
                                          inner.empty() ? nullptr : inner.data(), inner.size(), &asked, &told,
                                          &open) == TOUCHSTONE_OK);
    CHECK(told.verdict == static_cast<int>(screw.verdict));
    CHECK(told.free == (screw.free() ? 1 : 0));
    CHECK(told.free_until == screw.free_until);
    CHECK(told.contact_by == screw.contact_by);
    CHECK(told.start_intersections == screw.start_intersections.size());
    CHECK(told.start_checked == (screw.start_checked ? 1 : 0));
    CHECK(told.excluded == screw.excluded);
    CHECK(told.in_open == screw.in_open);
    CHECK(told.cancelled == screw.cancelled);
    CHECK(told.turned == scene_turned);
    CHECK(same_screws(screw.pairs, open));

    touchstone_body_intersections *where = nullptr, *where_again = nullptr;
    REQUIRE(touchstone_bodies_intersections(twins.handle, from.data(), from.size(), nullptr, &where) == TOUCHSTONE_OK);
    CHECK(same_intersections(intersections(bodies, start), where));
    const BodyDistance least = distance(bodies, start);
    touchstone_body_distance near = TOUCHSTONE_BODY_DISTANCE_INIT;
    touchstone_body_contacts* nearest = nullptr;
    REQUIRE(touchstone_bodies_distance(twins.handle, from.data(), from.size(), nullptr, &near, &nearest,
                                       &where_again) == TOUCHSTONE_OK);
    CHECK(near.distance == least.distance);
    CHECK(near.intersections == least.intersections.size());
    CHECK(near.in_open == least.in_open);
    CHECK(near.cancelled == least.cancelled);
    CHECK(near.excluded == least.excluded);
    CHECK(same_contacts(least.pairs, nearest));
    CHECK(same_intersections(least.intersections, where_again));
    ++verdicts[static_cast<std::size_t>(screw.verdict)];
    intersecting += least.intersections.empty() ? 0 : 1;
    apart += least.distance > 0 ? 1 : 0;
    turned += scene_turned;
  }
  if (!whole_effort("that each answer comes")) return;
  CHECK(verdicts[0] > 0);
  CHECK(verdicts[1] > 0);
  CHECK(verdicts[2] > 0);
  CHECK(intersecting > 0);
  CHECK(apart > 0);
  CHECK(turned > 0);
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

TEST_CASE("what is wrong with screws, candidates, intersections and distances of bodies is a status, and no list") {
  TwoBoxes boxes;
  const Twins twins(boxes.of);
  constexpr std::size_t kTooMany = static_cast<std::size_t>(-1) / sizeof(double) / 7 * 7 + 7;  // bytes overflow
  touchstone_body_screw_answer screw = TOUCHSTONE_BODY_SCREW_ANSWER_INIT;
  touchstone_body_distance near = TOUCHSTONE_BODY_DISTANCE_INIT;
  touchstone_options options = default_options();
  // Each function with poses at the start, and what an unset list would be.
  touchstone_body_screws* const no_screws = reinterpret_cast<touchstone_body_screws*>(&screw);
  touchstone_body_pairs* const no_pairs = reinterpret_cast<touchstone_body_pairs*>(&screw);
  touchstone_body_intersections* const no_places = reinterpret_cast<touchstone_body_intersections*>(&screw);
  touchstone_body_contacts* const no_contacts = reinterpret_cast<touchstone_body_contacts*>(&screw);
  const std::vector<std::function<int(const touchstone_bodies*, const double*, std::size_t)>> functions = {
      [&](const touchstone_bodies* of, const double* start, std::size_t count) {
        touchstone_body_screws* list = no_screws;
        const int status =
            touchstone_bodies_solve_screw(of, start, boxes.end.data(), count, nullptr, 0, &options, &screw, &list);
        CHECK((list == nullptr) == (status != TOUCHSTONE_OK));
        touchstone_body_screws_destroy(list);
        return status;
      },
      [&](const touchstone_bodies* of, const double* start, std::size_t count) {
        touchstone_body_pairs* list = no_pairs;
        const int status = touchstone_bodies_candidates(of, start, boxes.end.data(), count, &options, &list);
        CHECK((list == nullptr) == (status != TOUCHSTONE_OK));
        touchstone_body_pairs_destroy(list);
        return status;
      },
      [&](const touchstone_bodies* of, const double* start, std::size_t count) {
        touchstone_body_intersections* list = no_places;
        const int status = touchstone_bodies_intersections(of, start, count, &options, &list);
        CHECK((list == nullptr) == (status != TOUCHSTONE_OK));
        touchstone_body_intersections_destroy(list);
        return status;
      },
      [&](const touchstone_bodies* of, const double* start, std::size_t count) {
        touchstone_body_contacts* list = no_contacts;
        touchstone_body_intersections* places = no_places;
        const int status = touchstone_bodies_distance(of, start, count, &options, &near, &list, &places);
        CHECK((list == nullptr) == (status != TOUCHSTONE_OK));
        CHECK((places == nullptr) == (status != TOUCHSTONE_OK));
        touchstone_body_contacts_destroy(list);
        touchstone_body_intersections_destroy(places);
        return status;
      }};
  for (std::size_t f = 0; f < functions.size(); ++f) {
    CAPTURE(f);
    const auto ask = [&](const std::vector<double>& start) {
      return functions[f](twins.handle, start.data(), start.size());
    };
    CHECK(ask(boxes.start) == TOUCHSTONE_OK);
    CHECK(functions[f](nullptr, boxes.start.data(), 14) == TOUCHSTONE_INVALID_ARGUMENT);
    CHECK(functions[f](twins.handle, nullptr, 14) == TOUCHSTONE_INVALID_ARGUMENT);
    for (const std::size_t count : {std::size_t{0}, std::size_t{7}, std::size_t{13}, std::size_t{21}, kTooMany}) {
      CHECK(functions[f](twins.handle, boxes.start.data(), count) == TOUCHSTONE_INVALID_ARGUMENT);
    }
    std::vector<double> wrong = boxes.start;
    wrong[10] = 0;  // w of body 1
    CHECK(ask(wrong) == TOUCHSTONE_INVALID_QUERY);
    CHECK(message_has("body 1"));
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      for (const std::size_t at : {std::size_t{8}, std::size_t{12}}) {
        wrong = boxes.start;
        wrong[at] = value;
        CHECK(ask(wrong) == TOUCHSTONE_INVALID_QUERY);
      }
    }
    const auto with = [&](const std::function<void(touchstone_options&)>& change) {
      change(options);
      const int status = ask(boxes.start);
      options = default_options();
      return status;
    };
    CHECK(with([](touchstone_options& o) { o.separation = 1; }) == TOUCHSTONE_INVALID_ARGUMENT);
    CHECK(with([](touchstone_options& o) { o.threads = -1; }) == TOUCHSTONE_INVALID_QUERY);
    const bool is_screw = f == 0;
    CHECK((with([](touchstone_options& o) { o.arcs = 16; }) == TOUCHSTONE_OK) == is_screw);
    CHECK((with([](touchstone_options& o) { o.most_arcs = 16; }) == TOUCHSTONE_OK) == is_screw);
    CHECK((with([](touchstone_options& o) { o.t_max = 0.5; }) == TOUCHSTONE_OK) == is_screw);
    CHECK((with([](touchstone_options& o) { o.check_start = 1; }) == TOUCHSTONE_OK) == is_screw);
    const int no_power = is_screw ? TOUCHSTONE_INVALID_QUERY : TOUCHSTONE_INVALID_ARGUMENT;
    CHECK(with([](touchstone_options& o) { o.arcs = 3; }) == no_power);
    CHECK(with([](touchstone_options& o) { o.arcs = -8; }) == no_power);
    CHECK(with([](touchstone_options& o) { o.arcs = o.most_arcs = 0; }) == TOUCHSTONE_OK);  // the defaults
    // A program that was compiled before has no arcs.
    CHECK(with([](touchstone_options& o) {
            o.size = offsetof(touchstone_options, arcs);
            o.arcs = o.most_arcs = -1;
          }) == TOUCHSTONE_OK);
  }
  const double *start = boxes.start.data(), *end = boxes.end.data();
  screw.size -= 8, near.size += 8;
  CHECK(functions[0](twins.handle, start, 14) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(functions[3](twins.handle, start, 14) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_bodies_solve_screw(twins.handle, start, end, 14, nullptr, 0, nullptr, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  screw.size += 8;
  std::vector<double> inner(14, 0.5);
  touchstone_options few = default_options();
  few.arcs = few.most_arcs = 4;
  const auto on_curves = [&](const double* points, std::size_t count) {
    return touchstone_bodies_solve_screw(twins.handle, start, end, 14, points, count, &few, &screw, nullptr);
  };
  CHECK(on_curves(inner.data(), 6) == TOUCHSTONE_OK);
  CHECK(on_curves(inner.data(), 12) == TOUCHSTONE_OK);
  for (const std::size_t count : {1, 3, 5, 7, 9, 13, 14}) {
    CHECK(on_curves(inner.data(), count) == TOUCHSTONE_INVALID_ARGUMENT);
  }
  CHECK(on_curves(nullptr, 6) == TOUCHSTONE_INVALID_ARGUMENT);
  inner[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(on_curves(inner.data(), 6) == TOUCHSTONE_INVALID_QUERY);
  CHECK(touchstone_bodies_candidates(twins.handle, start, end, 14, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_bodies_candidates(twins.handle, start, nullptr, 14, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_bodies_intersections(twins.handle, start, 14, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_bodies_distance(twins.handle, start, 14, nullptr, nullptr, nullptr, nullptr) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_body_screws_get(nullptr, 0, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_body_pairs_get(nullptr, 0, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_body_intersections_get(nullptr, 0, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_body_screws_count(nullptr) + touchstone_body_pairs_count(nullptr) +
            touchstone_body_intersections_count(nullptr) ==
        0);
  touchstone_body_screws_destroy(nullptr);
  touchstone_body_pairs_destroy(nullptr);
  touchstone_body_intersections_destroy(nullptr);
}
