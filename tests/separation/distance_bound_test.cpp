// The bounds of a distance in doubles are above and below the distance, and not far from it: searches, judged by the
// exact level.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>

#include "filters/separation/distance_bound.hpp"
#include "filters/separation/precise_distance.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/exact_comparison.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using touchstone::tests::effort;
using touchstone::tests::exact_distance;
using touchstone::tests::exactly_compared;

namespace {

Vec3 sum(const Vec3& a, double by, const Vec3& b) { return {a.x + by * b.x, a.y + by * b.y, a.z + by * b.z}; }

Vec3 random_vector(seeded::Rng& random) { return {random.symmetric(), random.symmetric(), random.symmetric()}; }

/// Elements that are far apart or near, large or small beside their distance, and nearly parallel or flat.
Query random_pair(seeded::Rng& random) {
  Query query;
  query.kind = random.pick(kKinds);
  const auto scale = [&](int low, int high) { return std::ldexp(1.0, random.between(low, high)); };
  const Vec3 along = random_vector(random), across = random_vector(random), apart = random_vector(random);
  const double gap = scale(-30, 2), bent = random.one_in(2) ? scale(-30, 0) : 1,
               far = random.one_in(2) ? scale(0, 20) : 0;
  const std::size_t first = query.kind == Kind::edge_edge ? 2 : 1;
  for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
    Vec3 at = sum({}, random.symmetric(), along);
    at = sum(at, bent * random.symmetric(), random.one_in(2) ? across : random_vector(random));
    if (c < first) at = sum(at, gap, apart);
    at = sum(at, far, Vec3{1, -2, 0.75});
    query.start[c] = at;
  }
  if (random.one_in(4)) query.start[0] = sum(query.start[1], gap, apart);
  const double size = scale(-140, 140);
  for (Vec3& x : query.start) x = {size * x.x, size * x.y, size * x.z};
  query.end = query.start;
  return query;
}

}  // namespace

TEST_CASE("the bound of a distance is above it, and by at most 2^-20 of it") {
  seeded::Rng random(3811);
  std::array<std::size_t, 4> bounded{}, asked{};
  for (std::size_t round = 0; round < effort(40000); ++round) {
    const Query query = random_pair(random);
    const auto kind = static_cast<std::size_t>(query.kind);
    ++asked[kind];
    const auto bound = filters::distance_bound(query, 0);
    if (!bound) continue;
    ++bounded[kind];
    CAPTURE(round, name_of(query.kind), *bound, distance(query, 0).value);
    REQUIRE(exactly_compared(query, 0, {*bound}) <= 0);
    REQUIRE(exactly_compared(query, 0, {*bound * (1 - filters::kLoosestBound)}) >= 0);
  }
  for (const Kind kind : kKinds) {
    const auto k = static_cast<std::size_t>(kind);
    CAPTURE(name_of(kind), bounded[k], asked[k]);
    CHECK(2 * bounded[k] > asked[k]);
  }
}

TEST_CASE("there is no bound of a distance of touching elements, or of sizes without squares") {
  Query query;
  query.start = query.end = {{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}, {0.5, 1, 0}}};
  CHECK_FALSE(filters::distance_bound(query, 0));
  CHECK(distance_upper_bound(query) == 0);
  query.kind = Kind::point_point;
  query.start = query.end = {{{1, 2, 3}, {1, 2, 3}, {}, {}}};
  CHECK_FALSE(filters::distance_bound(query, 0));
  query.kind = Kind::vertex_face;
  for (const double size : {0x1p-1074, 1e-200, 1e200, 1e308}) {
    query.start = query.end = {{{0, 0, size}, {0, 0, 0}, {size, 0, 0}, {0, size, 0}}};
    CHECK_FALSE(filters::distance_bound(query, 0));
    CHECK(distance_upper_bound(query) == std::nextafter(size, INFINITY));
  }
  query.start[0].z = -DBL_MAX;
  query.start[1].z = query.start[2].z = query.start[3].z = DBL_MAX;
  CHECK(distance_upper_bound(query) == INFINITY);
  CHECK_THROWS_AS(distance_upper_bound(query, 2), InvalidQuery);
}

TEST_CASE("distances are compared in doubles as they are compared exactly, at all times and in both metrics") {
  seeded::Rng random(3813);
  std::array<std::size_t, 4> quick{}, asked{};
  for (std::size_t round = 0; round < effort(40000); ++round) {
    Query query = random_pair(random);
    const double size = std::fabs(query.start[0].x - query.start[1].x);
    const double way = random.one_in(4) ? 0 : size * std::ldexp(1.0, random.between(-30, 30));
    for (Vec3& x : query.end) x = sum(x, way, random_vector(random));
    if (random.one_in(2)) std::swap(query.start, query.end);
    const double time = random.pick(std::array{0.0, 1.0, 0.5, std::fabs(random.symmetric())});
    const Metric metric = random.pick(std::array{Metric::euclidean, Metric::max});
    const double away = random.one_in(2) ? random.symmetric() : std::ldexp(random.symmetric(), -random.between(1, 53));
    const Separation separation{distance(query, time, metric).value * (1 + away), metric};
    const int side = exactly_compared(query, time, separation);
    CAPTURE(round, name_of(query.kind), time, separation.distance, name_of(metric));
    REQUIRE(compare_distance(query, time, separation) == side);
    const double most = distance_upper_bound(query, time);
    REQUIRE(exactly_compared(query, time, {most}) <= 0);
    REQUIRE(exactly_compared(query, time, {most * (1 - 0x1p-20)}) >= 0);
    const int found = filters::side_of_distance(query, time, separation);
    if (found != 0) REQUIRE(found == side);
    if (std::fabs(away) < 0.5 || metric == Metric::max) continue;
    ++asked[static_cast<std::size_t>(query.kind)];
    quick[static_cast<std::size_t>(query.kind)] += found != 0;
  }
  for (const Kind kind : kKinds) {
    const auto k = static_cast<std::size_t>(kind);
    CAPTURE(name_of(kind), quick[k], asked[k]);
    CHECK(2 * quick[k] > asked[k]);
  }
}

TEST_CASE("distances in double-doubles are the exact ones, at all times and in both metrics") {
  seeded::Rng random(3814);
  std::array<std::size_t, 2> told{}, compared{}, asked{};
  for (std::size_t round = 0; round < effort(40000); ++round) {
    Query query = random_pair(random);
    const double size = std::fabs(query.start[0].x - query.start[1].x);
    const double way = random.one_in(3) ? 0 : size * std::ldexp(1.0, random.between(-30, 30));
    for (Vec3& x : query.end) x = sum(x, way, random_vector(random));
    const double time = random.pick(std::array{0.0, 1.0, 0.5, std::fabs(random.symmetric())});
    const Metric metric = random.pick(std::array{Metric::euclidean, Metric::max});
    const Distance exact = exact_distance(query, time, metric);
    CAPTURE(round, name_of(query.kind), time, exact.value, name_of(metric));
    ++asked[static_cast<std::size_t>(metric)];
    for (const double level : {std::nextafter(exact.value, 0), exact.value, std::nextafter(exact.value, INFINITY)}) {
      const int side = filters::precise_side_of_distance(query, time, {level, metric});
      if (side == 0) continue;
      REQUIRE(side == exactly_compared(query, time, {level, metric}));
      ++compared[static_cast<std::size_t>(metric)];
    }
    const auto found = filters::precise_distance(query, time, metric);
    if (!found) continue;
    ++told[static_cast<std::size_t>(metric)];
    REQUIRE(found->value == exact.value);
    REQUIRE(found->feature_a == exact.feature_a);
    REQUIRE(found->feature_b == exact.feature_b);
    for (std::size_t i = 0; i < 3; ++i) {
      REQUIRE(std::fabs(found->weights_a[i] - exact.weights_a[i]) <= 0x1p-49);  // each is within 2^-50
      REQUIRE(std::fabs(found->weights_b[i] - exact.weights_b[i]) <= 0x1p-49);
    }
  }
  CAPTURE(told, compared, asked);
  for (std::size_t m = 0; m < 2; ++m) {
    CHECK(4 * told[m] > 3 * asked[m]);
    CHECK(3 * compared[m] > 4 * asked[m]);  // of three levels
  }
}

TEST_CASE("a distance between two doubles is rounded to the even one") {
  Query query;
  query.kind = Kind::point_point;
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    for (const bool odd : {false, true}) {
      // 1 + 2^-53, and a 2^-52 more.
      query.start = query.end = {Vec3{odd ? 1 + 0x1p-52 : 1, 0, 0}, {-0x1p-53, 0, 0}};
      CHECK_FALSE(filters::precise_distance(query, 0, metric));
      CHECK(distance(query, 0, metric).value == (odd ? 1 + 0x1p-51 : 1));
    }
  }
}

TEST_CASE("a least distance is below the distance at all times, and not far below for elements that hardly move") {
  seeded::Rng random(3812);
  std::size_t close = 0, asked = 0;
  for (std::size_t round = 0; round < effort(40000); ++round) {
    Query query = random_pair(random);
    const double size = std::fabs(query.start[0].x - query.start[1].x);
    const bool at_rest = random.one_in(2);
    const double way = at_rest ? 0 : size * std::ldexp(1.0, random.between(-30, 2));
    for (Vec3& x : query.end) x = sum(x, way, random_vector(random));
    if (random.one_in(2)) std::swap(query.start, query.end);
    const double least = filters::least_distance(query);
    CAPTURE(round, name_of(query.kind), least);
    REQUIRE(least >= 0);
    if (least == 0) continue;
    const double time = random.pick(std::array{0.0, 1.0, 0.5, std::fabs(random.symmetric())});
    REQUIRE(exactly_compared(query, time, {least}) >= 0);
    if (!at_rest) continue;
    ++asked;
    close += exactly_compared(query, 0, {least * (1 + 0x1p-20)}) <= 0;
  }
  CAPTURE(close, asked);
  CHECK(2 * close > asked);
}

TEST_CASE("there is no least distance of elements that meet on their way, or of sizes without squares") {
  Query query;
  query.kind = Kind::vertex_face;
  query.start = query.end = {{{0.25, 0.25, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(filters::least_distance(query) > 0.999);
  query.end[0].z = 1;
  CHECK(filters::least_distance(query) == 0);
  query.kind = Kind::point_point;
  for (const double size : {1e-200, 1e200, 1e308}) {
    query.start = query.end = {{{0, 0, size}}};
    CHECK(filters::least_distance(query) == 0);
  }
}
