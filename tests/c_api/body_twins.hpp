// Bodies of C++ and their twins of the C interface.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/touchstone.hpp>

#include "c_api/c_api_support.hpp"
#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"

namespace touchstone::tests {

using Indices = std::vector<std::uint32_t>;

template <std::size_t N>
Indices flat(const std::vector<std::array<std::uint32_t, N>>& rows) {
  Indices all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

inline touchstone_body* c_body(const Body& body) {
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
inline std::vector<double> rows(const std::vector<Pose>& poses, QuaternionOrder order) {
  std::vector<double> all;
  for (const auto& [q, p] : poses) {
    all.insert(all.end(), {p.x, p.y, p.z});
    if (order == QuaternionOrder::wxyz) all.insert(all.end(), q.begin(), q.end());
    if (order == QuaternionOrder::xyzw) all.insert(all.end(), {q[1], q[2], q[3], q[0]});
  }
  return all;
}

inline touchstone_bodies_elements elements_of_none() { return TOUCHSTONE_BODIES_ELEMENTS_INIT; }

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

inline bool same_pair(const BodyPair& expected, const touchstone_body_pair& found) {
  return expected ==
         BodyPair{static_cast<Kind>(found.kind), {found.first_body, found.first}, {found.second_body, found.second}};
}

inline bool same_contacts(const std::vector<BodyContact>& expected, touchstone_body_contacts* found) {
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

inline bool same_pairs(const std::vector<BodyPair>& expected, touchstone_body_pairs* found) {
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

inline bool same_intersections(const std::vector<BodyIntersection>& expected, touchstone_body_intersections* found) {
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

inline bool same_screws(const std::vector<BodyScrewContact>& expected, touchstone_body_screws* found) {
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
inline RandomBodies grazing_boxes() {
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

}  // namespace touchstone::tests
