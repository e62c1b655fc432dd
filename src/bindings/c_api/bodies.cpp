// Bodies by the C interface. Poses are rows of 7 doubles.
// SPDX-License-Identifier: MIT
#include <touchstone/bodies.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/curved.hpp>

#include "c_api/answers.hpp"
#include "c_api/guard.hpp"
#include "c_api/handles.hpp"

struct touchstone_body {
  touchstone::Body body;
};

struct touchstone_bodies {
  touchstone::Bodies all;
  touchstone::QuaternionOrder order;
  touchstone::Turn turn;
};

struct touchstone_body_contacts {
  std::vector<touchstone::BodyContact> all;
};

struct touchstone_body_pairs {
  std::vector<touchstone::BodyPair> all;
};

struct touchstone_body_intersections {
  std::vector<touchstone::BodyIntersection> all;
};

struct touchstone_body_screws {
  std::vector<touchstone::BodyScrewContact> all;
};

namespace touchstone::c_api {

namespace {

constexpr std::size_t kPoseValues = 7;

static_assert(TOUCHSTONE_SCREW_FREE == static_cast<int>(ScrewVerdict::free));
static_assert(TOUCHSTONE_SCREW_CONTACT == static_cast<int>(ScrewVerdict::contact));
static_assert(TOUCHSTONE_SCREW_WITHIN_BOUND == static_cast<int>(ScrewVerdict::within_bound));

QuaternionOrder order_of(int quaternion) {
  switch (quaternion) {
    case TOUCHSTONE_QUATERNION_WXYZ: return QuaternionOrder::wxyz;
    case TOUCHSTONE_QUATERNION_XYZW: return QuaternionOrder::xyzw;
    default:
      throw InvalidArgument("quaternion is " + std::to_string(quaternion) +
                            "; it must be TOUCHSTONE_QUATERNION_WXYZ (1) or TOUCHSTONE_QUATERNION_XYZW (2)");
  }
}

touchstone_bodies bodies_of(const touchstone_bodies_elements& given) {
  touchstone_bodies made{{}, order_of(given.quaternion), flag(given.turn, "turn") ? Turn::as_given : Turn::shorter};
  array(given.bodies, given.body_count, 1, "bodies");
  for (std::size_t i = 0; i < given.body_count; ++i) {
    made.all.bodies.push_back(required(given.bodies[i], ("bodies[" + std::to_string(i) + "]").c_str()).body);
  }
  made.all.separation = {given.separation, metric_of(given.metric)};
  BodyRules& rules = made.all.rules;
  rules.body_pairs = indices<2>(given.excluded_bodies, given.excluded_body_count, "excluded_bodies");
  rules.groups = values(given.groups, given.group_count, "groups");
  rules.group_pairs = indices<2>(given.group_pairs, given.group_pair_count, "group_pairs");
  rules.group_rule = group_rule_of(given.only_listed_groups);
  return made;
}

/// The motions between two poses of each body.
struct Motions {
  std::vector<RigidMotion> all;
  std::size_t turned = 0;  ///< as in touchstone_first_body_contact
};

std::vector<Pose> poses_of(const touchstone_bodies& bodies, const double* values, std::size_t value_count,
                           const char* name) {
  array(values, value_count, 1, name);
  const std::size_t count = bodies.all.bodies.size();
  if (value_count % kPoseValues != 0 || value_count / kPoseValues != count) {
    throw InvalidArgument("the poses have " + std::to_string(value_count) + " values, and there are " +
                          std::to_string(count) + " bodies with " + std::to_string(kPoseValues) + " values each");
  }
  std::vector<Pose> poses;
  for (const double* at = values; poses.size() < count; at += kPoseValues) {
    poses.push_back(pose_of({at[0], at[1], at[2]}, {at[3], at[4], at[5], at[6]}, bodies.order));
  }
  return poses;
}

Motions motions_of(const touchstone_bodies& bodies, const double* start, const double* end, std::size_t value_count) {
  const std::vector<Pose> from = poses_of(bodies, start, value_count, "start");
  const std::vector<Pose> to = poses_of(bodies, end, value_count, "end");
  Motions motions;
  for (std::size_t i = 0; i < from.size(); ++i) {
    motions.all.push_back(motion_between(from[i], to[i], bodies.turn));
    motions.turned += motions.all.back().q1 == to[i].orientation ? 0 : 1;
  }
  return motions;
}

/// Puts the origins on Bezier curves. @param inner  the control points between both positions; none: straight
void bend(std::vector<RigidMotion>& motions, const double* inner, std::size_t count) {
  if (count == 0) return;
  const std::size_t points = motions.empty() ? 0 : count / 3 / motions.size();
  if (points < 1 || points > 2 || points * 3 * motions.size() != count) {
    throw InvalidArgument("inner has " + std::to_string(count) + " values; of " + std::to_string(motions.size()) +
                          " bodies it must have 0, or 3 or 6 for each");
  }
  array(inner, count, 1, "inner");
  for (RigidMotion& motion : motions) {
    motion.control_points = static_cast<int>(points) + 2;
    for (std::size_t i = 0; i < points; ++i, inner += 3) motion.inner[i] = {inner[0], inner[1], inner[2]};
  }
}

void write_poses(const touchstone_bodies& bodies, const std::vector<Pose>& poses, double* to) {
  for (const Pose& pose : poses) {
    const auto& [w, x, y, z] = pose.orientation;
    const std::array<double, 4> last = {x, y, z, w};
    const std::array<double, 4>& quaternion = bodies.order == QuaternionOrder::wxyz ? pose.orientation : last;
    const Vec3& p = pose.position;
    to = std::copy(quaternion.begin(), quaternion.end(), std::copy_n(std::array{p.x, p.y, p.z}.begin(), 3, to));
  }
}

/// Those of a step and of screws, which have more of them.
BodyScrewOptions body_options_of(const touchstone_options& options) {
  BodyScrewOptions asked;
  asked.threads = options.threads;
  asked.t_max = options.t_max;
  asked.check_start = flag(options.check_start, "check_start");
  asked.arcs = options.arcs;
  asked.most_arcs = options.most_arcs;
  return asked;
}

touchstone_body_pair c_pair(const BodyPair& pair) {
  return {static_cast<int>(pair.kind), pair.first.body, pair.first.element, pair.second.body, pair.second.element};
}

touchstone_first_body_contact c_first_contact(const FirstBodyContact& found, std::size_t turned) {
  return {sizeof(touchstone_first_body_contact),
          found.contact ? 1 : 0,
          found.free() ? 1 : 0,
          found.toi,
          found.toi_upper,
          found.start_intersections.size(),
          found.start_checked ? 1 : 0,
          0,
          found.in_open,
          found.cancelled,
          found.excluded,
          turned};
}

}  // namespace

}  // namespace touchstone::c_api

using namespace touchstone;
using namespace touchstone::c_api;

extern "C" {

int touchstone_body_create(const touchstone_mesh* mesh, const double* points, std::size_t value_count,
                           touchstone_body** body) {
  clear(body);
  return guarded([&] {
    required(body, "body");
    const Mesh& of = required(mesh, "mesh").mesh;
    array(points, value_count, 1, "points");
    if (value_count != 3 * of.vertex_count()) {
      throw InvalidArgument("points has " + std::to_string(value_count) + " values, and the mesh has " +
                            std::to_string(of.vertex_count()) + " vertices with 3 coordinates each");
    }
    *body = new touchstone_body{Body(of, {points, of.vertex_count(), 3})};
  });
}

void touchstone_body_destroy(touchstone_body* body) { delete body; }

int touchstone_bodies_create(const touchstone_bodies_elements* elements, touchstone_bodies** bodies) {
  clear(bodies);
  return guarded([&] {
    required(bodies, "bodies");
    const touchstone_bodies_elements defaults = TOUCHSTONE_BODIES_ELEMENTS_INIT;
    *bodies =
        new touchstone_bodies(bodies_of(grown(required(elements, "elements"), defaults, sizeof defaults, "elements")));
  });
}

void touchstone_bodies_destroy(touchstone_bodies* bodies) { delete bodies; }

int touchstone_bodies_first_contact(const touchstone_bodies* bodies, const double* start, const double* end,
                                    std::size_t value_count, const touchstone_options* given,
                                    touchstone_first_body_contact* result, touchstone_body_contacts** first,
                                    touchstone_body_contacts** at_start) {
  clear(first);
  clear(at_start);
  return guarded([&] {
    const touchstone_bodies& of = required(bodies, "bodies");
    const touchstone_options options = options_of(given, kHasTMax | kHasCheckStart);
    check_size(required(result, "result"), "result");
    const Motions motions = motions_of(of, start, end, value_count);
    FirstBodyContact contact = first_contact(of.all, motions.all, body_options_of(options));
    const touchstone_first_body_contact told = c_first_contact(contact, motions.turned);
    hand_over(contact.earliest, first, contact.at_start, at_start);
    *result = told;
  });
}

int touchstone_bodies_all_contacts(const touchstone_bodies* bodies, const double* start, const double* end,
                                   std::size_t value_count, const touchstone_options* given,
                                   touchstone_body_contacts** contacts) {
  clear(contacts);
  return guarded([&] {
    const touchstone_bodies& of = required(bodies, "bodies");
    const touchstone_options options = options_of(given, kHasTMax);
    required(contacts, "contacts");
    *contacts = new touchstone_body_contacts{
        all_contacts(of.all, motions_of(of, start, end, value_count).all, body_options_of(options))};
  });
}

int touchstone_bodies_free_step(const touchstone_bodies* bodies, const double* start, const double* end,
                                std::size_t value_count, const touchstone_options* given, double* poses, double* length,
                                int* outcome, touchstone_first_body_contact* contact) {
  return guarded([&] {
    const touchstone_bodies& of = required(bodies, "bodies");
    const touchstone_options options = options_of(given, kHasCheckStart);
    array(poses, value_count, 1, "poses");
    if (contact != nullptr) check_size(*contact, "contact");
    const Motions motions = motions_of(of, start, end, value_count);
    const FreeBodyStep step = free_step(of.all, motions.all, body_options_of(options));
    write_poses(of, step.poses, poses);
    if (length != nullptr) *length = step.length;
    if (outcome != nullptr) *outcome = static_cast<int>(step.outcome);
    if (contact != nullptr) *contact = c_first_contact(step.first_contact, motions.turned);
  });
}

std::size_t touchstone_body_contacts_count(const touchstone_body_contacts* contacts) { return count_of(contacts); }

int touchstone_body_contacts_get(const touchstone_body_contacts* contacts, std::size_t index,
                                 touchstone_body_pair* pair, touchstone_answer* answer) {
  return guarded([&] {
    const BodyContact& one = item_of(contacts, index, "contacts");
    if (pair != nullptr) *pair = c_pair(one.pair);
    if (answer != nullptr) *answer = c_answer(one.answer);
  });
}

void touchstone_body_contacts_destroy(touchstone_body_contacts* contacts) { delete contacts; }

int touchstone_bodies_candidates(const touchstone_bodies* bodies, const double* start, const double* end,
                                 std::size_t value_count, const touchstone_options* given,
                                 touchstone_body_pairs** pairs) {
  clear(pairs);
  return guarded([&] {
    const touchstone_bodies& of = required(bodies, "bodies");
    const touchstone_options options = options_of(given, 0);
    required(pairs, "pairs");
    *pairs = new touchstone_body_pairs{
        candidates(of.all, motions_of(of, start, end, value_count).all, body_options_of(options))};
  });
}

std::size_t touchstone_body_pairs_count(const touchstone_body_pairs* pairs) { return count_of(pairs); }

int touchstone_body_pairs_get(const touchstone_body_pairs* pairs, std::size_t index, touchstone_body_pair* pair) {
  return guarded([&] { required(pair, "pair") = c_pair(item_of(pairs, index, "pairs")); });
}

void touchstone_body_pairs_destroy(touchstone_body_pairs* pairs) { delete pairs; }

int touchstone_bodies_intersections(const touchstone_bodies* bodies, const double* poses, std::size_t value_count,
                                    const touchstone_options* given, touchstone_body_intersections** found) {
  clear(found);
  return guarded([&] {
    const touchstone_bodies& of = required(bodies, "bodies");
    const touchstone_options options = options_of(given, 0);
    required(found, "intersections");
    *found = new touchstone_body_intersections{
        intersections(of.all, poses_of(of, poses, value_count, "poses"), body_options_of(options))};
  });
}

std::size_t touchstone_body_intersections_count(const touchstone_body_intersections* found) { return count_of(found); }

int touchstone_body_intersections_get(const touchstone_body_intersections* found, std::size_t index,
                                      touchstone_body_intersection* intersection) {
  return guarded([&] {
    const BodyIntersection& one = item_of(found, index, "intersections");
    required(intersection, "intersection") = {static_cast<int>(one.first_element),
                                              one.first.body,
                                              one.first.element,
                                              static_cast<int>(one.second_element),
                                              one.second.body,
                                              one.second.element,
                                              static_cast<int>(one.sort)};
  });
}

void touchstone_body_intersections_destroy(touchstone_body_intersections* found) { delete found; }

int touchstone_bodies_distance(const touchstone_bodies* bodies, const double* poses, std::size_t value_count,
                               const touchstone_options* given, touchstone_body_distance* result,
                               touchstone_body_contacts** nearest, touchstone_body_intersections** found) {
  clear(nearest);
  clear(found);
  return guarded([&] {
    const touchstone_bodies& of = required(bodies, "bodies");
    const touchstone_options options = options_of(given, 0);
    check_size(required(result, "result"), "result");
    BodyDistance least = distance(of.all, poses_of(of, poses, value_count, "poses"), body_options_of(options));
    const touchstone_body_distance told = {sizeof told,   least.distance,  least.intersections.size(),
                                           least.in_open, least.cancelled, least.excluded};
    hand_over(least.pairs, nearest, least.intersections, found);
    *result = told;
  });
}

int touchstone_bodies_solve_screw(const touchstone_bodies* bodies, const double* start, const double* end,
                                  std::size_t value_count, const double* inner, std::size_t inner_count,
                                  const touchstone_options* given, touchstone_body_screw_answer* result,
                                  touchstone_body_screws** open) {
  clear(open);
  return guarded([&] {
    const touchstone_bodies& of = required(bodies, "bodies");
    const touchstone_options options = options_of(given, kHasTMax | kHasCheckStart | kHasArcs);
    check_size(required(result, "result"), "result");
    Motions motions = motions_of(of, start, end, value_count);
    bend(motions.all, inner, inner_count);
    BodyScrewAnswer found = solve_screw(of.all, motions.all, body_options_of(options));
    const touchstone_body_screw_answer told = {sizeof told,
                                               static_cast<int>(found.verdict),
                                               found.free() ? 1 : 0,
                                               found.free_until,
                                               found.contact_by,
                                               found.start_intersections.size(),
                                               found.start_checked ? 1 : 0,
                                               0,
                                               found.in_open,
                                               found.cancelled,
                                               found.excluded,
                                               motions.turned};
    if (open != nullptr) *open = new touchstone_body_screws{std::move(found.pairs)};
    *result = told;
  });
}

std::size_t touchstone_body_screws_count(const touchstone_body_screws* screws) { return count_of(screws); }

int touchstone_body_screws_get(const touchstone_body_screws* screws, std::size_t index, touchstone_body_pair* pair,
                               touchstone_screw_answer* answer) {
  return guarded([&] {
    const auto& [elements, found] = item_of(screws, index, "screws");
    if (pair != nullptr) *pair = c_pair(elements);
    if (answer != nullptr) {
      *answer = {static_cast<int>(found.verdict), found.arcs, found.free_until, found.contact_by, found.deviation};
    }
  });
}

void touchstone_body_screws_destroy(touchstone_body_screws* screws) { delete screws; }

}  // extern "C"
