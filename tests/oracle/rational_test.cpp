// Coordinates that no double holds.
// SPDX-License-Identifier: MIT
#include <string>

#include "oracle/expected.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Position = std::array<Fraction, 3>;

const Fraction kZero = {"0", "1"};
const Fraction kOne = {"1", "1"};
const Fraction kThirdPart = {"1", "3"};

/// The vertex falls from height 1/7 to -2/7 over (x, y) onto the triangle (0, 0), (2/3, 0), (0, 2/3): t = 1/3.
RationalQuery falling_over(const Fraction& x, const Fraction& y) {
  RationalQuery query;
  query.kind = Kind::vertex_face;
  const Position f0 = {kZero, kZero, kZero};
  const Position f1 = {{{"2", "3"}, kZero, kZero}};
  const Position f2 = {{kZero, {"2", "3"}, kZero}};
  query.start = {{{{x, y, {"1", "7"}}}, f0, f1, f2}};
  query.end = {{{{x, y, {"-2", "7"}}}, f0, f1, f2}};
  return query;
}

}  // namespace

TEST_CASE("a vertex over thirds of a face") {
  const auto expected = [](Feature feature, Weights weights) {
    return Expected{kOneThird, Nature::crossing, Feature::v, feature, kFirst, weights};
  };
  check_answer(oracle::decide(falling_over(kThirdPart, kThirdPart), 1), expected(Feature::f12, {0, 0.5, 0.5}));
  check_answer(oracle::decide(falling_over({"2", "9"}, {"2", "9"}), 1),
               expected(Feature::f, {1.0 / 3, 1.0 / 3, 1.0 / 3}));
  check_answer(oracle::decide(falling_over({"2", "3"}, kZero), 1), expected(Feature::f1, kSecond));
  check_no_contact(oracle::decide(falling_over({"333333333333333333334", "1000000000000000000000"}, kThirdPart), 1));
  check_no_contact(oracle::decide(falling_over(kThirdPart, kThirdPart), kOneThird.first));
}

TEST_CASE("fractions need not be reduced and their denominators may be negative") {
  check_answer(oracle::decide(falling_over({"-100", "-300"}, {"-7", "-21"}), 1),
               {kOneThird, Nature::crossing, Feature::v, Feature::f12, kFirst, {0, 0.5, 0.5}});
  const std::string zeros(400, '0');
  check_answer(oracle::decide(falling_over({"1" + zeros, "3" + zeros}, {"-0", "-5"}), 1),
               {kOneThird, Nature::crossing, Feature::v, Feature::f01, kFirst, {0.5, 0.5, 0}});
}

TEST_CASE("points that meet at a third") {
  RationalQuery query;
  query.kind = Kind::point_point;
  query.start[0] = {kZero, kZero, kZero};
  query.end[0] = {kOne, kZero, kZero};
  query.start[1] = query.end[1] = {kThirdPart, kZero, kZero};
  check_answer(oracle::decide(query, 1), {kOneThird, Nature::isolated, Feature::p, Feature::q, kFirst, kFirst});
}

TEST_CASE("edges of thirds and sevenths that meet corner to corner") {
  // Edge a leans up from (1/3, 1/7, h), h from 1/5 to -1/5; edge b ends at (1/3, 1/7, 0).
  RationalQuery query;
  query.kind = Kind::edge_edge;
  const Fraction seventh = {"1", "7"};
  const Position b0 = {{{"-1", "3"}, {"4", "7"}, kZero}};
  const Position b1 = {{kThirdPart, seventh, kZero}};
  query.start = {{{{kThirdPart, seventh, {"1", "5"}}}, {{kOne, kOne, kOne}}, b0, b1}};
  query.end = {{{{kThirdPart, seventh, {"-1", "5"}}}, {{kOne, kOne, {"3", "5"}}}, b0, b1}};
  check_answer(oracle::decide(query, 1), {at(0.5), Nature::crossing, Feature::a0, Feature::b1, kFirst, kSecond});
}

TEST_CASE("a point on an edge of thirds, all the time") {
  RationalQuery query;
  query.kind = Kind::point_edge;
  query.start[0] = query.end[0] = {kThirdPart, kThirdPart, kThirdPart};
  query.start[1] = query.end[1] = {kZero, kZero, kZero};
  query.start[2] = query.end[2] = {kOne, kOne, kOne};
  check_answer(oracle::decide(query, 1),
               {at(0), Nature::sustained, Feature::p, Feature::e, kFirst, {2.0 / 3, 1.0 / 3, 0}});
}
