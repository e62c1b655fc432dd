// Corners on Bezier curves, in cases that a person can solve on paper.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "curved/expected.hpp"

namespace touchstone::tests {
namespace {

/// From (-1, 0, 0) to (1, 0, 0) on a parabola: z = 4 height t (1 - t).
CurvedCorner ballistic(double height, double y = 0) {
  return CurvedCorner::on_curve({{-1, y, 0}, {0, y, 2 * height}, {1, y, 0}});
}

TEST_CASE("a ballistic arc over an edge") {
  const auto over = [](double height) {
    return curved(Kind::point_edge, {ballistic(1), rest({0, -1, height}), rest({0, 3, height})});
  };
  check_contact(over(1), {0.5, 0.5, Nature::isolated, Feature::p, Feature::e, kFirst, {0.75, 0.25, 0}});
  CHECK_FALSE(solved(over(std::nextafter(1, 0))).contact);
  CHECK_FALSE(solved(over(std::nextafter(1, 2))).contact);
}

TEST_CASE("a ballistic arc under a ceiling") {
  const auto under = [](double height) {
    return curved(Kind::vertex_face,
                  {ballistic(1), rest({-2, 0, height}), rest({2, -2, height}), rest({2, 2, height})});
  };
  check_contact(under(1), {0.5, 0.5, Nature::grazing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  CHECK_FALSE(solved(under(std::nextafter(1, 2))).contact);
  // z = 1/2 at t = (1 - sqrt(1/2)) / 2.
  const Answer answer = solved(under(0.5));
  const long double exact = (1 - std::sqrt(0.5L)) / 2;
  CHECK(answer.nature == Nature::crossing);
  CHECK(answer.toi < exact);
  CHECK(exact < answer.toi_upper);
  CHECK(std::nextafter(answer.toi, 1) == answer.toi_upper);
  const std::vector<ContactInterval> times = contact_times(under(0.5));
  REQUIRE(times.size() == 2);
  CHECK(times[1].first.lower() < 1 - exact);
  CHECK(1 - exact < times[1].first.upper());
}

TEST_CASE("edges on arcs") {
  // Two arcs, one upside down, both edges across the flight: they meet where 4 t (1 - t) = 2 - 4 t (1 - t).
  const auto falling = [](double y) { return CurvedCorner::on_curve({{-1, y, 2}, {0, y, -0.0}, {1, y, 2}}); };
  const CurvedQuery query = curved(Kind::edge_edge, {ballistic(1, -1), ballistic(1, 1), falling(-3), falling(1)});
  // Parallel all along, so V is identically zero; they touch at the one time 1/2.
  check_contact(query, {0.5, 0.5, Nature::isolated, Feature::overlap, Feature::overlap, kSecond, kSecond});
}

TEST_CASE("a cubic passes a plane with a triple root") {
  // z = (2 t - 1)^3.
  const CurvedCorner corner = CurvedCorner::on_curve({{1, 1, -1}, {1, 1, 1}, {1, 1, -1}, {1, 1, 1}});
  const CurvedQuery query = curved(Kind::vertex_face, {corner, rest({0, 0, 0}), rest({4, 0, 0}), rest({0, 4, 0})});
  check_contact(query, {0.5, 0.5, Nature::crossing, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
}

TEST_CASE("a cubic grazes a turning face at an irrational time") {
  // The vertex is at (3 t - 3 t^3, 1/4, 1/4), and the face lies in the plane z = t x / 3: V is a multiple of
  // (t^2 - 1/2)^2, a double root at sqrt(1/2).
  const CurvedCorner vertex =
      CurvedCorner::on_curve({{0, 0.25, 0.25}, {1, 0.25, 0.25}, {2, 0.25, 0.25}, {0, 0.25, 0.25}});
  const CurvedQuery query = curved(
      Kind::vertex_face, {vertex, rest({0, 0, 0}), CurvedCorner::on_curve({{3, 0, 0}, {3, 0, 1}}), rest({0, 1, 0})});
  const double below = 0x1.6a09e667f3bccp-1;
  const double weight = std::sqrt(0.5) / 2;
  check_contact(query, {below,
                        std::nextafter(below, 1),
                        Nature::grazing,
                        Feature::v,
                        Feature::f,
                        kFirst,
                        {0.75 - weight, weight, 0.25}});
}

TEST_CASE("points on the same curve, and on curves that meet once") {
  const CurvedCorner curve = CurvedCorner::on_curve({{0, 0, 0}, {1, 2, 3}, {-1, 5, 2}, {4, 4, 4}});
  check_contact(curved(Kind::point_point, {curve, curve}),
                {0, 0, Nature::sustained, Feature::p, Feature::q, kFirst, kFirst});
  // x = t, y = t (1 - t) against x = t, y = 0: they are together at both ends.
  const CurvedQuery ends = curved(Kind::point_point, {CurvedCorner::on_curve({{0, 0, 0}, {0.5, 0.5, 0}, {1, 0, 0}}),
                                                      CurvedCorner::on_curve({{0, 0, 0}, {1, 0, 0}})});
  check_contact(ends, {0, 0, Nature::isolated, Feature::p, Feature::q, kFirst, kFirst});
  const std::vector<ContactInterval> times = contact_times(ends);
  REQUIRE(times.size() == 2);
  CHECK(times[1].first.lower() == 1);
}

}  // namespace
}  // namespace touchstone::tests
