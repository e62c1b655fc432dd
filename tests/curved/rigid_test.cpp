// Bodies that turn, in cases that a person can solve on paper. With q(t) = (1, 0, 0, t) a body turns about the z axis
// by 2 atan(t): the point (5, 0, 0) is at 5 (1 - t^2, 2 t, 0) / (1 + t^2), and at (3, 4, 0) for t = 1/2.
// SPDX-License-Identifier: MIT
#include <cfenv>
#include <cmath>
#include <limits>

#include "curved/expected.hpp"

namespace touchstone::tests {
namespace {

const RigidMotion kQuarterTurn = {{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
const RigidMotion kHalfTurn = {{1, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
const Vec3 kTip = {5, 0, 0};

/// The tip of a spinning rod against a triangle at rest.
CurvedQuery tip_against(const RigidMotion& motion, const Vec3& f0, const Vec3& f1, const Vec3& f2) {
  return curved(Kind::vertex_face, {body(0, kTip), rest(f0), rest(f1), rest(f2)}, {motion});
}

TEST_CASE("a spinning rod's tip goes through a wall") {
  const CurvedQuery query = tip_against(kQuarterTurn, {2, 4, 0}, {4, 4, -1}, {4, 4, 1});
  check_contact(query, {0.5, 0.5, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  check_contact(query, {0.5, 0.5, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}}, 0.5);
  CHECK_FALSE(solved(query, std::nextafter(0.5, 0)).contact);
  // One unit in the last place beside the corner.
  CHECK(solved(tip_against(kQuarterTurn, {2, 4, 0}, {3, 4, 0}, {2, 4, 1})).contact);
  CHECK_FALSE(solved(tip_against(kQuarterTurn, {2, 4, 0}, {std::nextafter(3, 0), 4, 0}, {2, 4, 1})).contact);
}

TEST_CASE("a spinning rod's tip goes through a wall at an irrational time") {
  // 10 t / (1 + t^2) = 1: t = 5 - sqrt(24).
  const CurvedQuery query = tip_against(kQuarterTurn, {0, 1, -8}, {16, 1, -8}, {0, 1, 8});
  const Answer answer = solved(query);
  REQUIRE(answer.contact);
  CHECK(answer.nature == Nature::crossing);
  CHECK(answer.feature_b == Feature::f);
  const long double exact = 5 - std::sqrt(24.0L);
  CHECK(answer.toi < exact);
  CHECK(exact < answer.toi_upper);
  CHECK(std::nextafter(answer.toi, 1) == answer.toi_upper);
  const double x = static_cast<double>(std::sqrt(24.0L));  // of the touching point
  CHECK(std::fabs(answer.weights_b[1] - x / 16) <= 0x1p-50);
  CHECK(answer.weights_b[2] == 0.5);
}

TEST_CASE("a spinning rod's tip grazes a wall") {
  // At the top of its way the tip is at (0, 5, 0), at t = 1/2.
  const Expected top = {0.5, 0.5, Nature::grazing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}};
  check_contact(tip_against(kHalfTurn, {-1, 5, 0}, {1, 5, -1}, {1, 5, 1}), top);
  const double above = std::nextafter(5, 6), below = std::nextafter(5, 4);
  CHECK_FALSE(solved(tip_against(kHalfTurn, {-1, above, 0}, {1, above, -1}, {1, above, 1})).contact);
  const Answer through = solved(tip_against(kHalfTurn, {-1, below, 0}, {1, below, -1}, {1, below, 1}));
  CHECK(through.nature == Nature::crossing);
  CHECK(through.toi < 0.5);
  // The wall 3 x + 4 y = 25: the tip grazes it at (3, 4, 0), where t / (1 - t) = 1/2.
  const double third = 0x1.5555555555555p-2;
  check_contact(tip_against(kHalfTurn, {7, 1, 0}, {-1, 7, -1}, {-1, 7, 1}),
                {third, std::nextafter(third, 1), Nature::grazing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
}

TEST_CASE("a spinning rod's tip touches at exactly t = 0 and t = 1") {
  check_contact(tip_against(kQuarterTurn, {4, 0, 0}, {6, 0, -1}, {6, 0, 1}),
                {0, 0, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  check_contact(tip_against(kQuarterTurn, {5, -1, 0}, {5, 1, -1}, {5, 1, 1}),
                {0, 0, Nature::grazing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  check_contact(tip_against(kQuarterTurn, {0, 4, 0}, {0, 6, -1}, {0, 6, 1}),
                {1, 1, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  check_contact(tip_against(kQuarterTurn, {-1, 5, 0}, {1, 5, -1}, {1, 5, 1}),
                {1, 1, Nature::grazing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  CHECK_FALSE(solved(tip_against(kQuarterTurn, {0, 4, 0}, {0, 6, -1}, {0, 6, 1}), std::nextafter(1, 0)).contact);
}

TEST_CASE("a vertex turns in the plane of a face, where V is identically zero") {
  const CurvedQuery enters = tip_against(kQuarterTurn, {2, 4, 0}, {4, 4, 0}, {3, 9, 0});
  check_contact(enters, {0.5, 0.5, Nature::sustained, Feature::v, Feature::f01, kFirst, kHalves});
  const std::vector<ContactInterval> times = contact_times(enters);
  REQUIRE(times.size() == 1);
  CHECK(times[0].first.to_string() == "1/2");
  CHECK(times[0].last.upper() < 1);  // it leaves through another edge
  CHECK(times[0].last.upper() > 0.5);
  // It passes the corner (3, 4) of a triangle on the outside of its circle, and the middle of an edge that is tangent.
  check_contact(tip_against(kQuarterTurn, {3, 4, 0}, {6, 8, 0}, {5, 9, 0}),
                {0.5, 0.5, Nature::isolated, Feature::v, Feature::f0, kFirst, kFirst});
  check_contact(tip_against(kQuarterTurn, {7, 1, 0}, {-1, 7, 0}, {6, 8, 0}),
                {0.5, 0.5, Nature::isolated, Feature::v, Feature::f01, kFirst, kHalves});
  CHECK_FALSE(solved(tip_against(kQuarterTurn, {-3, -4, 0}, {-6, -8, 0}, {-5, -9, 0})).contact);
}

TEST_CASE("a rod turns through an upright one") {
  const CurvedQuery upright = curved(
      Kind::edge_edge, {body(0, {0, 0, 0}), body(0, kTip), rest({1.5, 2, -1}), rest({1.5, 2, 3})}, {kQuarterTurn});
  check_contact(upright, {0.5, 0.5, Nature::crossing, Feature::a, Feature::b, kHalves, {0.75, 0.25, 0}});
}

TEST_CASE("two mirrored rods turn in one plane") {
  // The right one is the left one, mirrored: both are at x = 3 with their tips for t = 1/2. With q = (0, t, 1, 0) the
  // point (5, 0, 0) is at 5 (t^2 - 1, 2 t, 0) / (1 + t^2).
  const RigidMotion right = {{0, 0, 1, 0}, {0, 1, 1, 0}, {6, 0, 0}, {6, 0, 0}};
  const CurvedQuery rods = curved(
      Kind::edge_edge, {body(0, {0, 0, 0}), body(0, kTip), body(1, {0, 0, 0}), body(1, kTip)}, {kQuarterTurn, right});
  // At t = 0 the rods [0, 5] and [1, 6] of the x axis overlap. The end of the shared part farthest along a is a1. Then
  // they cross in one point, until the tips meet.
  check_contact(rods, {0, 0, Nature::sustained, Feature::overlap, Feature::overlap, kSecond, {0.8, 0.2, 0}});
  const std::vector<ContactInterval> times = contact_times(rods);
  REQUIRE(times.size() == 1);
  CHECK(times[0].last.to_string() == "1/2");
  const CurvedQuery tips = curved(Kind::point_point, {body(0, kTip), body(1, kTip)}, {kQuarterTurn, right});
  check_contact(tips, {0.5, 0.5, Nature::isolated, Feature::p, Feature::q, kFirst, kFirst});
  const CurvedQuery tip_and_rod =
      curved(Kind::point_edge, {body(0, kTip), body(1, {0, 0, 0}), body(1, kTip)}, {kQuarterTurn, right});
  check_contact(tip_and_rod, {0, 0, Nature::isolated, Feature::p, Feature::e, kFirst, {0.8, 0.2, 0}});
  CHECK(contact_times(tip_and_rod).size() == 2);
}

TEST_CASE("bodies that move alike touch always or never") {
  // A screw motion, given twice, with quaternions of different lengths. The rotations are the same ones.
  const RigidMotion screw = {{1, 2, 0, -1}, {3, 0, 1, 1}, {1, 2, 3}, {-4, 0, 7}};
  RigidMotion longer = screw;
  for (double& c : longer.q0) c *= 3;
  for (double& c : longer.q1) c *= 3;
  const auto edges = [&](double height, const RigidMotion& second) {
    return curved(Kind::edge_edge,
                  {body(0, {-1, 0, 0}), body(0, {1, 0, 0}), body(1, {0, -1, height}), body(1, {0, 1, height})},
                  {screw, second});
  };
  for (const RigidMotion& second : {screw, longer}) {
    check_contact(edges(0, second), {0, 0, Nature::sustained, Feature::a, Feature::b, kHalves, kHalves});
    const std::vector<ContactInterval> times = contact_times(edges(0, second));
    REQUIRE(times.size() == 1);
    CHECK(times[0].last.lower() == 1);
    CHECK_FALSE(solved(edges(0x1p-1074, second)).contact);
    const CurvedQuery face =
        curved(Kind::vertex_face, {body(0, {1, 1, 0}), body(1, {0, 0, 0}), body(1, {4, 0, 0}), body(1, {0, 4, 0})},
               {screw, second});
    check_contact(face, {0, 0, Nature::sustained, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  }
}

TEST_CASE("a body at rest") {
  const RigidMotion still = {{1, 1, 1, 1}, {5, 5, 5, 5}, {1, 0, 0}, {1, 0, 0}};
  // (x, y, z) -> (z, x, y) + (1, 0, 0): the face is at x = 1 with corners (1, 0, 0), (1, 4, 0), (1, 0, 4).
  const CurvedQuery query = curved(
      Kind::vertex_face,
      {CurvedCorner::on_curve({{0, 1, 1}, {4, 1, 1}}), body(0, {0, 0, 0}), body(0, {4, 0, 0}), body(0, {0, 4, 0})},
      {still});
  check_contact(query, {0.25, 0.25, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  const CurvedQuery both =
      curved(Kind::edge_edge, {body(0, {0, 0, 0}), body(0, {2, 0, 0}), rest({1, 1, -1}), rest({1, 1, 1})}, {still});
  check_contact(both, {0, 0, Nature::sustained, Feature::a, Feature::b, kHalves, kHalves});
}

TEST_CASE("corners of four bodies in one query") {
  // All turn by a quarter about axes of their own; the edges cross in the plane z = 0 at t = 1/2.
  const auto motion = [](const Vec3& p, double shift) {
    return RigidMotion{{1, 0, 0, 0}, {1, 0, 0, 1}, {p.x, p.y, p.z - shift}, {p.x, p.y, p.z + shift}};
  };
  const CurvedQuery query =
      curved(Kind::edge_edge, {body(0, kTip), body(1, kTip), body(2, kTip), body(3, kTip)},
             {motion({-2, 0, 0}, 1), motion({2, 0, 0}, 1), motion({0, -2, 0}, 0), motion({0, 2, 0}, 0)});
  check_contact(query, {0.5, 0.5, Nature::crossing, Feature::a, Feature::b, kHalves, kHalves});
  CurvedQuery apart = query;
  apart.motions[0].q1 = {1, 0, 0, 2};  // a different weight in each: V has the degree 27 or nearly so
  apart.motions[1].q1 = {1, 0, 0, 3};
  apart.motions[2].q1 = {1, 0, 0, 4};
  solved(apart);
}

TEST_CASE("the same at every scale of lengths and of quaternions") {
  for (const int exponent : {-1074, -1022, -600, 0, 600, 1000, 1020}) {
    INFO("lengths times 2^" << exponent);
    const double s = std::ldexp(1.0, exponent);
    for (const double k : {1.0, std::numeric_limits<double>::denorm_min(), 0x1p1023}) {
      const RigidMotion turn = {{k, 0, 0, 0}, {k, 0, 0, k}, {0, 0, 0}, {0, 0, 0}};
      const CurvedQuery query = curved(
          Kind::vertex_face,
          {body(0, {5 * s, 0, 0}), rest({2 * s, 4 * s, 0}), rest({4 * s, 4 * s, -s}), rest({4 * s, 4 * s, s})}, {turn});
      check_contact(query, {0.5, 0.5, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
    }
  }
}

TEST_CASE("which of two turns a body takes is decided exactly, and the shorter one keeps both poses") {
  const RigidMotion longer = {{1, 0, 0, 0}, {-1, 0, 0, -0.25}, {1, 2, 3}, {4, 5, 6}};
  CHECK(takes_longer_turn(longer));
  const RigidMotion shorter = with_shorter_turn(longer);
  CHECK_FALSE(takes_longer_turn(shorter));
  CHECK(shorter.q0 == longer.q0);
  CHECK(shorter.q1 == std::array<double, 4>{1, 0, 0, 0.25});
  CHECK(shorter.p1.z == 6);
  CHECK(with_shorter_turn(shorter).q1 == shorter.q1);
  // A wall that the longer turn meets.
  const auto tip = [](const RigidMotion& motion) {
    return curved(Kind::vertex_face,
                  {body(0, {1, 0, 0}), rest({-2, -0.5, -1}), rest({2, -0.5, -1}), rest({0, -0.5, 2})}, {motion});
  };
  RigidMotion turn = longer;
  turn.p0 = turn.p1 = {};
  CHECK(solve(tip(turn)).contact);
  CHECK_FALSE(solve(tip(with_shorter_turn(turn))).contact);
  // A right angle is no longer turn, and products of doubles overflow, vanish or are rounded.
  const auto takes = [](const std::array<double, 4>& q0, const std::array<double, 4>& q1) {
    return takes_longer_turn({q0, q1, {}, {}});
  };
  CHECK_FALSE(takes({1, 0, 0, 0}, {0, 0, 0, -1}));
  CHECK(takes_half_turn({{1, 0, 0, 0}, {0, 0, 0, -1}, {}, {}}));
  CHECK(takes_half_turn({{0x1p1000, 0x1p1000, 0, 0}, {0x1p1000, -0x1p1000, 0, 0}, {}, {}}));
  CHECK_FALSE(takes_half_turn({{1, 0, 0, 0}, {0x1p-1074, 0, 0, 1}, {}, {}}));
  CHECK_FALSE(takes_half_turn({{std::numeric_limits<double>::infinity(), 0, 0, 0}, {0, 0, 0, 1}, {}, {}}));
  CHECK(takes({0x1p-600, 0, 0, 0}, {-0x1p-600, 0, 0, 1}));
  CHECK_FALSE(takes({0x1p-600, 0, 0, 0}, {0x1p-600, 0, 0, 1}));
  CHECK(takes({0x1p1000, 0x1p1000, 0, 0}, {0x1p1000, -0x1.0000000000001p1000, 0, 0}));
  CHECK(takes({1, 1, 1, 0}, {0x1p60, -1, -0x1p60, 0}));
  CHECK_FALSE(takes({1, 1, 1, 0}, {0x1p60, 1, -0x1p60, 0}));
  CHECK_FALSE(takes({std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}, {-1, 0, 0, 0}));
}

TEST_CASE("the caller's rounding mode changes no curved answer, and stays") {
  const CurvedQuery wall = tip_against(kQuarterTurn, {0, 1, -8}, {16, 1, -8}, {0, 1, 8});
  const CurvedQuery apart = tip_against(kQuarterTurn, {0, 9, -8}, {16, 9, -8}, {0, 9, 8});
  const Answer expected = solve(wall);
  CHECK(solve(apart).level == Level::filter);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Answer hit = solve(wall);
    const Answer miss = solve(apart);
    const std::size_t times = contact_times(wall).size();
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    CHECK(after == mode);
    CHECK(bit_difference(expected, hit, true) == "");
    CHECK_FALSE(miss.contact);
    CHECK(miss.level == Level::filter);
    CHECK(times == 1);
  }
}

}  // namespace
}  // namespace touchstone::tests
