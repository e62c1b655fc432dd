// Queries with a separation in the largest-axis metric that were solved on paper.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "oracle/separated.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr Place kPoints = {Feature::p, Feature::q, kFirst, kFirst};

/// A point flies by another one, which rests at the origin.
Query flight(const Vec3& from, const Vec3& to) { return PointPoint{{{from, {0, 0, 0}}}, {{to, {0, 0, 0}}}}; }

/// A vertex falls from height 3 to 1 over a triangle that rests.
Query over_face(double x, double y, const Vec3& f0, const Vec3& f1, const Vec3& f2) {
  return VertexFace{{{{x, y, 3}, f0, f1, f2}}, {{{x, y, 1}, f0, f1, f2}}};
}

Query over_flat_face(double x, double f0, double f1, double f2) {
  return over_face(x, 0, {f0, 0, 0}, {f1, 0, 0}, {f2, 0, 0});
}

Place on_face(Feature feature, const Weights& weights) { return {Feature::v, feature, kFirst, weights}; }

/// Edge a moves by a vector, edge b rests.
Query edges(const Vec3& a0, const Vec3& a1, const Vec3& by, const Vec3& b0, const Vec3& b1) {
  return moved(EdgeEdge{{{a0, a1, b0, b1}}, {{a0, a1, b0, b1}}}, 0, 2, by);
}

constexpr Separation within(double distance) { return {distance, Metric::max}; }

}  // namespace

TEST_CASE("a point enters a cube around another one") {
  check_separated(flight({-4, 2, 0}, {4, 2, 0}), within(3), at(0.125), kEnters, kPoints);
  check_separated(flight({-4, 0.5, -0.5}, {4, 0.5, -0.5}), within(1), at(0.375), kEnters, kPoints);
  check_no_contact(flight({-4, 2, 0}, {4, 2, 0}), within(std::nextafter(2, 0)));
}

TEST_CASE("a point comes to constant distance on a side of a cube") {
  check_separated(flight({-4, 2, 0}, {4, 2, 0}), within(2), at(0.25), kStays, kPoints);
  check_separated(flight({-1, 2, 0}, {1, 2, 0}), within(2), at(0), {Nature::sustained, Trend::constant, true}, kPoints);
  check_separated(flight({-3, 2, 0}, {3, 2, 0}), within(2), {0x1.5555555555555p-3, 0x1.5555555555556p-3}, kStays,
                  kPoints);
}

TEST_CASE("a point touches an edge of a cube") {
  // (1 + s, 1 - s, 0) for s from -1/2 to 1/2: the distance is 1 + |s|.
  const Query query = flight({0.5, 1.5, 0}, {1.5, 0.5, 0});
  check_separated(query, within(1), at(0.5), kGrazes, kPoints);
  check_no_contact(query, within(std::nextafter(1, 0)));
  check_separated(query, within(1.25), at(0.25), kEnters, kPoints);
  check_separated(query, within(1.5), at(0), {Nature::entering, Trend::approaching, true}, kPoints);
  check_separated(query, within(2), at(0), {Nature::sustained, Trend::approaching, true}, kPoints);
}

TEST_CASE("distances from a cube that fall, stay and rise at the start") {
  check_separated(flight({0, 3, 0}, {0, 4, 0}), within(3), at(0), {Nature::isolated, Trend::leaving, true}, kPoints);
  check_separated(flight({0, 3, 0}, {0, 4, 0}), within(3), at(0), {Nature::isolated, Trend::leaving, true}, kPoints, 0);
  check_separated(flight({1, 1, 0}, {2, 0, 0}), within(1), at(0), {Nature::grazing, Trend::leaving, true}, kPoints);
  check_separated(flight({0, 1, 0}, {0, 2, 0}), within(3), at(0), {Nature::sustained, Trend::leaving, true}, kPoints);
  check_separated(flight({0, 1, 0}, {1, 1, 0}), within(3), at(0), {Nature::sustained, Trend::constant, true}, kPoints);
  check_separated(flight({0, 0, 0}, {1, 1, 0}), within(3), at(0), {Nature::sustained, Trend::leaving, true}, kPoints);
}

TEST_CASE("a cube meets a slanted face with its corner") {
  // The plane x + y + z = 0 and the vertex (c, c, c), c from 3 to 1: the distance is c, at the origin only.
  const Query query = VertexFace{{{{3, 3, 3}, {6, -3, -3}, {-3, 6, -3}, {-3, -3, 6}}},
                                 {{{1, 1, 1}, {6, -3, -3}, {-3, 6, -3}, {-3, -3, 6}}}};
  check_separated(query, within(2), at(0.5), kEnters, on_face(Feature::f, {1.0 / 3, 1.0 / 3, 1.0 / 3}));
}

TEST_CASE("of the closest points of a face the one with the smallest weights is told") {
  // They are those of a square with side 4 around (x, y).
  const auto wide = [](double x, double y) { return over_face(x, y, {-8, -8, 0}, {16, -8, 0}, {-8, 16, 0}); };
  check_separated(wide(0, 0), within(2), at(0.5), kEnters, on_face(Feature::f, {1.0 / 6, 5.0 / 12, 5.0 / 12}));
  // The square has the part from (2, 6) to (6, 2) of the side f1 f2, and (2, 6) has the smaller weight of f1.
  check_separated(wide(4, 4), within(2), at(0.5), kEnters, on_face(Feature::f12, {0, 10.0 / 24, 14.0 / 24}));
  check_separated(wide(-7, 15), within(2), at(0.5), kEnters, on_face(Feature::f2, kThird));
  check_separated(wide(-9, 0), within(2), at(0.5), kEnters,
                  on_face(Feature::f, {1 - 1.0 / 24 - 10.0 / 24, 1.0 / 24, 10.0 / 24}));
  check_separated(wide(-10, 0), within(2), at(0.5), kStays, on_face(Feature::f20, {14.0 / 24, 0, 10.0 / 24}));
}

TEST_CASE("of the closest points of edges the ones with the smallest weights are told") {
  check_separated(edges({-2, 0, 2}, {2, 0, 2}, {0, 0, -2}, {0, -2, 0}, {0, 2, 0}), within(1), at(0.5), kEnters,
                  {Feature::a, Feature::b, {0.25, 0.75, 0}, {0.25, 0.75, 0}});
  // Parallel: every pair of points whose x differ by at most 2.
  check_separated(edges({0, 3, 0}, {4, 3, 0}, {0, -2, 0}, {1, 0, 0}, {3, 0, 0}), within(2), at(0.5), kEnters,
                  {Feature::a1, Feature::b1, kSecond, kSecond});
  check_separated(edges({0, 3, 0}, {8, 3, 0}, {0, -2, 0}, {1, 0, 0}, {3, 0, 0}), within(2), at(0.5), kEnters,
                  {Feature::a, Feature::b1, {0.375, 0.625, 0}, kSecond});
  check_separated(edges({0, 3, 0}, {8, 3, 0}, {0, -2, 0}, {3, 0, 0}, {1, 0, 0}), within(2), at(0.5), kEnters,
                  {Feature::a, Feature::b0, {0.375, 0.625, 0}, kFirst});
}

TEST_CASE("edges without a length are their first corners in the largest-axis metric too") {
  const Vec3 down = {0, 0, -2};
  check_separated(edges({1, 0, 2}, {1, 0, 2}, down, {0, 0, 0}, {4, 0, 0}), within(1), at(0.5), kEnters,
                  {Feature::a0, Feature::b, kFirst, {0.5, 0.5, 0}});
  check_separated(edges({0, 0, 2}, {4, 0, 2}, down, {1, 0, 0}, {1, 0, 0}), within(1), at(0.5), kEnters,
                  {Feature::a, Feature::b0, {0.5, 0.5, 0}, kFirst});
  check_separated(edges({0, 0, 2}, {0, 0, 2}, down, {0, 0, 0}, {0, 0, 0}), within(1), at(0.5), kEnters,
                  {Feature::a0, Feature::b0, kFirst, kFirst});
  const Query shrinking =
      EdgeEdge{{{{-1, 0, 2}, {1, 0, 2}, {-4, 0, 0}, {4, 0, 0}}}, {{{1, 0, 0}, {-1, 0, 0}, {-4, 0, 0}, {4, 0, 0}}}};
  check_separated(shrinking, within(1), at(0.5), kEnters, {Feature::a0, Feature::b, kFirst, {0.375, 0.625, 0}});
}

TEST_CASE("of a flat triangle the first feature that holds closest points counts") {
  const auto check = [](const Query& query, Feature feature, const Weights& weights) {
    check_separated(query, within(2), at(0.5), kEnters, on_face(feature, weights));
  };
  check(over_flat_face(3, 0, 8, 4), Feature::f2, kThird);                   // 1 <= x <= 5, with f2
  check(over_flat_face(1, 0, 8, 4), Feature::f0, kFirst);                   // 0 <= x <= 3, with f0
  check(over_flat_face(7, 0, 8, 4), Feature::f1, kSecond);                  // 5 <= x <= 8, with f1
  check(over_flat_face(3, 4, 0, 8), Feature::f0, kFirst);                   // 1 <= x <= 5, both sides of f0
  check(over_flat_face(1, 4, 0, 8), Feature::f1, kSecond);                  // 0 <= x <= 3, with f1
  check(over_flat_face(2.5, 8, 0, 16), Feature::f01, {0.0625, 0.9375, 0});  // 0.5 <= x <= 4.5
  check(over_flat_face(3, 0, 8, 8), Feature::f01, {0.375, 0.625, 0});       // f1 and f2 at one place
  check(over_flat_face(7, 0, 8, 8), Feature::f1, kSecond);
  check(over_flat_face(3, 0, 0, 8), Feature::f12, {0, 0.375, 0.625});  // f0 and f1 at one place
  check_separated(over_flat_face(-2, 0, 0, 8), within(2), at(0.5), kStays, on_face(Feature::f0, kFirst));
  check(over_flat_face(3, 0, 8, 0), Feature::f01, {0.375, 0.625, 0});  // f0 and f2 at one place
  check(over_flat_face(0, 0, 0, 0), Feature::f0, kFirst);
}

TEST_CASE("a point comes near an edge in the largest-axis metric") {
  const auto falling = [](double x, double e0, double e1) {
    return Query(PointEdge{{{{x, 0, 3}, {e0, 0, 0}, {e1, 0, 0}}}, {{{x, 0, 1}, {e0, 0, 0}, {e1, 0, 0}}}});
  };
  check_separated(falling(0, -8, 8), within(2), at(0.5), kEnters, {Feature::p, Feature::e, kFirst, {0.375, 0.625, 0}});
  check_separated(falling(0, 8, -8), within(2), at(0.5), kEnters, {Feature::p, Feature::e, kFirst, {0.375, 0.625, 0}});
  check_separated(falling(0, -8, 1), within(2), at(0.5), kEnters, {Feature::p, Feature::e1, kFirst, kSecond});
  check_separated(falling(-2, 0, 1), within(2), at(0.5), kStays, {Feature::p, Feature::e0, kFirst, kFirst});
  check_separated(falling(0, 1, 1), within(2), at(0.5), kEnters, {Feature::p, Feature::e0, kFirst, kFirst});
  check_no_contact(falling(-3, 0, 1), within(2));
}

TEST_CASE("edges whose common normal is no axis") {
  // The edges' directions are (1, -1, 0) and (0, 1, -1), so n = (1, 1, 1). Edge a passes through (c, c, c), c from 3
  // to 1, and edge b through the origin. The distance is |n . r| / (1 + 1 + 1) = c, for the middles of both edges only.
  const Query query =
      EdgeEdge{{{{2, 4, 3}, {4, 2, 3}, {0, -1, 1}, {0, 1, -1}}}, {{{0, 2, 1}, {2, 0, 1}, {0, -1, 1}, {0, 1, -1}}}};
  check_separated(query, within(2), at(0.5), kEnters, {Feature::a, Feature::b, {0.5, 0.5, 0}, {0.5, 0.5, 0}});
}
