// The contacts of whole bodies are those of all pairs of their elements, asked one by one; they do not depend on
// threads.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>
#include <vector>

#include <touchstone/contact_times.hpp>
#include <touchstone/touchstone.hpp>

#include "rigid/random_bodies.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

bool same(const Answer& a, const Answer& b) {
  return a.contact == b.contact && a.toi == b.toi && a.toi_upper == b.toi_upper && a.nature == b.nature &&
         a.starts_within == b.starts_within && a.feature_a == b.feature_a && a.feature_b == b.feature_b;
}

bool same(const std::vector<BodyContact>& a, const std::vector<BodyContact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const BodyContact& one, const BodyContact& other) {
    return one.pair == other.pair && one.separation.distance == other.separation.distance &&
           same(one.answer, other.answer);
  });
}

struct BruteForce {
  std::vector<BodyContact> all, at_start, earliest;
  double toi = INFINITY, toi_upper = INFINITY;
};

BruteForce brute_force(const RandomBodies& scene, double t_max) {
  BruteForce result;
  std::vector<std::pair<BodyContact, ExactTime>> later;
  for (const BodyPair& pair : every_pair(scene.bodies)) {
    const CurvedQuery query = query_of(scene.bodies, pair, scene.motions);
    const Separation separation = separation_of(scene.bodies, pair);
    SolveOptions options;
    options.t_max = t_max;
    options.separation = separation;
    const Answer answer = solve(query, options);
    if (!answer.contact) continue;
    result.all.push_back({pair, separation, answer});
    if (answer.starts_within) {
      result.at_start.push_back({pair, separation, answer});
    } else {
      later.emplace_back(BodyContact{pair, separation, answer}, contact_times(query, separation, t_max).front().first);
    }
  }
  const auto least =
      std::min_element(later.begin(), later.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (least != later.end()) {
    result.toi = least->second.lower();
    result.toi_upper = least->second.upper();
    for (const auto& [contact, time] : later) {
      if (time == least->second) result.earliest.push_back(contact);
    }
  }
  std::sort(result.all.begin(), result.all.end(), [](const BodyContact& a, const BodyContact& b) {
    return std::tie(a.answer.toi, a.answer.toi_upper, a.pair) < std::tie(b.answer.toi, b.answer.toi_upper, b.pair);
  });
  return result;
}

}  // namespace

TEST_CASE("contacts of bodies are those of all pairs of their elements") {
  seeded::Rng random(4101);
  const std::size_t scenes = effort(100);
  std::size_t contacts = 0, starts = 0, misses = 0, several = 0;
  for (std::size_t i = 0; i < scenes; ++i) {
    const RandomBodies scene = random_bodies(random);
    BodyStepOptions options;
    options.check_start = false;
    if (random.one_in(4)) options.t_max = random.uniform(0, 1);
    CAPTURE(i, options.t_max);
    const BruteForce expected = brute_force(scene, options.t_max);
    const FirstBodyContact found = first_contact(scene.bodies, scene.motions, options);
    CHECK(found.contact == !expected.earliest.empty());
    CHECK(found.toi == expected.toi);
    CHECK(found.toi_upper == expected.toi_upper);
    CHECK(same(found.earliest, expected.earliest));
    CHECK(same(found.at_start, expected.at_start));
    CHECK(same(all_contacts(scene.bodies, scene.motions, options), expected.all));
    const std::vector<BodyPair> near = candidates(scene.bodies, scene.motions);
    CHECK(std::is_sorted(near.begin(), near.end()));
    CHECK(std::adjacent_find(near.begin(), near.end()) == near.end());
    for (const BodyContact& contact : expected.all) {
      CHECK(std::binary_search(near.begin(), near.end(), contact.pair));
    }
    options.threads = 3;
    const FirstBodyContact again = first_contact(scene.bodies, scene.motions, options);
    CHECK(again.toi == found.toi);
    CHECK(same(again.earliest, found.earliest));
    CHECK(same(again.at_start, found.at_start));
    contacts += expected.earliest.empty() ? 0 : 1;
    several += expected.earliest.size() > 1 ? 1 : 0;
    starts += expected.at_start.empty() ? 0 : 1;
    misses += expected.all.empty() ? 1 : 0;
  }
  if (!whole_effort("that each sort of scene comes")) return;
  CHECK(contacts > scenes / 10);
  CHECK(several > 0);
  CHECK(starts > 0);
  CHECK(misses > 0);
}

TEST_CASE("a box that turns a quarter meets a wall where its corner does") {
  // A square bar turns about its axis beside a wall that its corner, sqrt(2) away, reaches at 45 degrees.
  Bodies bodies;
  bodies.bodies = {box(1, 1, 3), box(0.25, 8, 8)};
  std::vector<RigidMotion> motions(2);
  const double s = std::sqrt(0.5);
  motions[0].q1 = {s, 0, 0, s};
  motions[1].p0 = motions[1].p1 = {1.375 + 0.25, 0, 0};  // 1.375 < sqrt(2)
  const FirstBodyContact hit = first_contact(bodies, motions);
  REQUIRE(hit.contact);
  CHECK(hit.toi < 0.5);
  // The corner is at 1.375 from the axis where the body has turned by 45 degrees minus acos(1.375 / sqrt(2)).
  const double angle = std::acos(-1.0) / 4 - std::acos(1.375 / std::sqrt(2.0));
  const double q = std::tan(angle / 2);  // (1 - t) (1, 0) + t (s, s) has this slope
  CHECK(hit.toi == Approx(q / (s + q - q * s)).epsilon(1e-12));
  motions[1].p0.x = motions[1].p1.x = 1.4375 + 0.25;  // 1.4375 > sqrt(2)
  CHECK(first_contact(bodies, motions).free());
  motions[0].q1 = {0, 0, 0, 1};  // half a turn passes the wall twice, and ends where it began
  CHECK(first_contact(bodies, motions).free());
  motions[1].p0.x = motions[1].p1.x = 1.375 + 0.25;
  CHECK(first_contact(bodies, motions).contact);
}

TEST_CASE("a recorded pose of the other sign turns the shorter way on request") {
  Pose start, end;
  end.orientation = {-std::cos(0.05), 0, 0, -std::sin(0.05)};
  CHECK(motion_between(start, end).q1[0] > 0);
  CHECK(motion_between(start, end, Turn::as_given).q1[0] < 0);
  CHECK(takes_longer_turn(motion_between(start, end, Turn::as_given)));
  CHECK(pose_of({1, 2, 3}, {4, 5, 6, 7}, QuaternionOrder::wxyz).orientation == std::array<double, 4>{4, 5, 6, 7});
  CHECK(pose_of({1, 2, 3}, {4, 5, 6, 7}, QuaternionOrder::xyzw).orientation == std::array<double, 4>{7, 4, 5, 6});
  CHECK(pose_of({1, 2, 3}, {4, 5, 6, 7}, QuaternionOrder::xyzw).position.z == 3);
}

TEST_CASE("bodies that turn about an origin far away have few candidates, and the contacts of all pairs") {
  // A plate at 1e5 from the axis makes a quarter turn, and passes a small box half-way.
  constexpr MeshIndex kSide = 10;
  constexpr double kFar = 1e5;
  MeshElements elements;
  elements.vertex_count = (kSide + 1) * (kSide + 1);
  std::vector<Vec3> points;
  for (MeshIndex i = 0; i <= kSide; ++i) {
    for (MeshIndex j = 0; j <= kSide; ++j) {
      points.push_back({kFar + i / 10.0, 0.01 * ((i + j) % 3), j / 10.0});
      const MeshIndex v = i * (kSide + 1) + j;
      if (i == kSide || j == kSide) continue;
      elements.faces.push_back({v, v + 1, v + kSide + 2});
      elements.faces.push_back({v, v + kSide + 2, v + kSide + 1});
    }
  }
  const double s = std::sqrt(0.5);
  Bodies bodies;
  bodies.bodies = {Body(Mesh(elements), Positions(points)), box(0.25, 0.25, 0.25)};
  for (const double away : {0.5, 1.5}) {  // from the way of the plate's inner edge
    std::vector<RigidMotion> motions(2);
    motions[0].q1 = {s, 0, 0, s};
    motions[1].p0 = motions[1].p1 = {(kFar + away) * s, (kFar + away) * s, 0.5};
    // Arcs of a 256th of the step leave straight motion by 0.5, and the box is 0.14 away from the way.
    CHECK(candidates(bodies, motions).empty() == (away > 1));
    std::vector<BodyPair> touching;
    for (const BodyPair& pair : every_pair(bodies)) {
      const Separation separation = separation_of(bodies, pair);
      if (solve(query_of(bodies, pair, motions), {.separation = separation}).contact) touching.push_back(pair);
    }
    std::vector<BodyPair> found;
    for (const BodyContact& contact : all_contacts(bodies, motions)) found.push_back(contact.pair);
    std::sort(found.begin(), found.end());
    CHECK(found == touching);
    CHECK(found.empty() == (away > 1));
  }
}

TEST_CASE("bodies that turn together about an origin far away have few candidates, and the contacts of all pairs") {
  seeded::Rng random(4143);
  std::size_t touching_scenes = 0, free_scenes = 0;
  for (std::size_t i = 0; i < effort(24); ++i) {
    // Two boxes, one beside the other at this distance from an axis. The second one may have a frame of its own.
    const double far = std::ldexp(1.0, random.between(10, 24)), gap = random.uniform(0.25, 2);
    const bool meets = random.one_in(2), turned = random.one_in(2);
    const double right = std::sqrt(0.5), angle = random.uniform(0.1, 1);
    const auto moved = [&](const Body& body, double by) {
      std::vector<Vec3> points = body.points();
      for (Vec3& p : points) p.x += by;
      return points;
    };
    std::vector<Vec3> second = moved(box(1, 1, 1), far + 2 + gap);
    if (turned) {
      for (Vec3& p : second) p = {p.y, -p.x, p.z};  // by a quarter turn about z, back
    }
    Bodies bodies;
    bodies.bodies = {Body(box(1, 1, 1).mesh(), Positions(moved(box(1, 1, 1), far))),
                     Body(box(1, 1, 1).mesh(), Positions(second))};
    const double c = std::cos(angle / 2), s = std::sin(angle / 2);
    std::vector<RigidMotion> motions(2);
    motions[0].q1 = motions[1].q1 = {c, 0, 0, s};
    if (turned) {
      motions[1].q0 = {right, 0, 0, right};
      motions[1].q1 = {c * right - s * right, 0, 0, c * right + s * right};
    }
    // The first body approaches the other one along the line between them, at the end of the step.
    const double way = meets ? gap + 0.5 : gap / 2;
    motions[0].p1 = {way * std::cos(angle), way * std::sin(angle), 0};
    CAPTURE(i, far, gap, turned, angle);
    std::vector<BodyPair> touching, found;
    for (const BodyPair& pair : every_pair(bodies)) {
      if (solve(query_of(bodies, pair, motions)).contact) touching.push_back(pair);
    }
    for (const BodyContact& contact : all_contacts(bodies, motions)) found.push_back(contact.pair);
    std::sort(found.begin(), found.end());
    CHECK(found == touching);
    CHECK(touching.empty() == !meets);
    const std::size_t near = candidates(bodies, motions).size();
    CHECK(near >= touching.size());
    if (!meets) CHECK(near == 0);
    ++(meets ? touching_scenes : free_scenes);
  }
  if (!whole_effort("that bodies meet, and do not")) return;
  CHECK(touching_scenes > 0);
  CHECK(free_scenes > 0);
}
