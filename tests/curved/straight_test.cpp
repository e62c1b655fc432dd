// Straight motion, given as curves or as a motion of rigid bodies, has the answers of straight queries.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include <touchstone/curved.hpp>

#include "support/answer_check.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 41;

/// The same curve with one more control point, exact as long as the corners are small multiples of the degree.
CurvedQuery elevated(const Query& query) {
  CurvedQuery curved(query);
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const Vec3 &a = query.start[i], &b = query.end[i];
    const Vec3 middle = {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
    curved.corners[i] = CurvedCorner::on_curve({a, middle, b});
  }
  return curved;
}

void straight_as_curves(Kind kind) {
  Report report;
  std::size_t contacts = 0, raised = 0;
  const auto wanted = [kind](const FamilyInfo& family, Kind k) {
    return k == kind && family.group != Group::separation;
  };
  for_each_case(kSeed, 400, wanted, [&](const CaseId& id) {
    const Query query = make(id);
    const Answer straight = solve(query, {.method = Method::exact});
    const Answer curved = solve(CurvedQuery(query), {.method = Method::exact});
    std::string wrong = labelled("as curves", bit_difference(straight, curved, true));
    const Answer fast = solve(query);
    if (wrong.empty()) wrong = labelled("by default", bit_difference(fast, solve(CurvedQuery(query)), true));
    if (wrong.empty()) wrong = labelled("fast", decision_difference(fast, curved));
    if (wrong.empty()) wrong = labelled("fast", weight_difference(fast, curved));
    if (wrong.empty() && info(id.family).dyadic) {
      const Answer answer = solve(elevated(query), {.method = Method::exact});
      wrong = labelled("with another control point", decision_difference(straight, answer));
      if (wrong.empty()) wrong = weight_difference(straight, answer);
      ++raised;
    }
    contacts += straight.contact;
    report.add(id, query, wrong);
  });
  std::printf("seed %llu, %s: %zu straight queries as curves, %zu with contact; %zu with another control point\n",
              static_cast<unsigned long long>(kSeed), name_of(kind).data(), report.checked(), contacts, raised);
  CHECK(contacts > 0);
  CHECK(raised > 0);
  report.finish();
}

Vec3 lattice_point(Rng& rng, int size) {
  const auto coordinate = [&] { return static_cast<double>(rng.between(-size, size)); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

Vec3 sum(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// A rotation that is exact on multiples of 5.
struct Turn {
  std::array<double, 4> q;
  Vec3 (*apply)(const Vec3& x);
};
constexpr std::array<Turn, 5> kTurns = {{
    {{3, 0, 0, 0}, [](const Vec3& x) { return x; }},
    {{-1, 0, 0, -1},
     [](const Vec3& x) {
       return Vec3{-x.y, x.x, x.z};
     }},
    {{0, 0x1p-900, 0, 0},
     [](const Vec3& x) {
       return Vec3{x.x, -x.y, -x.z};
     }},
    {{0.5, 0.5, 0.5, 0.5},
     [](const Vec3& x) {
       return Vec3{x.z, x.x, x.y};
     }},
    {{0x1p600, 0, 0x1p601, 0},
     [](const Vec3& x) {
       return Vec3{(-3 * x.x + 4 * x.z) / 5, x.y, (-4 * x.x - 3 * x.z) / 5};
     }},
}};

/// Two bodies in fixed orientations that move on straight lines, as rigid motions and as a straight query.
void translated_bodies(Kind kind) {
  std::size_t contacts = 0;
  constexpr std::size_t kCount = 3000;
  for (std::uint64_t index = 0; index < kCount; ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + static_cast<std::uint64_t>(kind), index));
    const int size = rng.between(1, 3);
    Query straight;
    CurvedQuery rigid;
    straight.kind = rigid.kind = kind;
    const std::array<Turn, 2> turns = {rng.pick(kTurns), rng.pick(kTurns)};
    for (std::size_t body = 0; body < 2; ++body) {
      RigidMotion& motion = rigid.motions[body];
      motion.q0 = motion.q1 = turns[body].q;
      motion.p0 = lattice_point(rng, 5 * size);
      motion.p1 = rng.one_in(4) ? motion.p0 : lattice_point(rng, 5 * size);
    }
    for (std::size_t i = 0; i < corner_count(kind); ++i) {
      const bool second = kind == Kind::edge_edge ? i >= 2 : i >= 1;
      const Vec3 fifth = lattice_point(rng, size);
      const Vec3 point = {5 * fifth.x, 5 * fifth.y, 5 * fifth.z};
      rigid.corners[i] = CurvedCorner::on_body(second ? 1 : 0, point);
      const RigidMotion& motion = rigid.motions[second ? 1 : 0];
      straight.start[i] = sum(turns[second ? 1 : 0].apply(point), motion.p0);
      straight.end[i] = sum(turns[second ? 1 : 0].apply(point), motion.p1);
    }
    if (rng.one_in(2)) {
      // Let the second element's last corner, or the middle of an edge, be at the first corner's place at t = 1/2.
      const auto middle = [](const Vec3& a, const Vec3& b) {
        return Vec3{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
      };
      const auto at_half = [&](std::size_t i) { return middle(straight.start[i], straight.end[i]); };
      const std::size_t last = corner_count(kind) - 1;
      const Vec3 from = at_half(0);
      const Vec3 to = last > 1 && rng.one_in(2) ? middle(at_half(last - 1), at_half(last)) : at_half(last);
      const Vec3 shift = {from.x - to.x, from.y - to.y, from.z - to.z};
      RigidMotion& motion = rigid.motions[1];
      motion.p0 = sum(motion.p0, shift);
      motion.p1 = sum(motion.p1, shift);
      for (std::size_t i = kind == Kind::edge_edge ? 2 : 1; i <= last; ++i) {
        straight.start[i] = sum(straight.start[i], shift);
        straight.end[i] = sum(straight.end[i], shift);
      }
    }
    const Answer expected = solve(straight, {.method = Method::exact});
    const Answer found = solve(rigid, {.method = Method::exact});
    contacts += expected.contact;
    INFO("seed " << kSeed << ", index " << index << "\n  " << cpp_initializer(straight));
    INFO(describe(found));
    REQUIRE(decision_difference(expected, found) == "");
    REQUIRE(weight_difference(expected, found) == "");
  }
  CHECK(contacts > 100);
  CHECK(contacts < kCount);
}

TEST_CASE("straight motion as curves: edge-edge") { straight_as_curves(Kind::edge_edge); }
TEST_CASE("straight motion as curves: vertex-face") { straight_as_curves(Kind::vertex_face); }
TEST_CASE("straight motion as curves: point-edge") { straight_as_curves(Kind::point_edge); }
TEST_CASE("straight motion as curves: point-point") { straight_as_curves(Kind::point_point); }

TEST_CASE("rigid bodies that do not turn move like straight input: edge-edge") { translated_bodies(Kind::edge_edge); }
TEST_CASE("rigid bodies that do not turn move like straight input: vertex-face") {
  translated_bodies(Kind::vertex_face);
}
TEST_CASE("rigid bodies that do not turn move like straight input: point-edge") { translated_bodies(Kind::point_edge); }
TEST_CASE("rigid bodies that do not turn move like straight input: point-point") {
  translated_bodies(Kind::point_point);
}

}  // namespace
}  // namespace touchstone::tests
