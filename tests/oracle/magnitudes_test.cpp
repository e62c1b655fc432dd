// Coordinates and times from 2^-1074 to the largest doubles.
// SPDX-License-Identifier: MIT
#include <limits>

#include "oracle/expected.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr double kSmallest = 0x1p-1074;
constexpr double kLargest = std::numeric_limits<double>::max();

/// Each axis times its own power of two, exactly.
Query scaled(Query query, double x, double y, double z) {
  for (auto* corners : {&query.start, &query.end}) {
    for (auto& corner : *corners) corner = {corner.x * x, corner.y * y, corner.z * z};
  }
  return query;
}

Query meeting(double p_last, double q) { return PointPoint{{{{0, 0, 0}, {q, 0, 0}}}, {{{p_last, 0, 0}, {q, 0, 0}}}}; }

Expected points_at(Times times) { return {times, Nature::isolated, Feature::p, Feature::q, kFirst, kFirst}; }

}  // namespace

TEST_CASE("the answer does not change with the unit of an axis") {
  // V is a multiple of 1 - 2 t^2, as in the edge-edge tests.
  const Query edges =
      EdgeEdge{{{{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}, {0, 3, 0}}}, {{{-1, 0, 1}, {2, 0, -1}, {0, -1, 0}, {0, 3, 0}}}};
  const Expected edges_expected = {
      kSqrtHalf,      Nature::crossing, Feature::a, Feature::b, {1 - kSqrtTwoMinusOne, kSqrtTwoMinusOne, 0},
      {0.75, 0.25, 0}};
  const Query face =
      VertexFace{{{{1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, -2}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};
  const Expected face_expected = {kOneThird, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}};
  for (const double x : {kSmallest, 0x1p-1000, 1.0, 0x1p1000, 0x1p1021}) {
    for (const double z : {kSmallest, 0x1p1021}) {
      check_contact(scaled(edges, x, x, z), edges_expected);
      check_contact(scaled(edges, x, z, x), edges_expected);
      check_contact(scaled(face, x, z, x), face_expected);
    }
  }
}

TEST_CASE("times below the least normal double") {
  check_contact(meeting(1, kSmallest), points_at(at(kSmallest)));
  check_contact(meeting(3, kSmallest), points_at({0, kSmallest}));
  check_contact(meeting(3, 5 * kSmallest), points_at({kSmallest, 2 * kSmallest}));
  check_contact(meeting(4, 12 * kSmallest), points_at(at(3 * kSmallest)));
  check_contact(meeting(kLargest, kSmallest), points_at({0, kSmallest}));
  check_no_contact(meeting(3, kSmallest), 0);
  check_contact(meeting(3, kSmallest), points_at({0, kSmallest}), kSmallest);
}

TEST_CASE("an irrational time near 2^-1000") {
  // Seen along y, edge a goes from (-2^-1000, t) to (t, -2^-999): V is a multiple of 2^-1999 - t^2.
  const Query query = EdgeEdge{{{{-0x1p-1000, 0, 0}, {0, 0, -0x1p-999}, {0, -1, 0}, {0, 3, 0}}},
                               {{{-0x1p-1000, 0, 1}, {1, 0, -0x1p-999}, {0, -1, 0}, {0, 3, 0}}}};
  check_contact(query, {{0x1.6a09e667f3bccp-1000, 0x1.6a09e667f3bcdp-1000},
                        Nature::crossing,
                        Feature::a,
                        Feature::b,
                        {1 - kSqrtTwoMinusOne, kSqrtTwoMinusOne, 0},
                        {0.75, 0.25, 0}});
}

TEST_CASE("a double root of V that 2^-1000 takes away or splits") {
  // Seen along y, edge a goes from (-1, 2 - 2t) to (2t, -1) past edge b at (0, h): V is a multiple of
  // (1 - 2t)^2 + h (1 + 2t), which has no root for h > 0, and for h = -2^-1000 two near 1/2 -+ 2^-500.
  const auto at_height = [](double h) {
    return Query(
        EdgeEdge{{{{-1, 0, 2}, {0, 0, -1}, {0, -1, h}, {0, 1, h}}}, {{{-1, 0, 0}, {2, 0, -1}, {0, -1, h}, {0, 1, h}}}});
  };
  check_no_contact(at_height(0x1p-1000));
  const Times just_before_half = {std::nextafter(0.5, 0), 0.5};
  check_contact(at_height(-0x1p-1000),
                {just_before_half, Nature::crossing, Feature::a, Feature::b, {0.5, 0.5, 0}, {0.5, 0.5, 0}});
}

TEST_CASE("the least distance a double can hold is not a contact") {
  const auto falling_to = [](double last) {
    return Query(
        VertexFace{{{{1, 1, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 1, last}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  };
  const Weights weights = {0.5, 0.25, 0.25};
  check_no_contact(falling_to(kSmallest));
  check_contact(falling_to(0), {at(1), Nature::crossing, Feature::v, Feature::f, kFirst, weights});
  const Times just_before_one = {std::nextafter(1, 0), 1};
  check_contact(falling_to(-kSmallest), {just_before_one, Nature::crossing, Feature::v, Feature::f, kFirst, weights});
}

TEST_CASE("differences that overflow a double") {
  const double m = kLargest;
  const Query query =
      EdgeEdge{{{{-m, 0, m}, {m, 0, m}, {0, -m, 0}, {0, m, 0}}}, {{{-m, 0, -m}, {m, 0, -m}, {0, -m, 0}, {0, m, 0}}}};
  check_contact(query, {at(0.5), Nature::crossing, Feature::a, Feature::b, {0.5, 0.5, 0}, {0.5, 0.5, 0}});
}

TEST_CASE("a weight below what a double near 1 can tell") {
  // The contact is 2^-1074 from a0, on an edge as long as the largest double.
  const Query query = PointEdge{{{{kSmallest, 0, 1}, {0, 0, 0}, {kLargest, 0, 0}}},
                                {{{kSmallest, 0, -1}, {0, 0, 0}, {kLargest, 0, 0}}}};
  check_contact(query, {at(0.5), Nature::isolated, Feature::p, Feature::e, kFirst, kFirst});
}

TEST_CASE("an elongated edge and weights that need a thousand bits of the time") {
  // Seen along y, edge a goes from (-2^-1000, t) to (2^1000 t, -1), rotating through the origin at t^2 = 2^-2000, that
  // is 2^-1000: s = 1 / (1 + 2^1000 t / 2^-1000) = 1 / (1 + 2^1000).
  const Query query = EdgeEdge{{{{-0x1p-1000, 0, 0}, {0, 0, -1}, {0, -1, 0}, {0, 1, 0}}},
                               {{{-0x1p-1000, 0, 1}, {0x1p1000, 0, -1}, {0, -1, 0}, {0, 1, 0}}}};
  check_contact(query, {at(0x1p-1000), Nature::crossing, Feature::a, Feature::b, {1, 0x1p-1000, 0}, {0.5, 0.5, 0}});
}
