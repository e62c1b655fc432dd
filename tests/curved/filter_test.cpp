// The filter of curved queries: the points that it finds in doubles against the true ones, and how often it decides.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gmpxx.h>

#include "curved/expected.hpp"
#include "curved/rational_motion.hpp"
#include "filters/curved/curved_paths.hpp"
#include "seeded/rng.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using seeded::Rng;
constexpr std::uint64_t kSeed = 47;

/// The Bernstein coefficients of a cubic from its values at 0, 1/3, 2/3 and 1.
std::array<mpq_class, 4> bernstein(const std::array<mpq_class, 4>& f) {
  return {f[0], (-5 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / 6, (2 * f[0] - 9 * f[1] + 18 * f[2] - 5 * f[3]) / 6,
          f[3]};
}

/// A point whose coordinates are drawn by `length`, in the order x, y, z.
template <class Length>
Vec3 place_by(const Length& length) {
  const double x = length(), y = length(), z = length();
  return {x, y, z};
}

RationalPoint relative(const RationalPoint& x, const RationalPoint& origin) {
  return {x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]};
}

TEST_CASE("the control points of turning corners are within their bound of the true ones") {
  double worst = 0;
  std::size_t known = 0;
  for (std::uint64_t index = 0; index < effort(4000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed, index));
    const int magnitude = rng.one_in(2) ? 0 : rng.between(-890, 890);
    const auto length = [&] {
      return std::ldexp(rng.symmetric(), magnitude - (rng.one_in(3) ? rng.between(0, 60) : 0));
    };
    const auto place = [&] { return place_by(length); };
    CurvedQuery query;
    query.kind = Kind::point_point;
    // The first body is where positions are measured from; the other one is the one that is looked at.
    query.corners[0] = CurvedCorner::on_body(1, place());
    query.motions[1].p0 = place();
    query.motions[1].p1 = place();
    query.corners[1] = CurvedCorner::on_body(0, place());
    RigidMotion& motion = query.motions[0];
    const int size = rng.between(-1060, 1000);
    for (std::size_t i = 0; i < 4; ++i) {
      const double c = rng.one_in(4) ? 0 : rng.symmetric();
      motion.q0[i] = std::ldexp(c, size);
      motion.q1[i] = std::ldexp(rng.one_in(2) ? c + 0.5 * rng.symmetric() : rng.symmetric(), size);
    }
    motion.p0 = place();
    motion.p1 = place();
    const filters::CurvedPaths paths = filters::curved_paths(query);
    if (!paths.known) continue;
    ++known;
    RationalMotion truth(motion, query.corners[1].points[0]);
    truth.p0 = relative(truth.p0, exact(query.motions[1].p0));
    truth.p1 = relative(truth.p1, exact(query.motions[1].p1));
    std::array<mpq_class, 4> weights;
    std::array<RationalPoint, 4> numerators;
    for (int i = 0; i < 4; ++i) {
      const mpq_class t(i, 3);
      weights[static_cast<std::size_t>(i)] = truth.weight(t);
      numerators[static_cast<std::size_t>(i)] = truth.numerator(t);
    }
    weights = bernstein(weights);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto numerator = bernstein({numerators[0][k], numerators[1][k], numerators[2][k], numerators[3][k]});
      for (std::size_t i = 0; i < 4; ++i) {
        INFO("seed " << kSeed << ", index " << index);
        REQUIRE(weights[i] > 0);
        const mpq_class off = abs(mpq_class(mpq_class(paths.corners[1].points[i][k]) - numerator[i] / weights[i]));
        REQUIRE(off <= mpq_class(paths.error));
        REQUIRE(std::fabs(paths.corners[1].points[i][k]) <= paths.size);
        worst = std::max(worst, mpq_class(off / mpq_class(paths.error)).get_d());
      }
    }
  }
  std::printf("seed %llu: %zu turning corners, the largest error is %.2g of the bound\n",
              static_cast<unsigned long long>(kSeed), known, worst);
  CHECK(known > effort(4000) / 4);
  CHECK(worst > 1e-5);
}

TEST_CASE("the control points of curves, seen from a body that moves, are within their bound") {
  for (std::uint64_t index = 0; index < effort(2000); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 2, index));
    INFO("seed " << kSeed + 2 << ", index " << index);
    const int magnitude = rng.between(-300, 300);
    const auto place = [&] {
      return place_by([&] { return std::ldexp(rng.symmetric(), magnitude + rng.between(-4, 4)); });
    };
    CurvedQuery query;
    query.kind = Kind::point_point;
    query.corners[0] = CurvedCorner::on_body(0, place());
    query.motions[0].p0 = place();
    query.motions[0].p1 = place();
    query.corners[1].control_points = rng.between(1, 4);
    for (Vec3& point : query.corners[1].points) point = place();
    if (rng.one_in(3)) std::swap(query.corners[0], query.corners[1]);
    const std::size_t curve = query.corners[0].motion == CurvedCorner::kOnCurve ? 0 : 1;
    const filters::CurvedPaths paths = filters::curved_paths(query);
    REQUIRE(paths.known);
    const auto& path = paths.corners[curve];
    const std::size_t given = static_cast<std::size_t>(query.corners[curve].control_points);
    REQUIRE(path.count == std::max<std::size_t>(given, 2));
    for (std::size_t i = 0; i < path.count; ++i) {
      const RationalPoint point = exact(query.corners[curve].points[std::min(i, given - 1)]);
      const RationalPoint from = exact(query.motions[0].p0), to = exact(query.motions[0].p1);
      const mpq_class part(static_cast<long>(i), static_cast<long>(path.count - 1));
      for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class truth = point[k] - ((1 - part) * from[k] + part * to[k]);
        REQUIRE(abs(mpq_class(mpq_class(path.points[i][k]) - truth)) <= mpq_class(paths.error));
        REQUIRE(std::fabs(path.points[i][k]) <= paths.size);
      }
    }
  }
}

TEST_CASE("the filter proves apart what flies together") {
  // Two points a thousandth apart, on bodies that move by a thousand in one step: no plane at rest is between them.
  RigidMotion flight;
  flight.p1 = {1000, 500, 0};
  RigidMotion beside = flight;
  beside.q0 = beside.q1 = {1, 1, 1, 1};
  CHECK(filters::certainly_apart(
      curved(Kind::point_point, {body(0, {1, 2, 3}), body(1, {2, 3.001, 1})}, {flight, beside})));
  CHECK_FALSE(
      filters::certainly_apart(curved(Kind::point_point, {body(0, {1, 2, 3}), body(1, {2, 3, 1})}, {flight, beside})));
  const CurvedCorner line = CurvedCorner::on_curve({{1, 2, 3.001}, {1001, 502, 3.001}});
  CHECK(filters::certainly_apart(curved(Kind::point_point, {line, body(0, {1, 2, 3})}, {flight})));
  const CurvedCorner bow = CurvedCorner::on_curve({{1, 2, 4}, {501, 252, 3.001}, {1001, 502, 4}});
  CHECK(filters::certainly_apart(curved(Kind::point_point, {body(0, {1, 2, 3}), bow}, {flight})));
}

TEST_CASE("the filter proves nothing by a direction that overflows") {
  // The vertex is at a corner of the face. One component of n is the difference of two products that overflow.
  const double far = 0x1p600;
  const CurvedQuery query =
      curved(Kind::vertex_face, {body(0, {0, 0, 0}), rest({0, 0, 0}), rest({far, 1, far}), rest({2 * far, -1, far})},
             {RigidMotion()});
  CHECK_FALSE(filters::certainly_apart(query));
  CHECK(solve(query).contact);
}

TEST_CASE("the filter decides most of what is apart, and never what touches") {
  std::size_t decided = 0, apart = 0, touching = 0;
  const std::size_t count = effort(3000);
  for (std::uint64_t index = 0; index < count; ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 1, index));
    const auto vector = [&](double size) {
      const double x = size * rng.symmetric(), y = size * rng.symmetric(), z = size * rng.symmetric();
      return Vec3{x, y, z};
    };
    CurvedQuery query;
    query.kind = static_cast<Kind>(rng.between(0, 3));
    for (RigidMotion& motion : query.motions) {
      for (std::size_t i = 0; i < 4; ++i) {
        motion.q0[i] = rng.symmetric();
        motion.q1[i] = motion.q0[i] + 0.25 * rng.symmetric();
      }
      motion.p0 = vector(1);
      motion.p1 = {motion.p0.x + rng.symmetric(), motion.p0.y, motion.p0.z};
    }
    // Every fourth time the first corners of both elements are one point of one body.
    const bool together = rng.one_in(4);
    if (together) query.motions[1] = query.motions[0];
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      const bool second = query.kind == Kind::edge_edge ? i >= 2 : i >= 1;
      query.corners[i] = CurvedCorner::on_body(second ? 1 : 0, vector(1));
    }
    const std::size_t first_of_second = query.kind == Kind::edge_edge ? 2 : 1;
    if (together) query.corners[first_of_second].points = query.corners[0].points;
    const bool filtered = filters::certainly_apart(query);
    const Answer exact_answer = solve(query, {.method = Method::exact});
    const Answer fast = solve(query);
    INFO("seed " << kSeed + 1 << ", index " << index);
    REQUIRE(fast.contact == exact_answer.contact);
    REQUIRE((fast.level == Level::filter) == filtered);
    REQUIRE(!(together && filtered));
    decided += filtered;
    apart += !exact_answer.contact;
    touching += exact_answer.contact;
  }
  std::printf("seed %llu: %zu apart, %zu of them by the filter; %zu touch\n",
              static_cast<unsigned long long>(kSeed + 1), apart, decided, touching);
  CHECK(2 * decided > apart);
  CHECK(touching > count / 8);
}

TEST_CASE("the filter on corners that are apart by little") {
  // Two points at rest, one of them on a body: the bound is 2^-37 or so of the coordinates.
  const auto filtered = [](double gap) {
    RigidMotion still;
    still.q0 = still.q1 = {0.3, 0.4, 0.5, 0.6};
    return filters::certainly_apart(curved(Kind::point_point, {body(0, {0, 0, 0}), rest({gap, 0, 0})}, {still}));
  };
  CHECK(filtered(1e-3));
  CHECK(filtered(1e-300) == false);  // below kLeastLength: nothing is known
  const auto beside = [](double gap) {
    return filters::certainly_apart(curved(Kind::point_point, {rest({1, 1, 1}), rest({1 + gap, 1, 1})}));
  };
  CHECK(beside(1e-8));
  CHECK_FALSE(beside(1e-14));
  CHECK_FALSE(beside(0));
}

}  // namespace
}  // namespace touchstone::tests
