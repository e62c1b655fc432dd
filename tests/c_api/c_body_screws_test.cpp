// Screws, candidates, intersections and distances of bodies through the C interface.
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
