// Separations, coordinates and times from 2^-1074 to the largest doubles.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "oracle/separated.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr double kSmallest = 0x1p-1074;
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr Place kPoints = {Feature::p, Feature::q, kFirst, kFirst};
constexpr Times kJustBeforeHalf = {0x1.fffffffffffffp-2, 0.5};

Query scaled(Query query, double factor) {
  for (auto* corners : {&query.start, &query.end}) {
    for (auto& corner : *corners) corner = {corner.x * factor, corner.y * factor, corner.z * factor};
  }
  return query;
}

Query flight(const Vec3& from, const Vec3& to) { return PointPoint{{{from, {0, 0, 0}}}, {{to, {0, 0, 0}}}}; }

/// A vertex over the triangle (0, 0), (4 s, 0), (0, 4 s) of the plane z = 0 at (s, s).
Query over_face(double s, double from, double to) {
  return VertexFace{{{{s, s, from}, {0, 0, 0}, {4 * s, 0, 0}, {0, 4 * s, 0}}},
                    {{{s, s, to}, {0, 0, 0}, {4 * s, 0, 0}, {0, 4 * s, 0}}}};
}

}  // namespace

TEST_CASE("the answer does not change with the unit of length") {
  const Query edges =
      EdgeEdge{{{{-1, 0, 4}, {1, 0, 4}, {0, -1, 0}, {0, 1, 0}}}, {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}}}};
  const Query parallel =
      EdgeEdge{{{{-4, 1, 0}, {-2, 1, 0}, {0, 0, 0}, {2, 0, 0}}}, {{{0, 1, 0}, {2, 1, 0}, {0, 0, 0}, {2, 0, 0}}}};
  for (const double unit : {kSmallest, 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000, 0x1p1020}) {
    check_separated(scaled(edges, unit), {unit, Metric::euclidean}, at(0.75), kEnters,
                    {Feature::a, Feature::b, {0.5, 0.5, 0}, {0.5, 0.5, 0}});
    check_separated(scaled(edges, unit), {unit, Metric::max}, at(0.75), kEnters,
                    {Feature::a1, Feature::b1, kSecond, kSecond});
    check_separated(scaled(parallel, unit), {unit, Metric::euclidean}, at(0.5), kStays,
                    {Feature::a1, Feature::b0, kSecond, kFirst});
    check_separated(scaled(over_face(1, 3, -1), unit), {unit, Metric::euclidean}, at(0.5), kEnters,
                    {Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
    check_separated(scaled(flight({-1, 3, 4}, {2, 3, 4}), unit), {5 * unit, Metric::euclidean}, kOneThird, kGrazes,
                    kPoints);
  }
}

TEST_CASE("the least separation that a double can hold") {
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const Separation least = {kSmallest, metric};
    check_separated(flight({1, 0, 0}, {-1, 0, 0}), least, kJustBeforeHalf, kEnters, kPoints);
    check_separated(flight({kLargest, 0, 0}, {-kLargest, 0, 0}), least, kJustBeforeHalf, kEnters, kPoints);
    check_separated(flight({2 * kSmallest, 0, 0}, {0, 0, 0}), least, at(0.5), kEnters, kPoints);
    check_separated(flight({kLargest, 0, 0}, {kSmallest, 0, 0}), least, at(1), kEnters, kPoints);
    check_no_contact(flight({kLargest, 0, 0}, {2 * kSmallest, 0, 0}), least);
    const Answer through_face = oracle::decide_by_oracle(over_face(0x1p1000, 0x1p1020, -0x1p1020), 1, least);
    CHECK(through_face.toi == kJustBeforeHalf.first);
    CHECK(through_face.toi_upper == 0.5);
    CHECK(through_face.nature == Nature::entering);
    CHECK(through_face.feature_b == Feature::f);
  }
}

TEST_CASE("the largest separation that a double can hold") {
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const Separation largest = {kLargest, metric};
    check_separated(flight({-1, 0, 0}, {1, 0, 0}), largest, at(0), {Nature::sustained, Trend::approaching, true},
                    kPoints);
    check_separated(flight({kLargest, 0, 0}, {kLargest, 0, 0}), largest, at(0),
                    {Nature::sustained, Trend::constant, true}, kPoints);
    // The distance is from twice the largest double to nothing.
    const Query far_apart = PointPoint{{{{-kLargest, 0, 0}, {kLargest, 0, 0}}}, {{{kLargest, 0, 0}, {kLargest, 0, 0}}}};
    check_separated(far_apart, largest, at(0.5), kEnters, kPoints);
  }
}

TEST_CASE("a tiny sphere is touched by a point of great speed") {
  const double far_away = 0x1p1000;
  for (const double radius : {kSmallest, 0x1p-500}) {
    const Query query = flight({-far_away, radius, 0}, {far_away, radius, 0});
    check_separated(query, {radius, Metric::euclidean}, at(0.5), kGrazes, kPoints);
    check_separated(query, {radius, Metric::max}, kJustBeforeHalf, kStays, kPoints);
    check_separated(query, {std::nextafter(radius, 1), Metric::max}, kJustBeforeHalf, kEnters, kPoints);
    check_separated(query, {2 * radius, Metric::euclidean}, kJustBeforeHalf, kEnters, kPoints);
  }
}

TEST_CASE("a face misses a separation by the least amount at the largest scale") {
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const double d = 0x1p1000;
    const Separation separation = {d, metric};
    const double above = std::nextafter(d, kLargest);
    check_no_contact(over_face(0x1p-1000, 2 * d, above), separation);
    const Answer reached = oracle::decide_by_oracle(over_face(0x1p-1000, 2 * d, d), 1, separation);
    CHECK(reached.contact);
    CHECK(reached.toi_upper == 1);
  }
}

TEST_CASE("a separation is reached at a time below the least normal double") {
  check_separated(flight({2, 0, 0}, {0, 0, 0}), {2, Metric::max}, at(0), {Nature::entering, Trend::approaching, true},
                  kPoints);
  // The distance 1 + 2^-1074 cannot be told in doubles as one coordinate, but as that of two points.
  const Query query = PointPoint{{{{-kSmallest, 0, 0}, {1, 0, 0}}}, {{{1, 0, 0}, {1, 0, 0}}}};
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    check_separated(query, {1, metric}, {0, kSmallest}, kEnters, kPoints);
    check_no_contact(query, {1, metric}, 0);
  }
}
