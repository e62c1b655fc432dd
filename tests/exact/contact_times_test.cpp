// All touching times, on queries that a person can solve on paper.
// SPDX-License-Identifier: MIT
#include <touchstone/contact_times.hpp>
#include <touchstone/error.hpp>

#include <cmath>
#include <limits>

#include "support/catch.hpp"

using namespace touchstone;

namespace {

/// a = [0, 1] on the x axis; b's ends move on that axis from `start` to `end`.
Query in_line(std::array<double, 2> start, std::array<double, 2> end) {
  return EdgeEdge{{{{0, 0, 0}, {1, 0, 0}, {start[0], 0, 0}, {start[1], 0, 0}}},
                  {{{0, 0, 0}, {1, 0, 0}, {end[0], 0, 0}, {end[1], 0, 0}}}};
}

}  // namespace

TEST_CASE("an edge passes along another: one interval, cut by t_max") {
  // b = [-2, -1] + 4t: touches while -1 + 4t >= 0 and -2 + 4t <= 1.
  const Query query = in_line({-2, -1}, {2, 3});
  const auto times = contact_times(query);
  REQUIRE(times.size() == 1);
  CHECK(times[0].first.compare(0.25) == 0);
  CHECK(times[0].last.compare(0.75) == 0);
  CHECK(times[0].first.to_string() == "1/4");
  const auto cut = contact_times(query, {}, 0.5);
  REQUIRE(cut.size() == 1);
  CHECK(cut[0].last.compare(0.5) == 0);
  const auto instant = contact_times(query, {}, 0.25);
  REQUIRE(instant.size() == 1);
  CHECK(instant[0].first == instant[0].last);
  CHECK(contact_times(query, {}, std::nextafter(0.25, 0.0)).empty());
}

TEST_CASE("a point crosses a triangle within its plane") {
  // On the line y = 1 the triangle covers x in [0, 3], and x = -1 + 8t.
  const Query query =
      VertexFace{{{{-1, 1, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{7, 1, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};
  const auto times = contact_times(query);
  REQUIRE(times.size() == 1);
  CHECK(times[0].first.compare(0.125) == 0);
  CHECK(times[0].last.compare(0.5) == 0);
}

TEST_CASE("an irrational time as text: its polynomial and the doubles around it") {
  // The face turns about its edge f0 f2, and the vertex stays at z = 1: V = 1 - 2 t^2.
  const Query query = VertexFace{{{{0, 0.125, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                 {{{1, 0.125, 1}, {0, 0, 0}, {1, 0, 2}, {0, 1, 0}}}};
  const auto times = contact_times(query);
  REQUIRE(times.size() == 1);
  CHECK(times[0].first.to_string() == "root of (-2) t^2 + (1) in [0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1]");
}

TEST_CASE("an edge that turns inside out in line with another") {
  // b covers 2 -+ 3t: it grows from a point and reaches [0, 1] at t = 1/3.
  const auto growing = contact_times(in_line({2, 2}, {-1, 5}));
  REQUIRE(growing.size() == 1);
  CHECK(growing[0].first.to_string() == "1/3");
  CHECK(growing[0].first.lower() < growing[0].first.upper());
  CHECK(growing[0].last.compare(1.0) == 0);
  // b covers 0 -+ |4 - 8t|: it shrinks to the point 0, which is on a, and grows again.
  const auto turning = contact_times(in_line({4, -4}, {-4, 4}));
  REQUIRE(turning.size() == 1);
  CHECK(turning[0].first.compare(0.0) == 0);
  CHECK(turning[0].last.compare(1.0) == 0);
  // b covers 2 -+ |4 - 8t|, which reaches [0, 1] while |4 - 8t| >= 1.
  const auto leaving = contact_times(in_line({6, -2}, {-2, 6}));
  REQUIRE(leaving.size() == 2);
  CHECK(leaving[0].first.compare(0.0) == 0);
  CHECK(leaving[0].last.compare(0.375) == 0);
  CHECK(leaving[1].first.compare(0.625) == 0);
  CHECK(leaving[1].last.compare(1.0) == 0);
}

TEST_CASE("a face tumbles through a vertex three times") {
  // With e1 = (a, 1, 0), e2 = (0, b, 1) and r = (1, 0, c) the determinant [e1 e2 r] is a b c + 1. The face has the
  // corners -r + 100 e1, -r + 100 e2 and -r - 100 (e1 + e2), so that its plane holds the origin where a b c = -1; there
  // r = -b c e1 + c e2, well inside it. a = 10t - 2, b = 10t - 5, c = 10t - 8.
  const auto corners = [](double a, double b, double c) -> std::array<Vec3, 4> {
    return {{{0, 0, 0}, {-1 + 100 * a, 100, -c}, {-1, 100 * b, 100 - c}, {-1 - 100 * a, -100 - 100 * b, -100 - c}}};
  };
  const auto times = contact_times(VertexFace{corners(-2, -5, -8), corners(8, 5, 2)});
  REQUIRE(times.size() == 3);
  const auto determinant = [](double t) { return (10 * t - 2) * (10 * t - 5) * (10 * t - 8) + 1; };
  for (const ContactInterval& instant : times) {
    CHECK(instant.first == instant.last);
    CHECK(determinant(instant.first.lower() - 1e-9) * determinant(instant.first.upper() + 1e-9) < 0);
  }
  CHECK(times[0].last < times[1].first);
  CHECK(times[1].last < times[2].first);
}

TEST_CASE("exact times compare, reverse and reject what is no time") {
  const auto times = contact_times(in_line({2, 2}, {-1, 5}));
  REQUIRE(times.size() == 1);
  const ExactTime third = times[0].first;
  CHECK(third.reversed().to_string() == "2/3");
  CHECK(third.reversed().reversed() == third);
  CHECK(third < third.reversed());
  CHECK(third != third.reversed());
  CHECK(third.compare(third.lower()) > 0);
  CHECK(third.compare(third.upper()) < 0);
  CHECK(third.compare(-5.0) > 0);
  CHECK_THROWS_AS(third.compare(std::numeric_limits<double>::quiet_NaN()), InvalidQuery);
  CHECK_THROWS_AS(contact_times(in_line({2, 2}, {-1, 5}), {}, 2.0), InvalidQuery);
}
