// How the time of the first contact changes with the corners: rational gradients, differences, and laws.
// SPDX-License-Identifier: MIT
#include <touchstone/toi_gradient.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "separation/distances.hpp"
#include "separation/rational_gradients.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

double& coordinate_of(Vec3& v, std::size_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

/// Elements of small integers that meet at an eighth of the step.
Query meeting_at_an_eighth(Rng& rng, int eighth) {
  Query query;
  query.kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
  const auto small = [&] { return Vec3{rng.between(-8, 8) * 1.0, rng.between(-8, 8) * 1.0, rng.between(-8, 8) * 1.0}; };
  const auto sum = [](const Vec3& a, double f, const Vec3& b) {
    return Vec3{a.x + f * b.x, a.y + f * b.y, a.z + f * b.z};
  };
  std::array<Vec3, 4> at = {small(), small(), small(), small()};
  if (query.kind == Kind::edge_edge) {  // both go through the point 0.25 a0 + 0.75 a1
    const Vec3 foot = sum(at[0], 0.75, sum(at[1], -1, at[0]));
    at[3] = sum(foot, 3, sum(foot, -1, at[2]));
  } else {
    at[0] = sum(sum(at[1], 0.25, sum(at[2], -1, at[1])), 0.5, sum(at[3], -1, at[1]));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 way = small();
    query.start[i] = sum(at[i], -eighth / 8.0, way);
    query.end[i] = sum(at[i], 1 - eighth / 8.0, way);
  }
  return query;
}

}  // namespace

TEST_CASE("the gradient of a point that falls on a face is known") {
  // It is at 3 above the face at t = 0, and at -1 at t = 1: T = 3/4.
  const Query query =
      VertexFace{{{{1, 1, 3}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, -1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};
  const ToiGradient gradient = toi_gradient(query);
  REQUIRE(gradient.exists);
  CHECK(gradient.start[0].z == 0.0625);  // 1 / 4^2, the derivative of z0 / (z0 - z1)
  CHECK(gradient.end[0].z == 0.1875);    // 3 / 4^2
  CHECK(gradient.start[1].z == -0.03125);
  CHECK(gradient.start[2].z == -0.015625);
  CHECK(gradient.end[3].z == -0.046875);
  for (const auto* side : {&gradient.start, &gradient.end}) {
    for (const Vec3& g : *side) CHECK((g.x == 0 && g.y == 0));
  }
  const ToiGradient apart = toi_gradient(query, {0.5, Metric::euclidean});
  REQUIRE(apart.exists);
  CHECK(apart.start[0].z == 0.09375);  // T = 5/8: (1 - T) / 4
  CHECK(apart.end[0].z == 0.15625);
}

TEST_CASE("gradients of times that are doubles are the rational ones, or a double beside them") {
  std::size_t judged = 0;
  for (std::size_t i = 0; i < effort(3000); ++i) {
    Rng rng(seeded::seed_of_stream(395, i));
    const int eighth = rng.between(1, 8);
    const Query query = meeting_at_an_eighth(rng, eighth);
    const Answer answer = solve(query);
    CAPTURE(i, cpp_initializer(query));
    REQUIRE(answer.contact);
    const ToiGradient gradient = toi_gradient(query);
    if (!gradient.exists) {
      CHECK(is_zero(gradient));
      continue;
    }
    if (answer.toi != answer.toi_upper) continue;
    ++judged;
    const std::optional<RationalGradient> truth = rational_gradient(query, Rational(answer.toi));
    REQUIRE(truth);
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(is_beside(coordinate(gradient.start[c], k), truth->start[c][k]));
        REQUIRE(is_beside(coordinate(gradient.end[c], k), truth->end[c][k]));
      }
    }
  }
  CAPTURE(judged);
  CHECK(4 * judged > effort(3000));
}

TEST_CASE("gradients of other times are within a double, too") {
  std::size_t judged = 0;
  for (std::size_t i = 0; i < effort(3000); ++i) {
    Rng rng(seeded::seed_of_stream(397, i));
    Query query;
    query.kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
    const double speed = rng.one_in(3) ? std::ldexp(1.0, -rng.between(0, 40)) : 1;
    for (std::size_t c = 0; c < 4; ++c) {
      query.start[c] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
      query.end[c] = {query.start[c].x + speed * rng.symmetric(), query.start[c].y + speed * rng.symmetric(),
                      query.start[c].z + speed * rng.symmetric()};
    }
    const ToiGradient gradient = toi_gradient(query);
    const Answer answer = solve(query);
    if (!gradient.exists || answer.toi == answer.toi_upper) continue;
    ++judged;
    CAPTURE(i, cpp_initializer(query));
    const std::optional<Rational> time = plane_time(query, answer.toi, answer.toi_upper);
    REQUIRE(time);
    const std::optional<RationalGradient> truth = rational_gradient(query, *time);
    REQUIRE(truth);
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(is_beside(coordinate(gradient.start[c], k), truth->start[c][k]));
        REQUIRE(is_beside(coordinate(gradient.end[c], k), truth->end[c][k]));
      }
    }
  }
  CAPTURE(judged);
  CHECK((20 * judged > effort(3000) || !whole_effort("how many gradients of other times are judged")));
}

TEST_CASE("gradients are the differences of times, with a separation too, and moving all corners changes nothing") {
  std::size_t compared = 0;
  for (std::size_t i = 0; i < effort(1500); ++i) {
    Rng rng(seeded::seed_of_stream(396, i));
    Query query;
    query.kind = rng.pick(kKinds);
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
      query.start[c] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
      query.end[c] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
    }
    Separation separation;
    if (rng.one_in(2)) separation.distance = interesting_distance(query, Metric::euclidean, rng);
    CAPTURE(i, separation.distance, cpp_initializer(query));
    const ToiGradient gradient = toi_gradient(query, separation);
    const Answer answer = solve(query, {.separation = separation});
    if (!gradient.exists) {
      CHECK(is_zero(gradient));
      continue;
    }
    REQUIRE(answer.contact);
    const double size = greatest(gradient);
    Vec3 sum = {0, 0, 0}, sum_at_end = {0, 0, 0};
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
      const Vec3 &a = gradient.start[c], &b = gradient.end[c];
      sum = {sum.x + a.x, sum.y + a.y, sum.z + a.z};
      sum_at_end = {sum_at_end.x + b.x, sum_at_end.y + b.y, sum_at_end.z + b.z};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(std::fabs(coordinate(sum, k)) <= 0x1p-50 * size);
      REQUIRE(std::fabs(coordinate(sum_at_end, k)) <= 0x1p-50 * size);
    }
    // One coordinate a little less and more. The third derivative counts where two elements hardly meet.
    const std::size_t corner = rng.below(corner_count(query.kind)), axis = rng.below(3);
    const bool of_end = rng.one_in(2);
    const double step = 0x1p-22;
    std::array<double, 2> times{};
    bool both = true;
    for (const int sign : {-1, 1}) {
      Query moved = query;
      coordinate_of((of_end ? moved.end : moved.start)[corner], axis) += sign * step;
      const Answer later = solve(moved, {.separation = separation});
      both = both && later.contact;
      times[sign < 0 ? 0 : 1] = later.toi;
    }
    // Beyond the ends of the step a time does not go on, and another contact may begin before the start.
    const auto [least, most] = std::minmax(times[0], times[1]);
    if (!both || size > 20 || least < 1e-3 || most > 1 - 1e-3) continue;
    ++compared;
    const double found = coordinate((of_end ? gradient.end : gradient.start)[corner], axis);
    const double by_times = (times[1] - times[0]) / (2 * step);
    CAPTURE(corner, axis, of_end, size, found, by_times);
    CHECK(std::fabs(by_times - found) <= 1e-8 * std::pow(1 + size, 5));
  }
  CAPTURE(compared);
  CHECK((compared > effort(1500) / 8 || !whole_effort("how many differences are compared")));
}

TEST_CASE("there is no gradient without a contact, at the start, at a border, or where elements only touch") {
  const auto none = [](const Query& query, const Separation& separation = {}) {
    const ToiGradient gradient = toi_gradient(query, separation);
    CHECK_FALSE(gradient.exists);
    CHECK(is_zero(gradient));
  };
  const auto falling = [](double x, double y, double from, double to) {
    return Query(
        VertexFace{{{{x, y, from}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{x, y, to}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  };
  none(falling(1, 1, 3, 1));                                                   // no contact
  none(falling(1, 1, 0, -1));                                                  // at the start
  none(falling(2, 0, 3, -1));                                                  // on an edge
  none(falling(0, 0, 3, -1));                                                  // on a corner
  CHECK(toi_gradient(falling(2, 0, 3, -1), {0.5, Metric::euclidean}).exists);  // its distance has a gradient there
  none(Query(PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{2, 0, 0}, {1, 0, 0}}}}));
  CHECK(toi_gradient(Query(PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{2, 0, 0}, {1, 0, 0}}}}), {0.5, Metric::euclidean})
            .start[0]
            .x == -0.375);  // T = 1/4
  // A point that passes another one at exactly the separation.
  none(Query(PointPoint{{{{-1, 1, 0}, {0, 0, 0}}}, {{{1, 1, 0}, {0, 0, 0}}}}), {1, Metric::euclidean});
  // Parallel edges.
  const Query parallel =
      EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 2}, {2, 0, 2}}}, {{{0, 0, 0}, {1, 0, 0}, {0.5, 0, -2}, {2, 0, -2}}}};
  none(parallel);
  none(parallel, {0.5, Metric::euclidean});
  CHECK_THROWS_AS(toi_gradient(parallel, {0.5, Metric::max}), InvalidQuery);
  CHECK_THROWS_AS(toi_gradient(parallel, {}, 2), InvalidQuery);
}

TEST_CASE("with a separation there is no gradient where an edge has no length or a face no area") {
  const auto exists = [](const Query& query) { return toi_gradient(query, {1}).exists; };
  const std::array<Vec3, 3> edge = {{{0, 0, 5}, {-1, 0, 0}, {1, 0, 0}}};
  const auto point_edge = [](const std::array<Vec3, 3>& start, const std::array<Vec3, 3>& end) {
    Query query;
    query.kind = Kind::point_edge;
    std::copy(start.begin(), start.end(), query.start.begin());
    std::copy(end.begin(), end.end(), query.end.begin());
    return query;
  };
  CHECK(exists(point_edge(edge, {{{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}}})));
  CHECK_FALSE(exists(point_edge({{{0, 0, 5}, {0, 0, 0}, {0, 0, 0}}}, {})));
  // It has no length at the time 4/5 alone.
  CHECK_FALSE(exists(point_edge({{{0, 0, 5}, {-4, 0, 0}, {4, 0, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}}})));
  const std::array<Vec3, 3> face = {{{-1, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}},
                            bent = {{{-1, 0, 0}, {1, 0, 0}, {0.5, 1, 0}}};
  const auto falling = [](const std::array<Vec3, 3>& f) {
    return Query(VertexFace{{{{0, 0.25, 5}, f[0], f[1], f[2]}}, {{{0, 0.25, 0}, f[0], f[1], f[2]}}});
  };
  CHECK_FALSE(exists(falling(face)));
  CHECK(exists(falling(bent)));
  const auto edges = [](const Vec3& a0, const Vec3& a1) {
    const auto down = [](Vec3 x) { return Vec3{x.x, x.y, x.z - 5}; };
    return Query(EdgeEdge{{{a0, a1, {-1, 0, 0}, {1, 0, 0}}}, {{down(a0), down(a1), {-1, 0, 0}, {1, 0, 0}}}});
  };
  CHECK(exists(edges({0, -1, 5}, {0, 1, 5})));
  CHECK_FALSE(exists(edges({0, 0, 5}, {0, 0, 5})));
}

TEST_CASE("gradients of any size are found") {
  for (const double size : {0x1p-500, 0x1p-60, 0x1p60, 0x1p500}) {
    const Query query = VertexFace{{{{size, size, 3 * size}, {0, 0, 0}, {4 * size, 0, 0}, {0, 4 * size, 0}}},
                                   {{{size, size, -size}, {0, 0, 0}, {4 * size, 0, 0}, {0, 4 * size, 0}}}};
    const ToiGradient gradient = toi_gradient(query);
    REQUIRE(gradient.exists);
    CHECK(gradient.start[0].z == 0.0625 / size);
  }
}
