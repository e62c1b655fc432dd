// Edges whose V is not identically zero: crossing and grazing, in every place, at times known by hand.
// SPDX-License-Identifier: MIT
#include "oracle/expected.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// Edge b stands on the y axis from -1 to 1. Edge a is parallel to x, half before and half behind it, and comes down
/// from height 1 to `last`: they meet at t = 1 / (1 - last).
Query falling(double last) {
  return EdgeEdge{{{{-1, 0, 1}, {1, 0, 1}, {0, -1, 0}, {0, 1, 0}}},
                  {{{-1, 0, last}, {1, 0, last}, {0, -1, 0}, {0, 1, 0}}}};
}

const Weights kMiddle = {0.5, 0.5, 0};

}  // namespace

TEST_CASE("edges that cross in their interiors") {
  check_contact(falling(-1), {at(0.5), Nature::crossing, Feature::a, Feature::b, kMiddle, kMiddle});
  check_contact(falling(-2), {kOneThird, Nature::crossing, Feature::a, Feature::b, kMiddle, kMiddle});
}

TEST_CASE("both ends of the time range count") {
  const Expected at_end = {at(1), Nature::crossing, Feature::a, Feature::b, kMiddle, kMiddle};
  check_contact(falling(0), at_end);
  check_no_contact(falling(0), std::nextafter(1, 0));

  const Expected at_half = {at(0.5), Nature::crossing, Feature::a, Feature::b, kMiddle, kMiddle};
  check_contact(falling(-1), at_half, 0.5);
  check_no_contact(falling(-1), std::nextafter(0.5, 0));
  // No double is 1/3: the range must reach the double after it.
  check_no_contact(falling(-2), kOneThird.first);
  check_contact(falling(-2), {kOneThird, Nature::crossing, Feature::a, Feature::b, kMiddle, kMiddle}, kOneThird.second);

  Query away = falling(1);
  std::swap(away.start, away.end);
  for (auto* corner : {&away.start[0], &away.start[1]}) corner->z = 0;
  const Expected at_start = {at(0), Nature::crossing, Feature::a, Feature::b, kMiddle, kMiddle};
  check_contact(away, at_start);
  check_contact(away, at_start, 0);
  for (auto* corner : {&away.start[0], &away.start[1]}) corner->z = 0x1p-1074;
  check_no_contact(away);
}

TEST_CASE("an irrational time and irrational weights") {
  // Seen along y, edge a goes from (-1, t) to (2t, -1): V is a multiple of 1 - 2 t^2.
  const Query query =
      EdgeEdge{{{{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}, {0, 3, 0}}}, {{{-1, 0, 1}, {2, 0, -1}, {0, -1, 0}, {0, 3, 0}}}};
  check_contact(query, {kSqrtHalf,
                        Nature::crossing,
                        Feature::a,
                        Feature::b,
                        {1 - kSqrtTwoMinusOne, kSqrtTwoMinusOne, 0},
                        {0.75, 0.25, 0}});
  check_no_contact(query, kSqrtHalf.first);
}

TEST_CASE("edges that graze: a double root of V") {
  // Seen along y, from (-1, 2 - 2t) to (2t, -1): V is a multiple of 1 - 4 t (1 - t) = (1 - 2t)^2.
  const Query query =
      EdgeEdge{{{{-1, 0, 2}, {0, 0, -1}, {0, -1, 0}, {0, 3, 0}}}, {{{-1, 0, 0}, {2, 0, -1}, {0, -1, 0}, {0, 3, 0}}}};
  check_contact(query, {at(0.5), Nature::grazing, Feature::a, Feature::b, kMiddle, {0.75, 0.25, 0}});

  // V is 1 - 2t z with z the height of a0: higher, the double root falls apart; lower, it is gone.
  Query high = query;
  high.end[0].z = 0x1p-60;
  CHECK(oracle::decide_by_oracle(high, 1).nature == Nature::crossing);
  Query low = query;
  low.end[0].z = -0x1p-60;
  check_no_contact(low);
}

TEST_CASE("edges that cross at a triple root of V") {
  // Seen from a0, the other corners are (2t - 1) times the three unit vectors: V is a multiple of (2t - 1)^3, and
  // everything meets in one point.
  const Query query =
      EdgeEdge{{{{5, 5, 5}, {4, 5, 5}, {5, 4, 5}, {5, 5, 4}}}, {{{5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {5, 5, 6}}}};
  check_contact(query, {at(0.5), Nature::crossing, Feature::a0, Feature::b0, kFirst, kFirst});
}

TEST_CASE("the second root of V is the first contact when the edges miss each other at the first") {
  // Seen along y, from (-3, 4 - 4t) to (4t, -1): V is a multiple of 3 - 16 t (1 - t), zero at 1/4 and 3/4. Edge a is
  // at y = t, edge b reaches from y = 1/2 to 1.
  const Query query =
      EdgeEdge{{{{-3, 0, 4}, {0, 0, -1}, {0, 0.5, 0}, {0, 1, 0}}}, {{{-3, 1, 0}, {4, 1, -1}, {0, 0.5, 0}, {0, 1, 0}}}};
  check_contact(query, {at(0.75), Nature::crossing, Feature::a, Feature::b, kMiddle, kMiddle});
  check_no_contact(query, 0.5);
}

TEST_CASE("corners are named by their place") {
  // Edge a leans and comes down along z, edge b lies on the y axis.
  const auto leaning = [](double y, bool reversed_a, bool reversed_b) {
    EdgeEdge query{{{{0, y, 1}, {1, y, 2}, {0, -1, 0}, {0, 1, 0}}}, {{{0, y, -1}, {1, y, 0}, {0, -1, 0}, {0, 1, 0}}}};
    for (auto* corners : {&query.start, &query.end}) {
      if (reversed_a) std::swap((*corners)[0], (*corners)[1]);
      if (reversed_b) std::swap((*corners)[2], (*corners)[3]);
    }
    return Query(query);
  };
  const auto expected = [](Feature a, Feature b, Weights weights_a, Weights weights_b) {
    return Expected{at(0.5), Nature::crossing, a, b, weights_a, weights_b};
  };
  check_contact(leaning(0.5, false, false), expected(Feature::a0, Feature::b, kFirst, {0.25, 0.75, 0}));
  check_contact(leaning(0.5, true, false), expected(Feature::a1, Feature::b, kSecond, {0.25, 0.75, 0}));
  check_contact(leaning(-1, false, false), expected(Feature::a0, Feature::b0, kFirst, kFirst));
  check_contact(leaning(1, false, false), expected(Feature::a0, Feature::b1, kFirst, kSecond));
  check_contact(leaning(1, true, false), expected(Feature::a1, Feature::b1, kSecond, kSecond));
  check_contact(leaning(1, true, true), expected(Feature::a1, Feature::b0, kSecond, kFirst));
  check_no_contact(leaning(std::nextafter(1, 2), false, false));
  check_no_contact(leaning(std::nextafter(-1, -2), false, false));

  Query inside = falling(-1);  // an end of b inside a
  inside.start[2].y = inside.end[2].y = 0;
  check_contact(inside, expected(Feature::a, Feature::b0, kMiddle, kFirst));
  std::swap(inside.start[2], inside.start[3]);
  std::swap(inside.end[2], inside.end[3]);
  check_contact(inside, expected(Feature::a, Feature::b1, kMiddle, kSecond));
}

TEST_CASE("edges that pass beside each other") {
  Query query = falling(-1);
  for (auto* corners : {&query.start, &query.end}) {
    (*corners)[2].y = 0x1p-1074;
    (*corners)[3].y = 1;
  }
  check_no_contact(query);
}

TEST_CASE("V vanishes where an edge has no length just then") {
  // b1 falls onto b0 at t = 1/2, while edge a reaches the plane z = 0: V is a multiple of (1 - 2t)^2.
  const Query query =
      EdgeEdge{{{{-1, 0, 1}, {3, 0, 1}, {0, 0, 0}, {0, 1, 0}}}, {{{-1, 0, -1}, {3, 0, -1}, {0, 0, 0}, {0, -1, 0}}}};
  check_contact(query, {at(0.5), Nature::grazing, Feature::a, Feature::b0, {0.75, 0.25, 0}, kFirst});
}

TEST_CASE("V vanishes where the edges are parallel just then") {
  // Edge b turns through the direction of x at t = 1/2, 2 wide; edge a comes down onto it then. V, the determinant of
  // (4, 0, 0), (2, 4t - 2, 0) and the height, is a multiple of (1 - 2t)^2.
  const Query query =
      EdgeEdge{{{{-1, 0, 1}, {3, 0, 1}, {1, 1, 0}, {5, -1, 0}}}, {{{-1, 0, -1}, {3, 0, -1}, {1, -1, 0}, {5, 1, 0}}}};
  // The shared part is 1 <= x <= 3; of its points, (3, 0, 0) has the smallest weight of a0.
  check_contact(query, {at(0.5), Nature::grazing, Feature::overlap, Feature::overlap, kSecond, {0.5, 0.5, 0}});
}
