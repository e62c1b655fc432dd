// Queries with a separation in the Euclidean metric that were solved on paper.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "oracle/separated.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr Place kPoints = {Feature::p, Feature::q, kFirst, kFirst};

/// A point flies by another one, which rests at the origin.
Query flight(const Vec3& from, const Vec3& to) { return PointPoint{{{from, {0, 0, 0}}}, {{to, {0, 0, 0}}}}; }

/// A vertex moves over the triangle (0, 0), (4, 0), (0, 4) in the plane z = 0.
Query over_face(const Vec3& from, const Vec3& to) {
  return VertexFace{{{from, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{to, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};
}

Place on_face(Feature feature, const Weights& weights) { return {Feature::v, feature, kFirst, weights}; }

/// Edge a moves by a vector, edge b rests.
Query edges(const Vec3& a0, const Vec3& a1, const Vec3& by, const Vec3& b0, const Vec3& b1) {
  return moved(EdgeEdge{{{a0, a1, b0, b1}}, {{a0, a1, b0, b1}}}, 0, 2, by);
}

/// A vertex falls from height 3 to -1 over a triangle on the x axis.
Query over_flat_face(double x, double f0, double f1, double f2) {
  return VertexFace{{{{x, 0, 3}, {f0, 0, 0}, {f1, 0, 0}, {f2, 0, 0}}},
                    {{{x, 0, -1}, {f0, 0, 0}, {f1, 0, 0}, {f2, 0, 0}}}};
}

constexpr Separation within(double distance) { return {distance, Metric::euclidean}; }

}  // namespace

TEST_CASE("a point enters a sphere around another one") {
  check_separated(flight({-4, 0, 0}, {4, 0, 0}), within(1), at(0.375), kEnters, kPoints);
  check_separated(flight({-4, 1, 0}, {4, 1, 0}), within(1.25), at(0x1.ap-2), kEnters, kPoints);
  check_separated(flight({-2, 0, 0}, {-1, 0, 0}), within(1), at(1), kEnters, kPoints);
  check_no_contact(flight({-2, 0, 0}, {-1, 0, 0}), within(std::nextafter(1, 0)));
  check_no_contact(flight({-2, 0, 0}, {-1, 0, 0}), within(1), std::nextafter(1, 0));
}

TEST_CASE("an irrational time on a sphere") {
  // 4 (1 - t)^2 + 1/4 = 9/4 at t = 1 - sqrt(1/2).
  check_separated(flight({-2, 0.5, 0}, {0, 0.5, 0}), within(1.5), {0x1.2bec333018866p-2, 0x1.2bec333018867p-2}, kEnters,
                  kPoints);
}

TEST_CASE("a point touches a sphere from outside and one that is larger by the least amount") {
  const Query tangent = flight({-4, 3, 0}, {4, 3, 0});
  check_separated(tangent, within(3), at(0.5), kGrazes, kPoints);
  check_no_contact(tangent, within(std::nextafter(3, 0)));
  const Answer inside = oracle::decide_by_oracle(tangent, 1, within(std::nextafter(3, 4)));
  CHECK(inside.nature == Nature::entering);
  // 8 (1/2 - t) = sqrt((3 + 2^-51)^2 - 9)
  CHECK(std::abs(0.5 - inside.toi - std::sqrt(6 * 0x1p-51) / 8) < 0x1p-52);
}

TEST_CASE("a sphere is touched at a time that is not a double") {
  check_separated(flight({-1, 3, 0}, {2, 3, 0}), within(3), kOneThird, kGrazes, kPoints);
  check_separated(flight({-1, 3, 4}, {2, 3, 4}), within(5), kOneThird, kGrazes, kPoints);
}

TEST_CASE("a separation is touched at an irrational time") {
  // The edge is on the line through the origin along (1, t), and the point is at (t, -145/64). Their squared distance
  // is (t^2 + 145/64)^2 / (1 + t^2), which is (9/4)^2 + (t^2 - 17/64)^2 / (1 + t^2). At t^2 = 17/64 the foot is at
  // -t (1, t).
  const Query query =
      PointEdge{{{{0, -2.265625, 0}, {-8, 0, 0}, {8, 0, 0}}}, {{{1, -2.265625, 0}, {-8, -8, 0}, {8, 8, 0}}}};
  const double t = std::sqrt(17.0) / 8;
  check_separated(query, within(2.25), {0x1.07e0f66afed06p-1, 0x1.07e0f66afed07p-1}, kGrazes,
                  {Feature::p, Feature::e, kFirst, {0.5 + t / 16, 0.5 - t / 16, 0}});
  check_no_contact(query, within(std::nextafter(2.25, 0)));
  const Answer inside = oracle::decide_by_oracle(query, 1, within(std::nextafter(2.25, 3)));
  CHECK(inside.nature == Nature::entering);
  CHECK(inside.toi < t);
}

TEST_CASE("distances that fall, stay and rise at the start") {
  const Vec3 at_distance = {0, 3, 0};
  check_separated(flight(at_distance, {0, 1, 0}), within(3), at(0), {Nature::entering, Trend::approaching, true},
                  kPoints);
  check_separated(flight(at_distance, {8, 3, 0}), within(3), at(0), {Nature::grazing, Trend::leaving, true}, kPoints);
  check_separated(flight(at_distance, {0, 4, 0}), within(3), at(0), {Nature::isolated, Trend::leaving, true}, kPoints);
  check_separated(flight(at_distance, at_distance), within(3), at(0), {Nature::sustained, Trend::constant, true},
                  kPoints);
  // t_max = 0 does not change what comes before and after.
  check_separated(flight(at_distance, {0, 4, 0}), within(3), at(0), {Nature::isolated, Trend::leaving, true}, kPoints,
                  0);
  check_separated(flight(at_distance, {8, 3, 0}), within(3), at(0), {Nature::grazing, Trend::leaving, true}, kPoints,
                  0);
  check_separated(flight(at_distance, {0, 1, 0}), within(3), at(0), {Nature::entering, Trend::approaching, true},
                  kPoints, 0);
}

TEST_CASE("a start within the separation is sustained, whatever comes next") {
  const auto start_within = [](const Vec3& to, Trend trend) {
    check_separated(flight({0, 3, 0}, to), within(5), at(0), {Nature::sustained, trend, true}, kPoints);
  };
  start_within({0, 1, 0}, Trend::approaching);
  start_within({0, 3, 0}, Trend::constant);
  start_within({0, 9, 0}, Trend::leaving);
  start_within({8, 3, 0}, Trend::leaving);  // the derivative of the distance is 0
  check_separated(flight({0, 0, 0}, {0, 0, 1}), within(1), at(0), {Nature::sustained, Trend::leaving, true}, kPoints);
  check_separated(flight({0, 0, 0}, {0, 0, 0}), within(1), at(0), {Nature::sustained, Trend::constant, true}, kPoints);
}

TEST_CASE("a vertex comes near a face, its sides and its corners") {
  const Weights inside = {0.5, 0.25, 0.25};
  const Weights on_side = {0.75, 0.25, 0};
  check_separated(over_face({1, 1, 3}, {1, 1, -1}), within(1), at(0.5), kEnters, on_face(Feature::f, inside));
  check_separated(over_face({1, 1, -3}, {1, 1, 1}), within(1), at(0.5), kEnters, on_face(Feature::f, inside));
  // 3^2 + 4^2 = 5^2, outside of the side f0 f1.
  check_separated(over_face({1, -3, 8}, {1, -3, 0}), within(5), at(0.5), kEnters, on_face(Feature::f01, on_side));
  check_separated(over_face({-2, -2, 2}, {-2, -2, 0}), within(3), at(0.5), kEnters, on_face(Feature::f0, kFirst));
  check_separated(over_face({6, -1, 4}, {6, -1, 0}), within(3), at(0.5), kEnters, on_face(Feature::f1, kSecond));
  check_separated(over_face({-1, 6, 4}, {-1, 6, 0}), within(3), at(0.5), kEnters, on_face(Feature::f2, kThird));
}

TEST_CASE("a vertex comes to constant distance exactly over a border of the face") {
  check_separated(over_face({1, -1, 1}, {1, 1, 1}), within(1), at(0.5), kStays, on_face(Feature::f01, {0.75, 0.25, 0}));
  check_separated(over_face({-1, -1, 1}, {1, 1, 1}), within(1), at(0.5), kStays, on_face(Feature::f0, kFirst));
  check_separated(over_face({-1, 0, 1}, {1, 0, 1}), within(1), at(0.5), kStays, on_face(Feature::f0, kFirst));
  // Over the border it sinks: it enters from the side's cylinder and goes on above the face.
  check_separated(over_face({1, -1, 1.5}, {1, 1, 0.5}), within(1), at(0.5), kEnters,
                  on_face(Feature::f01, {0.75, 0.25, 0}));
  check_no_contact(over_face({1, -1, 1}, {1, 1, 1}), within(std::nextafter(1, 0)));
}

TEST_CASE("a vertex within the separation of a face goes through it") {
  const Place place = on_face(Feature::f, {0.5, 0.25, 0.25});
  const auto start = [&](double z0, double z1, Trend trend) {
    check_separated(over_face({1, 1, z0}, {1, 1, z1}), within(1), at(0), {Nature::sustained, trend, true}, place);
  };
  start(0.5, -2, Trend::approaching);
  start(0, -2, Trend::leaving);
  start(-0.5, -2, Trend::leaving);
  start(-0.5, -0.5, Trend::constant);
}

TEST_CASE("edges pass each other crosswise") {
  const Query falling = edges({-1, 0, 1}, {1, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, 1, 0});
  const Place middle = {Feature::a, Feature::b, {0.5, 0.5, 0}, {0.5, 0.5, 0}};
  check_separated(falling, within(0.5), at(0.5), kEnters, middle);
  check_separated(falling, within(1), at(0), {Nature::entering, Trend::approaching, true}, middle);
  check_separated(falling, within(2), at(0), {Nature::sustained, Trend::approaching, true}, middle);
  const Query rising = edges({-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0});
  check_separated(rising, within(0.5), at(0), {Nature::sustained, Trend::leaving, true}, middle);
  // Edge a reaches past the end of edge b: 3^2 + 4^2 = 5^2.
  check_separated(edges({-2, 4, 8}, {6, 4, 8}, {0, 0, -8}, {0, 0, 0}, {0, 1, 0}), within(5), at(0.5), kEnters,
                  {Feature::a, Feature::b1, {0.75, 0.25, 0}, kSecond});
}

TEST_CASE("parallel edges slide past each other at exactly the separation") {
  // Edge a comes along the x axis at height 1. Its end a1 is over b0 at 1/2.
  const Query sliding = edges({-4, 1, 0}, {-2, 1, 0}, {4, 0, 0}, {0, 0, 0}, {2, 0, 0});
  check_separated(sliding, within(1), at(0.5), kStays, {Feature::a1, Feature::b0, kSecond, kFirst});
  check_no_contact(sliding, within(std::nextafter(1, 0)));
  // From the start they overlap for 1 <= x <= 2, and the largest weight of a1 is 1.
  check_separated(edges({0, 1, 0}, {2, 1, 0}, {0, 0, 0}, {1, 0, 0}, {5, 0, 0}), within(1), at(0),
                  {Nature::sustained, Trend::constant, true},
                  {Feature::overlap, Feature::overlap, kSecond, {0.75, 0.25, 0}});
}

TEST_CASE("parallel edges approach each other") {
  // They overlap for 1 <= x <= 3.
  const Place place = {Feature::overlap, Feature::overlap, {0.25, 0.75, 0}, kFirst};
  check_separated(edges({0, 3, 0}, {4, 3, 0}, {0, -2, 0}, {3, 0, 0}, {1, 0, 0}), within(2), at(0.5), kEnters, place);
  check_separated(edges({0, 3, 0}, {4, 3, 0}, {0, -2, 0}, {1, 0, 0}, {3, 0, 0}), within(2), at(0.5), kEnters,
                  {Feature::overlap, Feature::overlap, {0.25, 0.75, 0}, kSecond});
  // They touch at the start along that part.
  check_separated(edges({0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {3, 0, 0}, {1, 0, 0}), within(2), at(0),
                  {Nature::sustained, Trend::leaving, true}, place);
  // End over end: one pair.
  check_separated(edges({0, 3, 0}, {4, 3, 0}, {0, -2, 0}, {4, 0, 0}, {9, 0, 0}), within(2), at(0.5), kEnters,
                  {Feature::a1, Feature::b0, kSecond, kFirst});
}

TEST_CASE("edges that move together keep their distance") {
  const Query query = moved(edges({-1, 0, 1}, {1, 0, 1}, {5, 7, 9}, {0, -1, 0}, {0, 1, 0}), 2, 4, {5, 7, 9});
  check_separated(query, within(1), at(0), {Nature::sustained, Trend::constant, true},
                  {Feature::a, Feature::b, {0.5, 0.5, 0}, {0.5, 0.5, 0}});
  check_separated(query, within(7), at(0), {Nature::sustained, Trend::constant, true},
                  {Feature::a, Feature::b, {0.5, 0.5, 0}, {0.5, 0.5, 0}});
  check_no_contact(query, within(std::nextafter(1, 0)));
}

TEST_CASE("edges without a length are their first corners") {
  const Vec3 down = {0, 0, -2};
  check_separated(edges({1, 0, 2}, {1, 0, 2}, down, {0, 0, 0}, {4, 0, 0}), within(1), at(0.5), kEnters,
                  {Feature::a0, Feature::b, kFirst, {0.75, 0.25, 0}});
  check_separated(edges({0, 0, 2}, {4, 0, 2}, down, {1, 0, 0}, {1, 0, 0}), within(1), at(0.5), kEnters,
                  {Feature::a, Feature::b0, {0.75, 0.25, 0}, kFirst});
  check_separated(edges({0, 0, 2}, {0, 0, 2}, down, {0, 0, 0}, {0, 0, 0}), within(1), at(0.5), kEnters,
                  {Feature::a0, Feature::b0, kFirst, kFirst});
}

TEST_CASE("an edge that has no length at the time of impact only") {
  // Edge a shrinks to its middle at height 1, and grows again.
  const Query query =
      EdgeEdge{{{{-1, 0, 2}, {1, 0, 2}, {-4, 0, 0}, {4, 0, 0}}}, {{{1, 0, 0}, {-1, 0, 0}, {-4, 0, 0}, {4, 0, 0}}}};
  check_separated(query, within(1), at(0.5), kEnters, {Feature::a0, Feature::b, kFirst, {0.5, 0.5, 0}});
}

TEST_CASE("the closest point of a flat triangle is on the first feature that holds it") {
  const auto check = [](const Query& query, Feature feature, const Weights& weights) {
    check_separated(query, within(1), at(0.5), kEnters, on_face(feature, weights));
  };
  check(over_flat_face(3, 0, 4, 2), Feature::f01, {0.25, 0.75, 0});
  check(over_flat_face(2, 0, 4, 2), Feature::f2, kThird);
  check(over_flat_face(1, 0, 2, 4), Feature::f01, {0.5, 0.5, 0});
  check(over_flat_face(3, 0, 2, 4), Feature::f12, {0, 0.5, 0.5});
  check(over_flat_face(3, 2, 0, 4), Feature::f12, {0, 0.25, 0.75});
  check(over_flat_face(1, 2, 0, 4), Feature::f01, {0.5, 0.5, 0});
  check(over_flat_face(0, 0, 0, 4), Feature::f0, kFirst);
  check(over_flat_face(1, 0, 0, 4), Feature::f12, {0, 0.75, 0.25});
  check(over_flat_face(1, 0, 4, 0), Feature::f01, {0.75, 0.25, 0});
  check(over_flat_face(4, 0, 4, 4), Feature::f1, kSecond);
  check(over_flat_face(0, 0, 0, 0), Feature::f0, kFirst);
}

TEST_CASE("a point comes near an edge") {
  const auto falling = [](double x, double e0, double e1) {
    return Query(PointEdge{{{{x, 0, 8}, {e0, 0, 0}, {e1, 0, 0}}}, {{{x, 0, 0}, {e0, 0, 0}, {e1, 0, 0}}}});
  };
  check_separated(falling(1, 0, 4), within(4), at(0.5), kEnters, {Feature::p, Feature::e, kFirst, {0.75, 0.25, 0}});
  check_separated(falling(-3, 0, 4), within(5), at(0.5), kEnters, {Feature::p, Feature::e0, kFirst, kFirst});
  check_separated(falling(7, 0, 4), within(5), at(0.5), kEnters, {Feature::p, Feature::e1, kFirst, kSecond});
  check_separated(falling(0, 3, 3), within(5), at(0.5), kEnters, {Feature::p, Feature::e0, kFirst, kFirst});
  // Exactly over the end, where the cylinder and the sphere meet.
  check_separated(falling(4, 0, 4), within(4), at(0.5), kEnters, {Feature::p, Feature::e1, kFirst, kSecond});
}

TEST_CASE("a distance is compared with one that no double squares to exactly") {
  // 1 + 2^-52 has a square of 105 bits. At a time of 1/2 the distance is that number.
  const double d = std::nextafter(1, 2);
  check_separated(flight({0, 2 * d, 0}, {0, 0, 0}), within(d), at(0.5), kEnters, kPoints);
  check_separated(flight({-1, d, 0}, {1, d, 0}), within(d), at(0.5), kGrazes, kPoints);
  check_no_contact(flight({-1, d, 0}, {1, d, 0}), within(1));
}
