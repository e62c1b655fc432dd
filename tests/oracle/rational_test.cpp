// Coordinates that no double holds.
// SPDX-License-Identifier: MIT
#include <string>

#include "oracle/expected.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Position = std::array<Fraction, 3>;

/// "1/3" or "5".
Fraction fraction(const std::string& text) {
  const std::size_t slash = text.find('/');
  Fraction result;
  result.numerator = text.substr(0, slash);
  if (slash != std::string::npos) result.denominator = text.substr(slash + 1);
  return result;
}

Position position(const std::string& x, const std::string& y, const std::string& z) {
  Position result;
  result[0] = fraction(x);
  result[1] = fraction(y);
  result[2] = fraction(z);
  return result;
}

/// The vertex falls from height 1/7 to -2/7 over (x, y) onto the triangle (0, 0), (2/3, 0), (0, 2/3): t = 1/3.
RationalQuery falling_over(const std::string& x, const std::string& y) {
  RationalQuery query;
  query.kind = Kind::vertex_face;
  query.start[0] = position(x, y, "1/7");
  query.end[0] = position(x, y, "-2/7");
  query.start[1] = query.end[1] = position("0", "0", "0");
  query.start[2] = query.end[2] = position("2/3", "0", "0");
  query.start[3] = query.end[3] = position("0", "2/3", "0");
  return query;
}

Expected falls_on(Feature feature, const Weights& weights) {
  return {kOneThird, Nature::crossing, Feature::v, feature, kFirst, weights};
}

}  // namespace

TEST_CASE("a vertex over thirds of a face") {
  check_answer(oracle::decide_by_oracle(falling_over("1/3", "1/3"), 1), falls_on(Feature::f12, {0, 0.5, 0.5}));
  check_answer(oracle::decide_by_oracle(falling_over("2/9", "2/9"), 1),
               falls_on(Feature::f, {1.0 / 3, 1.0 / 3, 1.0 / 3}));
  check_answer(oracle::decide_by_oracle(falling_over("2/3", "0"), 1), falls_on(Feature::f1, kSecond));
  check_no_contact(oracle::decide_by_oracle(falling_over("333333333333333333334/1000000000000000000000", "1/3"), 1));
  check_no_contact(oracle::decide_by_oracle(falling_over("1/3", "1/3"), kOneThird.first));
}

TEST_CASE("fractions need not be reduced and their denominators may be negative") {
  check_answer(oracle::decide_by_oracle(falling_over("-100/-300", "-7/-21"), 1), falls_on(Feature::f12, {0, 0.5, 0.5}));
  const std::string zeros(400, '0');
  const std::string third = "1" + zeros + "/3" + zeros;
  check_answer(oracle::decide_by_oracle(falling_over(third, "-0/-5"), 1), falls_on(Feature::f01, {0.5, 0.5, 0}));
  check_no_contact(oracle::decide_by_oracle(falling_over(third, "1/-" + std::string(400, '9')), 1));
}

TEST_CASE("points that meet at a third") {
  RationalQuery query;
  query.kind = Kind::point_point;
  query.start[0] = position("0", "0", "0");
  query.end[0] = position("1", "0", "0");
  query.start[1] = query.end[1] = position("1/3", "0", "0");
  check_answer(oracle::decide_by_oracle(query, 1),
               {kOneThird, Nature::isolated, Feature::p, Feature::q, kFirst, kFirst});
}

TEST_CASE("edges of thirds and sevenths that meet corner to corner") {
  // Edge a leans up from (1/3, 1/7, h), h from 1/5 to -1/5; edge b ends at (1/3, 1/7, 0).
  RationalQuery query;
  query.kind = Kind::edge_edge;
  query.start[0] = position("1/3", "1/7", "1/5");
  query.end[0] = position("1/3", "1/7", "-1/5");
  query.start[1] = position("1", "1", "1");
  query.end[1] = position("1", "1", "3/5");
  query.start[2] = query.end[2] = position("-1/3", "4/7", "0");
  query.start[3] = query.end[3] = position("1/3", "1/7", "0");
  check_answer(oracle::decide_by_oracle(query, 1),
               {at(0.5), Nature::crossing, Feature::a0, Feature::b1, kFirst, kSecond});
}

TEST_CASE("a point on an edge of thirds, all the time") {
  RationalQuery query;
  query.kind = Kind::point_edge;
  query.start[0] = query.end[0] = position("1/3", "1/3", "1/3");
  query.start[1] = query.end[1] = position("0", "0", "0");
  query.start[2] = query.end[2] = position("1", "1", "1");
  check_answer(oracle::decide_by_oracle(query, 1),
               {at(0), Nature::sustained, Feature::p, Feature::e, kFirst, {2.0 / 3, 1.0 / 3, 0}});
}

TEST_CASE("a separation from thirds and sevenths") {
  // The height 1/7 - 3 t / 7 is 1/32 at t = 25/96.
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    const Answer near = oracle::decide_by_oracle(falling_over("1/3", "1/3"), 1, {0x1p-5, metric});
    CHECK(near.contact);
    CHECK(near.toi <= 25.0 / 96);
    CHECK(near.toi_upper >= 25.0 / 96);
    CHECK(near.toi_upper == std::nextafter(near.toi, 1));
    CHECK(near.nature == Nature::entering);
    CHECK(near.trend == Trend::approaching);
    const Answer within = oracle::decide_by_oracle(falling_over("2/9", "2/9"), 1, {0.25, metric});
    CHECK(within.starts_within);
    CHECK(within.nature == Nature::sustained);
    CHECK(within.trend == Trend::approaching);
    CHECK(within.toi_upper == 0);
    CHECK_FALSE(oracle::decide_by_oracle(falling_over("1/3", "1/3"), 25.0 / 96 - 0x1p-50, {0x1p-5, metric}).contact);
  }
  // Two points whose distance falls from 2/3 to 0.
  RationalQuery points;
  points.kind = Kind::point_point;
  points.start[0] = position("2/3", "0", "0");
  points.end[0] = points.start[1] = points.end[1] = position("0", "0", "0");
  const Answer quarter = oracle::decide_by_oracle(points, 1, {0.5, Metric::euclidean});
  CHECK(quarter.toi == 0.25);
  CHECK(quarter.toi_upper == 0.25);
  points.start[0] = position("2/3", "1/2", "0");
  points.end[0] = position("-2/3", "1/2", "0");
  const Answer tangent = oracle::decide_by_oracle(points, 1, {0.5, Metric::euclidean});
  CHECK(tangent.nature == Nature::grazing);
  CHECK(tangent.toi == 0.5);
}
