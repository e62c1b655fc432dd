// The filters' error bounds against exact arithmetic: searched for violations at all magnitudes, and reported.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "filters/apart/separating_direction.hpp"
#include "filters/bound_search.hpp"
#include "filters/step_frame.hpp"
#include "numbers/integers/exact_number.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using numbers::Exact;

namespace {

using ExactVector = std::array<Exact, 3>;

/// [a b c], expanded by the rule of Sarrus: not the order of operations of the code under test.
Exact determinant(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  return a[0] * b[1] * c[2] + a[1] * b[2] * c[0] + a[2] * b[0] * c[1] - a[2] * b[1] * c[0] - a[0] * b[2] * c[1] -
         a[1] * b[0] * c[2];
}

/// The input: four corners at both ends, 24 doubles; frame of an edge-edge query.
struct Case {
  filters::StepFrame<double> frame;
  std::array<ExactVector, 3> start, end;  // u, w, r
};

Case case_of(const std::vector<double>& x) {
  const auto corner = [&](std::size_t side, std::size_t i, std::size_t k) { return x[12 * side + 3 * i + k]; };
  static constexpr std::size_t kMinuend[] = {1, 3, 2};
  static constexpr std::size_t kSubtrahend[] = {0, 2, 0};
  Case result;
  filters::Vector* rounded[2][3] = {{&result.frame.start.u, &result.frame.start.w, &result.frame.start.r},
                                    {&result.frame.end.u, &result.frame.end.w, &result.frame.end.r}};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = corner(side, kMinuend[v], k);
        const double b = corner(side, kSubtrahend[v], k);
        (*rounded[side][v])[k] = a - b;
        (side == 0 ? result.start : result.end)[v][k] = Exact(a) - Exact(b);
      }
    }
  }
  return result;
}

double ratio_of(double computed, const Exact& truth, double bound) {
  if (std::isnan(bound) || !std::isfinite(computed)) return std::nan("");
  const Exact error = Exact(computed) - truth;
  return std::fabs(numbers::approximate_quotient(error, Exact(bound)));
}

double same_side_ratio(const std::vector<double>& x, int which) {
  const Case c = case_of(x);
  const auto [u0, w0, r0] = c.start;
  const auto [u1, w1, r1] = c.end;
  const auto coefficients = filters::coplanarity_coefficients(c.frame);
  const auto bounds = filters::coplanarity_bounds(c.frame);
  if (!bounds.valid) return std::nan("");
  switch (which) {
    case 0: return ratio_of(coefficients[0], determinant(u0, w0, r0), bounds.ends);
    case 1:
      return ratio_of(coefficients[1], determinant(u0, w1, r0) + determinant(u1, w0, r0) + determinant(u0, w0, r1),
                      bounds.middle);
    case 2:
      return ratio_of(coefficients[2], determinant(u1, w1, r0) + determinant(u0, w1, r1) + determinant(u1, w0, r1),
                      bounds.middle);
    default: return ratio_of(coefficients[3], determinant(u1, w1, r1), bounds.ends);
  }
}

/// The input: four corners at both ends and a direction, 27 doubles.
struct ProjectionCase {
  Query query;
  filters::Vector direction;
  filters::RelativeCorners corners;

  explicit ProjectionCase(const std::vector<double>& x) : direction{{x[24], x[25], x[26]}} {
    for (std::size_t i = 0; i < 4; ++i) {
      query.start[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
      query.end[i] = {x[12 + 3 * i], x[12 + 3 * i + 1], x[12 + 3 * i + 2]};
    }
    corners = filters::relative_corners(query);
  }

  /// Of corner i at t = 0, i < 4, or corner i - 4 at t = 1.
  double computed(std::size_t i) const {
    return geometry::dot(direction, i < 4 ? corners.start[i] : corners.end[i - 4]);
  }
  Exact truth(std::size_t i) const {
    const Vec3& position = i < 4 ? query.start[i] : query.end[i - 4];
    const Vec3& origin = query.start[0];
    return (Exact(position.x) - Exact(origin.x)) * Exact(direction[0]) +
           (Exact(position.y) - Exact(origin.y)) * Exact(direction[1]) +
           (Exact(position.z) - Exact(origin.z)) * Exact(direction[2]);
  }
};

double projection_ratio(const std::vector<double>& x) {
  const ProjectionCase c(x);
  const double bound = filters::projection_bound(c.corners, c.direction);
  double worst = std::isnan(bound) ? bound : 0;
  for (std::size_t i = 0; i < 8; ++i) worst = std::max(worst, ratio_of(c.computed(i), c.truth(i), bound));
  return worst;
}

double gap_ratio(const std::vector<double>& x) {
  const ProjectionCase c(x);
  const filters::Gap gap = filters::gap_along(c.corners, c.direction);
  if (!(std::fabs(gap.error) <= std::numeric_limits<double>::max())) return std::nan("");
  std::array<Exact, 8> places;
  for (std::size_t i = 0; i < 8; ++i) places[i] = c.truth(i);
  const auto apart =
      [&](bool first_below) {  // the least difference of one of the upper to one of the lower, at one time
        Exact least(0);
        bool any = false;
        for (std::size_t i = 0; i < 8; ++i) {
          for (std::size_t j = 0; j < 8; ++j) {
            const bool together = i / 4 == j / 4, of_first = i % 4 < 2, other_of_first = j % 4 < 2;
            if (!together || of_first != first_below || other_of_first == first_below) continue;
            const Exact difference = places[j] - places[i];
            if (!any || difference < least) least = difference;
            any = true;
          }
        }
        return least;
      };
  const Exact above = apart(true), below = apart(false);
  return ratio_of(gap.value, above < below ? below : above, gap.error);
}

constexpr int kSteps = kLongSearches ? 10000 : 200;

}  // namespace

TEST_CASE("the same-side bound holds at all magnitudes and is not idle", "[slow]") {
  static const char* names[] = {"b0", "3 b1", "3 b2", "b3"};
  for (int which = 0; which < 4; ++which) {
    Rng rng(0x5a11d + static_cast<std::uint64_t>(which));
    BoundSearch search;
    for (const int exponent : {0, 1, -1, 30, -30, 300, -300}) {
      search_bound(search, rng, 24, exponent, 0, 2, kSteps, [&](const auto& x) { return same_side_ratio(x, which); });
      search_bound(search, rng, 24, exponent, 30, 2, kSteps / 4,
                   [&](const auto& x) { return same_side_ratio(x, which); });
    }
    report(names[which], search);
  }
}

TEST_CASE("near underflow and overflow the same-side bound holds or does not apply") {
  // From products of 2^-1000 down the guard must say so; just above, underflow in a product must stay covered.
  int applies = 0;
  int guarded = 0;
  for (const bool one_tiny : {false, true}) {
    Rng rng(0xdeadULL + one_tiny);
    BoundSearch search;
    for (int exponent = -1074; exponent <= 1020; exponent += exponent < -300 || exponent > 300 ? 2 : 25) {
      const auto ratio = [&](std::vector<double> x) {
        if (one_tiny) {  // u tiny, w huge
          for (std::size_t i : {3, 4, 5, 15, 16, 17}) x[i] = x[i - 3] * (1 + 0x1p-30) + std::ldexp(x[i], -900);
        }
        double worst = 0;
        for (int which = 0; which < 4; ++which) worst = std::max(worst, same_side_ratio(x, which));
        return worst;
      };
      const auto bounds = [&] {
        std::vector<double> x(24);
        for (double& v : x) v = std::ldexp(1 + rng.unit(), exponent);
        return filters::coplanarity_bounds(case_of(x).frame);
      }();
      ++(bounds.valid ? applies : guarded);
      search_bound(search, rng, 24, exponent, rng.one_in(2) ? 40 : 150, 1, 30, ratio);
    }
    report(one_tiny ? "same side, mixed magnitudes" : "same side, 2^-1074 to 2^1020", search, 0);
  }
  CHECK(applies > 0);
  CHECK(guarded > 0);
}

TEST_CASE("where u and w are tiny and r is huge the same-side bound holds or does not apply") {
  // U W R is in range while the products of u and w are subnormal: all along x, where u and w are 0, are the edges
  // apart.
  int applies = 0, guarded = 0;
  Rng rng(0xf1a7);
  BoundSearch search;
  for (int exponent = -535; exponent <= -470; ++exponent) {
    const auto ratio = [&](const std::vector<double>& input) {
      std::vector<double> x(24);
      for (std::size_t i = 0; i < 24; ++i) {
        const bool first_edge = i % 12 < 6;
        x[i] = i % 3 != 0 ? std::ldexp(input[i], exponent) : first_edge ? std::ldexp(input[i / 12 * 12], 500) : 0.0;
      }
      ++(filters::coplanarity_bounds(case_of(x).frame).valid ? applies : guarded);
      double worst = 0;
      for (int which = 0; which < 4; ++which) worst = std::max(worst, same_side_ratio(x, which));
      return worst;
    };
    search_bound(search, rng, 24, 0, 3, 2, 100, ratio);
  }
  report("same side, tiny u and w", search, 0);
  CHECK(applies > 1000);
  CHECK(guarded > 1000);
}

TEST_CASE("where the same-side bound applies nothing overflows") {
  Rng rng(0x0f10);
  int applies = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<double> x(24);
    const int exponent = rng.between(328, 341);
    for (double& v : x) v = std::ldexp(rng.one_in(2) ? 1 + rng.unit() : -1 - rng.unit(), exponent);
    const filters::StepFrame<double> frame = case_of(x).frame;
    if (!filters::coplanarity_bounds(frame).valid) continue;
    ++applies;
    for (const double c : filters::coplanarity_coefficients(frame)) REQUIRE(std::isfinite(c));
  }
  CHECK(applies > 1000);
}

TEST_CASE("where u and w are huge and r is small nothing overflows where the same-side bound applies") {
  Rng rng(0x0f11);
  int applies = 0, guarded = 0;
  for (int i = 0; i < 20000; ++i) {
    // Corners a1 and b1 far away from a0 and b0, which are near each other.
    std::vector<double> x(24);
    const int exponent = rng.between(490, 512);
    for (std::size_t k = 0; k < 24; ++k) {
      const bool far = k / 3 % 2 == 1;
      x[k] = std::ldexp(rng.one_in(2) ? 1 + rng.unit() : -1 - rng.unit(), far ? exponent : -450);
    }
    const filters::StepFrame<double> frame = case_of(x).frame;
    const bool valid = filters::coplanarity_bounds(frame).valid;
    ++(valid ? applies : guarded);
    if (!valid) continue;
    for (const double c : filters::coplanarity_coefficients(frame)) REQUIRE(std::isfinite(c));
  }
  CHECK(applies > 1000);
  CHECK(guarded > 1000);
}

TEST_CASE("the projection bound holds at all magnitudes and is not idle") {
  Rng rng(0xd12ec7);
  BoundSearch search;
  for (const int exponent : {0, -1, 40, -40, 400, -400}) {
    search_bound(search, rng, 27, exponent, 0, 3, kSteps, projection_ratio);
    search_bound(search, rng, 27, exponent, 60, 2, kSteps / 4, projection_ratio);
  }
  for (int exponent = -1074; exponent <= 1020; exponent += 3) {
    search_bound(search, rng, 27, exponent, 40, 1, 20, projection_ratio);
  }
  report("projection", search);
}

TEST_CASE("the gap between elements is off by no more than it says") {
  Rng rng(0x9a9);
  BoundSearch search;
  for (const int exponent : {0, 40, -40, 400, -400, -530, 500}) {
    search_bound(search, rng, 27, exponent, 0, exponent == 0 ? 4 : 1, kSteps, gap_ratio);
  }
  report("gap", search);
}

TEST_CASE("a direction that is not finite never separates") {
  Query query;
  query.kind = Kind::point_point;
  query.start[1] = query.end[1] = {1, 1, 1};
  const auto corners = filters::relative_corners(query);
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(filters::separates(corners, {{1, 0, 0}}));
  for (const double bad : {inf, -inf, nan}) {
    CHECK_FALSE(filters::separates(corners, {{bad, 0, 0}}));
    CHECK_FALSE(filters::separates(corners, {{1, bad, 0}}));
    CHECK_FALSE(filters::separates(corners, {{0, 1, bad}}));
  }
  CHECK_FALSE(filters::separates(corners, {{0, 0, 0}}));
}
