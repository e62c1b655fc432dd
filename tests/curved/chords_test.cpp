// The chords of curved queries: how far corners leave them, against rationals, and what the filter decides by them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <gmpxx.h>

#include "curved/expected.hpp"
#include "curved/rational_motion.hpp"
#include "filters/curved/curved_chords.hpp"
#include "geometry/arc_bulge.hpp"
#include "seeded/rng.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using seeded::Rng;

constexpr std::uint64_t kSeed = 73;

mpq_class exact(double x) { return mpq_class(x); }

struct Plan {
  double most_turn;     // of the quaternion, about, in radians
  double most_stretch;  // of its length, relatively
  double far;           // positions, over the size of the bodies
};

/// A vertex of a body that turns, and a face of another one that is its origin's neighbour and does not turn.
CurvedQuery some_query(Rng& rng, const Plan& plan) {
  CurvedQuery query;
  query.kind = Kind::vertex_face;
  // Full significands of several orders: their sums and differences are rounded.
  const auto coordinate = [&](double size) {
    const double x = size * (1 + rng.unit()) / 2;
    return std::ldexp(rng.one_in(2) ? x : -x, -rng.between(0, 3));
  };
  const auto point = [&](double size) {
    const double x = coordinate(size), y = coordinate(size), z = coordinate(size);
    return Vec3{x, y, z};
  };
  RigidMotion& turning = query.motions[0];
  RigidMotion& rest = query.motions[1];
  const int q_size = rng.between(-100, 100);
  std::array<double, 4> v;  // the change of the quaternion, across it
  double along = 0, square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    turning.q0[i] = rng.one_in(6) ? 0 : rng.symmetric();
    rest.q0[i] = rest.q1[i] = i == 0 ? 1 : 0;
    v[i] = rng.symmetric();
    along += v[i] * turning.q0[i];
    square += turning.q0[i] * turning.q0[i];
  }
  const double turn = plan.most_turn * rng.unit();
  double length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    v[i] -= along / square * turning.q0[i];
    length += v[i] * v[i];
  }
  const double stretch = 1 + plan.most_stretch * rng.symmetric();
  for (std::size_t i = 0; i < 4; ++i) {
    const double q = std::cos(turn) * turning.q0[i] + std::sin(turn) * std::sqrt(square / length) * v[i];
    turning.q1[i] = std::ldexp(plan.most_turn == 0 ? turning.q0[i] : stretch * q, q_size);
    turning.q0[i] = std::ldexp(turning.q0[i], q_size);
  }
  turning.p0 = point(plan.far);
  turning.p1 = point(plan.far);
  rest.p0 = point(plan.far);
  rest.p1 = point(plan.far);
  // Coordinates of one size: there the bound on the length by the largest one is tight.
  const double x = rng.one_in(2) ? 1 : -1, y = rng.one_in(2) ? 1 : -1;
  query.corners[0] = CurvedCorner::on_body(0, rng.one_in(2) ? Vec3{x, y, 1} : point(1));
  for (std::size_t i = 1; i < 4; ++i)
    query.corners[i] = CurvedCorner::on_body(1, plan.far > 1 ? point(1) : Vec3{0, 0, 0});
  return query;
}

/// How far the difference of the vertex and a corner of the face is from that of their chords, over the bound.
double share_of_bound(const CurvedQuery& query, const filters::Chords& chords, double time) {
  const mpq_class t = exact(time);
  const RationalCorner vertex = corner_at(query, 0, t), face = corner_at(query, 1, t);
  mpq_class square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class truth = vertex.numerator[k] / vertex.weight - face.numerator[k] / face.weight;
    const auto coordinate = [k](const Vec3& x) { return exact(k == 0 ? x.x : k == 1 ? x.y : x.z); };
    const mpq_class start = coordinate(chords.query.start[0]) - coordinate(chords.query.start[1]);
    const mpq_class end = coordinate(chords.query.end[0]) - coordinate(chords.query.end[1]);
    const mpq_class off = truth - ((1 - t) * start + t * end);
    square += off * off;
  }
  REQUIRE(square <= exact(chords.deviation) * exact(chords.deviation));
  return std::sqrt(mpq_class(square / (exact(chords.deviation) * exact(chords.deviation))).get_d());
}

double worst_share(std::uint64_t seed, const Plan& plan, std::uint64_t cases = effort(5000)) {
  double worst = 0;
  std::size_t known = 0;
  for (std::uint64_t index = 0; index < cases; ++index) {
    Rng rng(seeded::seed_of_stream(seed, index));
    INFO("seed " << seed << ", index " << index);
    const CurvedQuery query = some_query(rng, plan);
    const filters::Chords chords = filters::chords_of(query);
    if (!chords.known) continue;
    ++known;
    for (const double t : {0.0, 1.0, 0.5, rng.unit()}) worst = std::max(worst, share_of_bound(query, chords, t));
  }
  CHECK(known > cases / 2);
  return worst;
}

}  // namespace

TEST_CASE("the filter's chords: no corner leaves them by more than their bound, and some nearly by as much") {
  const double turning = worst_share(kSeed, {1, 0, 1});
  for (const double turn : {1.0, 0x1p-20, 0x1p-40}) worst_share(kSeed + 1, {turn, 0x1p-41, 1});  // the most stretch
  // Near the origin few cases come near the bound: slow builds try all of them, too.
  const double near = worst_share(kSeed + 3, {1e-9, 0x1p-41, 0x1p-20}, 5000);
  const double far = worst_share(kSeed + 2, {1e-9, 0, 0x1p20});
  std::printf("corners leave their chords by up to %.2g of the bound, by rounding %.2g, far from the origin %.2g\n",
              turning, near, far);
  CHECK(turning > 0.125);
  CHECK(near > 0.125);
  CHECK(far > 0.125);
}

TEST_CASE("the bulge of an arc: no point leaves the line by more than its bound, and some nearly by as much") {
  Rng rng(kSeed + 4);
  double worst = 0;
  for (std::uint64_t index = 0; index < effort(200'000); ++index) {
    // The point (1, 0, 0) turns by the angle 4 atan(k) about the axis z: from (c, 0, 0, -s) to (c, 0, 0, s).
    const double k = std::ldexp(1 - rng.unit(), -rng.between(0, 12));
    const double c = 1 / std::sqrt(1 + k * k), s = k / std::sqrt(1 + k * k);
    const double t = rng.unit();
    const double z = (2 * t - 1) * s;  // of the quaternion at t, whose w is c
    const double x = (c * c - z * z) / (c * c + z * z), y = 2 * c * z / (c * c + z * z);
    const double off = std::hypot(x - (c * c - s * s), y - (2 * t - 1) * 2 * c * s);
    worst = std::max(worst, off / (4 * s * s));
  }
  INFO(worst);
  CHECK(worst <= geometry::kArcBulge);
  CHECK(worst > 0.49);  // k near 0 and t = 1/2 give 1/2
}

TEST_CASE("the filter's chords: unknown for bodies that turn far, for lengths that differ, and for curves that bend") {
  Rng rng(kSeed);
  const CurvedQuery query = some_query(rng, {0.1, 0, 1});
  REQUIRE(filters::chords_of(query).known);
  CurvedQuery longer = query;
  for (double& q : longer.motions[0].q1) q *= 1 + 0x1p-30;
  CHECK_FALSE(filters::chords_of(longer).known);
  CurvedQuery far = query;
  far.motions[0].q0 = {1, 0, 0, 0};
  far.motions[0].q1 = {0.1, 1, 0, 0};
  CHECK_FALSE(filters::chords_of(far).known);
  CurvedQuery two_bodies = query;
  two_bodies.corners[3].motion = 2;
  CHECK_FALSE(filters::chords_of(two_bodies).known);
  CurvedQuery curve = query;
  for (std::size_t i = 1; i < 4; ++i) curve.corners[i] = CurvedCorner::on_curve({{0, 0, 0}, {1, 0, 0}});
  CHECK(filters::chords_of(curve).known);
  curve.corners[2] = CurvedCorner::on_curve({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}});
  CHECK_FALSE(filters::chords_of(curve).known);
}

TEST_CASE("the filter's chords: an arc that reaches past its chord") {
  // A point turns about z, from 30 degrees before the x axis to 30 degrees after it: its chord is at x = 0.866.
  RigidMotion turn;
  turn.q0 = {0.9659258262890683, 0, 0, -0.25881904510252074};
  turn.q1 = {0.9659258262890683, 0, 0, 0.25881904510252074};
  const auto wall = [&](double x) {
    return curved(Kind::vertex_face, {body(0, {1, 0, 0}), rest({x, -9, -9}), rest({x, 9, -9}), rest({x, 0, 9})},
                  {turn});
  };
  REQUIRE(filters::chords_of(wall(0.9)).known);
  for (const double x : {0.87, 0.9, 0.99, 0.9999}) {
    REQUIRE(solve(wall(x), {.method = Method::exact}).contact);
    CHECK_FALSE(filters::chords_certainly_farther(wall(x), Separation()));
  }
  CHECK(filters::chords_certainly_farther(wall(1.2), Separation()));
  CHECK_FALSE(filters::chords_certainly_farther(wall(1.2), {0.3, Metric::euclidean}));
}

TEST_CASE("the filter's chords never deny a contact, and show most misses of bodies that turn a little") {
  std::size_t misses = 0, shown = 0, touching = 0;
  for (std::uint64_t index = 0; index < effort(3000); ++index) {
    const Kind kind = index % 2 == 0 ? Kind::edge_edge : Kind::vertex_face;
    Rng rng(seeded::seed_of_stream(kSeed + 3, index));
    INFO("seed " << kSeed + 3 << ", index " << index);
    CurvedQuery query = make_curved({Family::turning_bodies, kind, kSeed + 3, index}).query;
    // A short step from where the bodies are: they turn and move by a small part of what the family makes of it.
    const double part = std::ldexp(1, -rng.between(2, 12));
    for (RigidMotion& motion : query.motions) {
      double dot = 0, square = 0, other = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        dot += motion.q0[i] * motion.q1[i];
        square += motion.q0[i] * motion.q0[i];
        other += motion.q1[i] * motion.q1[i];
      }
      double length = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        motion.q0[i] /= std::sqrt(square);
        const double there = (dot < 0 ? -1 : 1) * motion.q1[i] / std::sqrt(other);
        motion.q1[i] = motion.q0[i] + part * (there - motion.q0[i]);
        length += motion.q1[i] * motion.q1[i];
      }
      for (double& q : motion.q1) q /= std::sqrt(length);
      const auto near = [part](double from, double to) { return from + part * (to - from); };
      motion.p1 = {near(motion.p0.x, motion.p1.x), near(motion.p0.y, motion.p1.y), near(motion.p0.z, motion.p1.z)};
    }
    for (const double distance : {0.0, std::ldexp(1.0, -rng.between(3, 20))}) {
      const Separation separation = {distance, rng.one_in(2) ? Metric::euclidean : Metric::max};
      const bool contact = solve(query, {.separation = separation, .method = Method::exact}).contact;
      const bool apart = filters::chords_certainly_farther(query, separation);
      REQUIRE_FALSE((contact && apart));
      touching += contact;
      misses += !contact;
      shown += apart;
    }
  }
  std::printf("%zu contacts; of %zu misses the chords show %zu\n", touching, misses, shown);
  CHECK(touching > effort(3000) / 50);
  CHECK(2 * shown > misses);
}

}  // namespace touchstone::tests
