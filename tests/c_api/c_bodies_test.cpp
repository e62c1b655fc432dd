// Bodies and their steps through the C interface: the answers of the C++ one, and what is wrong as a status and a
// message.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/touchstone.hpp>

#include "c_api/body_twins.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

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
