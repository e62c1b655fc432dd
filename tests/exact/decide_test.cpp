// The exact level on queries that a person can solve on paper.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <touchstone/query.hpp>

#include "exact/exact.hpp"
#include "support/catch.hpp"
#include "support/query_text.hpp"

using namespace touchstone;

namespace {

Answer decide(const Query& query, double t_max = 1) { return exact::decide_exactly(query, t_max); }

void check_contact(const Query& query, double toi, Nature nature, Feature a, Feature b, std::array<double, 3> weights_a,
                   std::array<double, 3> weights_b) {
  const Answer answer = decide(query);
  INFO(tests::cpp_initializer(query));
  INFO(tests::describe(answer));
  REQUIRE(answer.contact);
  CHECK(answer.level == Level::exact);
  CHECK(answer.toi == toi);
  CHECK(answer.toi_upper == toi);
  CHECK(answer.nature == nature);
  CHECK(answer.feature_a == a);
  CHECK(answer.feature_b == b);
  CHECK(answer.weights_a == weights_a);
  CHECK(answer.weights_b == weights_b);
}

constexpr std::array<double, 3> kFirst = {1, 0, 0};
constexpr std::array<double, 3> kSecond = {0, 1, 0};
constexpr std::array<double, 3> kHalves = {0.5, 0.5, 0};

}  // namespace

TEST_CASE("an edge falls through another, hits its corner, or passes one ulp beside it") {
  // a lies along x in the plane z = 0; b along y falls from z = 1 to z = -1.
  const auto falling = [](double x) {
    return Query(
        EdgeEdge{{{{-1, 0, 0}, {1, 0, 0}, {x, -1, 1}, {x, 1, 1}}}, {{{-1, 0, 0}, {1, 0, 0}, {x, -1, -1}, {x, 1, -1}}}});
  };
  check_contact(falling(0), 0.5, Nature::crossing, Feature::a, Feature::b, kHalves, kHalves);
  check_contact(falling(1), 0.5, Nature::crossing, Feature::a1, Feature::b, kSecond, kHalves);
  check_contact(falling(-1), 0.5, Nature::crossing, Feature::a0, Feature::b, kFirst, kHalves);
  CHECK_FALSE(decide(falling(std::nextafter(1, 2))).contact);
  CHECK_FALSE(decide(falling(0), std::nextafter(0.5, 0)).contact);
  CHECK(decide(falling(0), 0.5).contact);
}

TEST_CASE("an edge that turns as it falls touches without crossing") {
  // z of b at its middle: (1 - 2 t)^2 comes from two corners that cross over; V = 4 (1 - 2t)^2 up to sign.
  const Query query(EdgeEdge{{{{-1, -1, 0}, {1, 1, 0}, {-1, 1, 1}, {1, -1, 1}}},
                             {{{-1, -1, 0}, {1, 1, 0}, {1, -1, -1}, {-1, 1, -1}}}});
  // b's direction reverses at t = 1/2, where its corners both pass (0, 0, 0): b is a point there, on a's middle.
  check_contact(query, 0.5, Nature::grazing, Feature::a, Feature::b0, kHalves, kFirst);
}

TEST_CASE("a vertex meets a face's interior, edges and corners") {
  const auto falling = [](double x, double y) {
    return Query(
        VertexFace{{{{x, y, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{x, y, -3}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}});
  };
  const double t = 0.25;
  check_contact(falling(1, 1), t, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25});
  check_contact(falling(0, 0), t, Nature::crossing, Feature::v, Feature::f0, kFirst, {1, 0, 0});
  check_contact(falling(4, 0), t, Nature::crossing, Feature::v, Feature::f1, kFirst, {0, 1, 0});
  check_contact(falling(0, 4), t, Nature::crossing, Feature::v, Feature::f2, kFirst, {0, 0, 1});
  check_contact(falling(1, 0), t, Nature::crossing, Feature::v, Feature::f01, kFirst, {0.75, 0.25, 0});
  check_contact(falling(2, 2), t, Nature::crossing, Feature::v, Feature::f12, kFirst, {0, 0.5, 0.5});
  check_contact(falling(0, 3), t, Nature::crossing, Feature::v, Feature::f20, kFirst, {0.25, 0, 0.75});
  CHECK_FALSE(decide(falling(-0x1p-1074, 1)).contact);
  CHECK_FALSE(decide(falling(2, std::nextafter(2, 3))).contact);
}

TEST_CASE("a flat face is the segment that it covers, and names its first part") {
  const auto falling = [](double x) {
    return Query(
        VertexFace{{{{x, 0, 1}, {0, 0, 0}, {4, 0, 0}, {2, 0, 0}}}, {{{x, 0, -1}, {0, 0, 0}, {4, 0, 0}, {2, 0, 0}}}});
  };
  check_contact(falling(2), 0.5, Nature::isolated, Feature::v, Feature::f2, kFirst, {0, 0, 1});
  check_contact(falling(1), 0.5, Nature::isolated, Feature::v, Feature::f01, kFirst, {0.75, 0.25, 0});
  check_contact(falling(4), 0.5, Nature::isolated, Feature::v, Feature::f1, kFirst, {0, 1, 0});
  CHECK_FALSE(decide(falling(4.5)).contact);
  // A triangle of one point.
  const Query point(
      VertexFace{{{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, {{{0, 0, -1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}});
  check_contact(point, 0.5, Nature::isolated, Feature::v, Feature::f0, kFirst, {1, 0, 0});
}

TEST_CASE("edges in one line: they meet at corners, then share a part") {
  // a = [0, 1] stays; b = [3, 5] moves left by 4: corners meet at t = 1/2, and from then on they overlap.
  const Query query(
      EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 0, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {1, 0, 0}}}});
  check_contact(query, 0.5, Nature::sustained, Feature::a1, Feature::b0, kSecond, kFirst);
  // Overlapping from the start: the end of the shared part that is farthest along a.
  const auto resting = [](double b0, double b1) {
    const std::array<Vec3, 4> x = {{{0, 0, 0}, {4, 0, 0}, {b0, 0, 0}, {b1, 0, 0}}};
    return Query(EdgeEdge{x, x});
  };
  check_contact(resting(1, 3), 0, Nature::sustained, Feature::overlap, Feature::overlap, {0.25, 0.75, 0}, kSecond);
  check_contact(resting(3, 1), 0, Nature::sustained, Feature::overlap, Feature::overlap, {0.25, 0.75, 0}, kFirst);
  check_contact(resting(2, 6), 0, Nature::sustained, Feature::overlap, Feature::overlap, kSecond, kHalves);
  check_contact(resting(-4, 2), 0, Nature::sustained, Feature::overlap, Feature::overlap, kHalves, kSecond);
  check_contact(resting(0, 4), 0, Nature::sustained, Feature::overlap, Feature::overlap, kSecond, kSecond);
  check_contact(resting(4, 0), 0, Nature::sustained, Feature::overlap, Feature::overlap, kSecond, kFirst);
  check_contact(resting(4, 6), 0, Nature::sustained, Feature::a1, Feature::b0, kSecond, kFirst);
  check_contact(resting(-1, 0), 0, Nature::sustained, Feature::a0, Feature::b1, kFirst, kSecond);
  check_contact(resting(1, 1), 0, Nature::sustained, Feature::a, Feature::b0, {0.75, 0.25, 0}, kFirst);
  CHECK_FALSE(decide(resting(5, 6)).contact);
}

TEST_CASE("two points that coincide for an instant, always, or never") {
  const auto meeting = [](double miss) {
    return Query(PointPoint{{{{0, 0, 0}, {1, 1, 1}}}, {{{1, 1, 1}, {0, 0, miss}}}});
  };
  check_contact(meeting(0), 0.5, Nature::isolated, Feature::p, Feature::q, kFirst, kFirst);
  CHECK_FALSE(decide(meeting(0x1p-1074)).contact);
  check_contact(PointPoint{{{{1, 2, 3}, {1, 2, 3}}}, {{{4, 5, 7}, {4, 5, 7}}}}, 0, Nature::sustained, Feature::p,
                Feature::q, kFirst, kFirst);
  // Together only at the last instant: there is no interval in [0, 1] that starts there.
  check_contact(PointPoint{{{{0, 0, 0}, {1, 0, 0}}}, {{{1, 0, 0}, {1, 0, 0}}}}, 1, Nature::isolated, Feature::p,
                Feature::q, kFirst, kFirst);
}

TEST_CASE("a point slides along the line of an edge, onto it") {
  const Query query(PointEdge{{{{-2, 0, 0}, {0, 0, 0}, {4, 0, 0}}}, {{{2, 0, 0}, {0, 0, 0}, {4, 0, 0}}}});
  check_contact(query, 0.5, Nature::sustained, Feature::p, Feature::e0, kFirst, kFirst);
  const Query across(PointEdge{{{{1, -1, 0}, {0, 0, 0}, {4, 0, 0}}}, {{{1, 1, 0}, {0, 0, 0}, {4, 0, 0}}}});
  check_contact(across, 0.5, Nature::isolated, Feature::p, Feature::e, kFirst, {0.75, 0.25, 0});
}

TEST_CASE("a time that no double holds is enclosed by its neighbours") {
  // z = 1 - 3 t: t = 1/3.
  const Query third(PointPoint{{{{0, 0, 1}, {0, 0, 0}}}, {{{0, 0, -2}, {0, 0, 0}}}});
  const Answer answer = decide(third);
  REQUIRE(answer.contact);
  CHECK(answer.toi == 0x1.5555555555555p-2);
  CHECK(answer.toi_upper == 0x1.5555555555556p-2);
  // Rational coordinates: z = 1/7 - t / 3 ends at 1/7 - 1/3 = -4/21; t = 3/7.
  RationalQuery rational;
  rational.kind = Kind::point_point;
  rational.start[0] = {Fraction{"5", "9"}, Fraction{"-2", "3"}, Fraction{"1", "7"}};
  rational.end[0] = {Fraction{"5", "9"}, Fraction{"-2", "3"}, Fraction{"-4", "21"}};
  rational.start[1] = rational.end[1] = {Fraction{"10", "18"}, Fraction{"2", "-3"}, Fraction{"0", "1"}};
  const Answer sevenths = exact::decide_exactly(rational, 1);
  REQUIRE(sevenths.contact);
  CHECK(sevenths.toi < 3.0 / 7 + 0x1p-54);
  CHECK(std::nextafter(sevenths.toi, 1) == sevenths.toi_upper);
}

TEST_CASE("the same at every scale that doubles have") {
  for (const int exponent : {-1074, -1073, -1022, -600, 0, 600, 1000, 1021}) {
    INFO("2^" << exponent);
    const double s = std::ldexp(1.0, exponent);
    const Query query(
        EdgeEdge{{{{-s, 0, 0}, {s, 0, 0}, {0, -s, s}, {0, s, s}}}, {{{-s, 0, 0}, {s, 0, 0}, {0, -s, -s}, {0, s, -s}}}});
    check_contact(query, 0.5, Nature::crossing, Feature::a, Feature::b, kHalves, kHalves);
  }
}
