// Questions with a separation whose answers a person can work out.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <touchstone/contact_times.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/solve.hpp>

#include "support/catch.hpp"

using namespace touchstone;

namespace {

Query at_rest(Query query) {
  query.end = query.start;
  return query;
}

/// Point p moves along x from x0 to x1 at height y; q rests at the origin.
Query passing_points(double x0, double x1, double y) { return PointPoint{{{{x0, y, 0}, {}}}, {{{x1, y, 0}, {}}}}; }

constexpr Separation kOne = {1, Metric::euclidean};
constexpr Separation kOneMax = {1, Metric::max};

const Method kMethods[] = {Method::fast, Method::exact};

}  // namespace

TEST_CASE("two spheres meet, brush past or miss each other") {
  for (const Method method : kMethods) {
    const Answer head_on = solve(passing_points(-3, 1, 0), {.separation = kOne, .method = method});
    REQUIRE(head_on.contact);
    CHECK(head_on.toi == 0.5);
    CHECK(head_on.toi_upper == 0.5);
    CHECK(head_on.nature == Nature::entering);
    CHECK(head_on.trend == Trend::approaching);
    CHECK_FALSE(head_on.starts_within);
    CHECK(head_on.feature_a == Feature::p);
    CHECK(head_on.feature_b == Feature::q);

    const Answer tangent = solve(passing_points(-2, 2, 1), {.separation = kOne, .method = method});
    REQUIRE(tangent.contact);
    CHECK(tangent.toi == 0.5);
    CHECK(tangent.toi_upper == 0.5);
    CHECK(tangent.nature == Nature::grazing);
    CHECK(tangent.trend == Trend::leaving);
    CHECK_FALSE(solve(passing_points(-2, 2, std::nextafter(1.0, 2.0)), {.separation = kOne, .method = method}).contact);

    // |x|^2 = 1 - 1/4 at x = -2 + 4 t: t = (4 - sqrt(3)) / 8
    const Answer irrational = solve(passing_points(-2, 2, 0.5), {.separation = kOne, .method = method});
    REQUIRE(irrational.contact);
    CHECK(irrational.toi == Approx((4 - std::sqrt(3.0)) / 8).epsilon(1e-15));
    CHECK(irrational.toi_upper == std::nextafter(irrational.toi, 1.0));
    CHECK(irrational.nature == Nature::entering);
  }
}

TEST_CASE("elements at rest within the separation need no exact arithmetic") {
  // The face's plane z = x / 8 + y / 4 is along no axis, so that the closest points are unique in both metrics.
  Query face = VertexFace{{{{0.25, 0.25, 0.75}, {-4, -4, -1.5}, {4, -4, -0.5}, {0, 4, 1}}}, {}};
  face.end = face.start;
  for (const bool moves_along : {false, true}) {
    Query query = face;
    for (Vec3& x : query.end) x.x += moves_along ? 0.125 : 0;
    for (const Separation& separation : {kOne, kOneMax}) {
      const Answer answer = solve(query, {.separation = separation});
      CHECK(answer.level == Level::bracket);
      CHECK(answer.starts_within);
      CHECK(answer.nature == Nature::sustained);
      CHECK(answer.trend == Trend::constant);
      const Answer exact = solve(query, {.separation = separation, .method = Method::exact});
      CHECK(exact.trend == Trend::constant);
      CHECK(exact.feature_b == answer.feature_b);
    }
  }
}

TEST_CASE("elements that start within the separation") {
  for (const Method method : kMethods) {
    for (const bool approaching : {true, false}) {
      const Answer answer =
          solve(passing_points(0.5, approaching ? 0.25 : 1, 0), {.separation = kOne, .method = method});
      REQUIRE(answer.contact);
      CHECK(answer.toi == 0);
      CHECK(answer.starts_within);
      CHECK(answer.nature == Nature::sustained);
      CHECK(answer.trend == (approaching ? Trend::approaching : Trend::leaving));
    }
    const Answer leaves = solve(passing_points(1, 2, 0), {.separation = kOne, .method = method});
    REQUIRE(leaves.contact);
    CHECK(leaves.starts_within);
    CHECK(leaves.nature == Nature::isolated);
    CHECK(leaves.trend == Trend::leaving);
    const Answer enters = solve(passing_points(1, 0, 0), {.separation = kOne, .method = method});
    CHECK(enters.starts_within);
    CHECK(enters.nature == Nature::entering);
    const Answer rests = solve(passing_points(1, 1, 0), {.separation = kOne, .method = method});
    CHECK(rests.starts_within);
    CHECK(rests.nature == Nature::sustained);
    CHECK(rests.trend == Trend::constant);
  }
}

TEST_CASE("a point comes down on a face, beside its edge and beside its corner") {
  const auto falling = [](double x, double y) {
    return VertexFace{{{{x, y, 3}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{x, y, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};
  };
  for (const Method method : kMethods) {
    const Answer inside = solve(falling(1, 1), {.separation = kOne, .method = method});
    REQUIRE(inside.contact);
    CHECK(inside.toi == 0.5);
    CHECK(inside.feature_b == Feature::f);
    CHECK(inside.weights_b == std::array<double, 3>{0.5, 0.25, 0.25});

    // At a distance of 0.6 beside the edge f0 f1 the sphere touches the edge at height 0.8.
    const Answer beside = solve(falling(1, -0.6), {.separation = kOne, .method = method});
    REQUIRE(beside.contact);
    CHECK(beside.toi == Approx(0.55).epsilon(1e-15));
    CHECK(beside.feature_b == Feature::f01);
    CHECK(beside.weights_b == std::array<double, 3>{0.75, 0.25, 0});

    const Answer corner = solve(falling(-0.375, -0.5), {.separation = kOne, .method = method});  // 5/8 from the corner
    REQUIRE(corner.contact);
    CHECK(corner.toi == Approx((3 - std::sqrt(1 - 25 / 64.0)) / 4).epsilon(1e-15));
    CHECK(corner.feature_b == Feature::f0);

    CHECK_FALSE(solve(falling(1, -1.0000001), {.separation = kOne, .method = method}).contact);
    const Answer at_border =
        solve(falling(1, -1), {.separation = kOne, .method = method});  // it passes the edge at exactly 1
    REQUIRE(at_border.contact);
    CHECK(at_border.toi == 0.75);
    CHECK(at_border.nature == Nature::grazing);

    // With the other metric the thick face is a prism with flat tops and square borders.
    const Answer flat = solve(falling(1, -0.6), {.separation = kOneMax, .method = method});
    REQUIRE(flat.contact);
    CHECK(flat.toi == 0.5);
    CHECK(flat.nature == Nature::entering);
  }
}

TEST_CASE("two edges: crossing, end to end, parallel") {
  const auto descending = [](Vec3 b0, Vec3 b1) {
    EdgeEdge q = {{{{-1, 0, 0}, {1, 0, 0}, b0, b1}}, {{{-1, 0, 0}, {1, 0, 0}, b0, b1}}};
    q.end[2].z = b0.z - 4;
    q.end[3].z = b1.z - 4;
    return q;
  };
  for (const Method method : kMethods) {
    const Answer crossing = solve(descending({0.5, -1, 3}, {0.5, 3, 3}), {.separation = kOne, .method = method});
    REQUIRE(crossing.contact);
    CHECK(crossing.toi == 0.5);
    CHECK(crossing.feature_a == Feature::a);
    CHECK(crossing.feature_b == Feature::b);
    CHECK(crossing.weights_a == std::array<double, 3>{0.25, 0.75, 0});
    CHECK(crossing.weights_b == std::array<double, 3>{0.75, 0.25, 0});

    const Answer parallel = solve(descending({0, 0, 3}, {3, 0, 3}), {.separation = kOne, .method = method});
    REQUIRE(parallel.contact);
    CHECK(parallel.toi == 0.5);
    CHECK(parallel.feature_a == Feature::overlap);
    CHECK(parallel.feature_b == Feature::overlap);
    CHECK(parallel.weights_a == std::array<double, 3>{0, 1, 0});
    CHECK(parallel.weights_b[1] == Approx(1 / 3.0).epsilon(1e-15));

    const Answer end_to_end = solve(descending({1, 0, 3}, {3, 0, 3}), {.separation = kOne, .method = method});
    REQUIRE(end_to_end.contact);
    CHECK(end_to_end.toi == 0.5);
    CHECK(end_to_end.feature_a == Feature::a1);
    CHECK(end_to_end.feature_b == Feature::b0);
  }
}

TEST_CASE("all times within a separation") {
  // In at x = -1 and out at x = 1, on the way from -2 to 6.
  const auto times = contact_times(passing_points(-2, 6, 0), kOne);
  REQUIRE(times.size() == 1);
  CHECK(times[0].first.compare(0.125) == 0);
  CHECK(times[0].last.compare(0.375) == 0);
  const auto touch = contact_times(passing_points(-2, 2, 1), kOne);
  REQUIRE(touch.size() == 1);
  CHECK(touch[0].first == touch[0].last);
  CHECK(contact_times(passing_points(-2, 2, 1.5), kOne).empty());
}

TEST_CASE("distances at an instant") {
  const Query edges = at_rest(EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 2}, {0.5, 1, 2}}}, {}});
  const Distance apart = distance(edges);
  CHECK(apart.value == 2);
  CHECK(apart.feature_a == Feature::a);
  CHECK(apart.weights_b == std::array<double, 3>{0.5, 0.5, 0});
  CHECK(compare_distance(edges, 0, {2, Metric::euclidean}) == 0);
  CHECK(compare_distance(edges, 0, {std::nextafter(2.0, 3.0), Metric::euclidean}) < 0);
  CHECK(compare_distance(edges, 0, {std::nextafter(2.0, 1.0), Metric::euclidean}) > 0);

  const Query diagonal = at_rest(PointPoint{{{{0, 0, 0}, {1, 1, 0}}}, {}});
  CHECK(distance(diagonal).value == std::sqrt(2.0));
  CHECK(distance(diagonal, 0, Metric::max).value == 1);
  CHECK(compare_distance(diagonal, 0, {std::sqrt(2.0), Metric::euclidean}) < 0);  // sqrt(2.0) is rounded up
  CHECK(distance(at_rest(PointPoint{{{{1, 2, 3}, {1, 2, 3}}}, {}})).value == 0);
  CHECK(distance(at_rest(PointPoint{{{{0x1p-1074, 0, 0}, {0, 0, 0}}}, {}})).value == 0x1p-1074);
  CHECK(std::isinf(distance(at_rest(PointPoint{{{{0x1.8p1023, 0, 0}, {-0x1.8p1023, 0, 0}}}, {}})).value));

  // The square's diagonal through the middle of a triangle at mid-step.
  const Query moving = VertexFace{{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                  {{{0.25, 0.25, 2}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  CHECK(distance(moving, 0.5).value == 1.5);
  CHECK(distance(moving, 0.5).feature_b == Feature::f);

  // Fractions: from 1/3 to 4/3, which no double holds.
  RationalQuery thirds;
  thirds.kind = Kind::point_point;
  for (auto* corners : {&thirds.start, &thirds.end}) (*corners)[1][0] = {"1", "3"};
  thirds.end[1][0] = {"4", "3"};
  CHECK(distance(thirds).value == 1.0 / 3);
  CHECK(distance(thirds, 0.5, Metric::max).value == 5.0 / 6);
  CHECK(compare_distance(thirds, 0, {1.0 / 3, Metric::euclidean}) > 0);  // 1/3 is rounded down
  CHECK(solve(thirds, {.separation = {0.5}, .wanted = Wanted::contact}).contact);
  CHECK(std::isnan(solve(thirds, {.separation = {0.5}, .wanted = Wanted::contact}).toi));
}
