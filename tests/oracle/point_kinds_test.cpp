// Point against edge and point against point: no V, so a contact is isolated or sustained.
// SPDX-License-Identifier: MIT
#include "oracle/expected.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// The point moves from `from` to `to`; the edge is on the x axis.
Query to_edge(const Vec3& from, const Vec3& to, double e0, double e1) {
  return PointEdge{{{from, {e0, 0, 0}, {e1, 0, 0}}}, {{to, {e0, 0, 0}, {e1, 0, 0}}}};
}

}  // namespace

TEST_CASE("a point reaches an edge for an instant") {
  const auto fall = [](double x, double e0, double e1) { return to_edge({x, 1, -2}, {x, -1, 2}, e0, e1); };
  check_contact(fall(0, -1, 3), {at(0.5), Nature::isolated, Feature::p, Feature::e, kFirst, {0.75, 0.25, 0}});
  check_contact(fall(-1, -1, 3), {at(0.5), Nature::isolated, Feature::p, Feature::e0, kFirst, kFirst});
  check_contact(fall(3, -1, 3), {at(0.5), Nature::isolated, Feature::p, Feature::e1, kFirst, kSecond});
  check_contact(fall(3, 3, 3), {at(0.5), Nature::isolated, Feature::p, Feature::e0, kFirst, kFirst});
  check_no_contact(fall(std::nextafter(3, 4), -1, 3));
  check_no_contact(fall(2, 3, 3));
  check_no_contact(fall(0, -1, 3), std::nextafter(0.5, 0));
}

TEST_CASE("a point passes the line of an edge twice but never reaches it") {
  // y and z vanish at 1/2 and 1/3: no common root.
  check_no_contact(to_edge({0, 1, 1}, {0, -1, -2}, -1, 1));
}

TEST_CASE("an irrational time on an edge") {
  // In the plane y = 0, the edge from (-1, t) to (2t, -1) reaches the origin at sqrt(1/2).
  const Query query = PointEdge{{{{0, 0, 0}, {-1, 0, 0}, {0, 0, -1}}}, {{{0, 0, 0}, {-1, 0, 1}, {2, 0, -1}}}};
  check_contact(
      query,
      {kSqrtHalf, Nature::isolated, Feature::p, Feature::e, kFirst, {1 - kSqrtTwoMinusOne, kSqrtTwoMinusOne, 0}});
}

TEST_CASE("a point slides along the line of an edge") {
  check_contact(to_edge({-1, 0, 0}, {1, 0, 0}, 0, 8),
                {at(0.5), Nature::sustained, Feature::p, Feature::e0, kFirst, kFirst});
  check_contact(to_edge({-1, 0, 0}, {1, 0, 0}, 8, 0),
                {at(0.5), Nature::sustained, Feature::p, Feature::e1, kFirst, kSecond});
  check_contact(to_edge({-1, 0, 0}, {1, 0, 0}, 0, 0),
                {at(0.5), Nature::isolated, Feature::p, Feature::e0, kFirst, kFirst});
  check_contact(to_edge({-1, 0, 0}, {1, 0, 0}, 0, 8),
                {at(0.5), Nature::isolated, Feature::p, Feature::e0, kFirst, kFirst}, 0.5);
  check_contact(to_edge({2, 0, 0}, {9, 0, 0}, 0, 8),
                {at(0), Nature::sustained, Feature::p, Feature::e, kFirst, {0.75, 0.25, 0}});
  check_contact(to_edge({8, 0, 0}, {9, 0, 0}, 0, 8),
                {at(0), Nature::isolated, Feature::p, Feature::e1, kFirst, kSecond});
  check_no_contact(to_edge({9, 0, 0}, {10, 0, 0}, 0, 8));
}

TEST_CASE("an edge on the point's line turns over") {
  // On the x axis, e0 = 8t and e1 = 8 - 8t: the edge has no length at t = 1/2, when it is at 4.
  const auto turning = [](double from, double to) {
    return Query(PointEdge{{{{from, 0, 0}, {0, 0, 0}, {8, 0, 0}}}, {{{to, 0, 0}, {8, 0, 0}, {0, 0, 0}}}});
  };
  check_contact(turning(2, 2), {at(0), Nature::sustained, Feature::p, Feature::e, kFirst, {0.75, 0.25, 0}});
  // The point at -2 + 12t is behind both ends until it meets them at 1/2, and ahead of both after.
  check_contact(turning(-2, 10), {at(0.5), Nature::isolated, Feature::p, Feature::e0, kFirst, kFirst});
}

TEST_CASE("point against point") {
  const auto meeting = [](const Vec3& q_from, const Vec3& q_to) {
    return Query(PointPoint{{{{0, 0, 0}, q_from}}, {{{0, 0, 0}, q_to}}});
  };
  const auto isolated = [](Times times) {
    return Expected{times, Nature::isolated, Feature::p, Feature::q, kFirst, kFirst};
  };
  check_contact(meeting({1, 2, -3}, {-2, -4, 6}), isolated(kOneThird));
  check_contact(meeting({1, 0, 0}, {0, 0, 0}), isolated(at(1)));
  check_contact(meeting({0, 0, 0}, {1, 0, 0}), isolated(at(0)));
  check_contact(meeting({0, 0, 0}, {1, 0, 0}), isolated(at(0)), 0);
  check_no_contact(meeting({1, 2, -3}, {-2, -4, 6}), kOneThird.first);
  check_no_contact(meeting({1, 2, 0}, {-2, -3, 0}));
  check_no_contact(meeting({1, 0, 0}, {0x1p-1074, 0, 0}));
  check_no_contact(meeting({1, 0, 0}, {2, 0, 0}));
  check_no_contact(meeting({1, 0, 0}, {1, 0, 0}));

  const Query together = PointPoint{{{{1, 2, 3}, {1, 2, 3}}}, {{{4, 5, 7}, {4, 5, 7}}}};
  check_contact(together, {at(0), Nature::sustained, Feature::p, Feature::q, kFirst, kFirst});
  check_contact(together, isolated(at(0)), 0);
}
