// The bounds of the cubic and of the side conditions under search, one by one. The bracket level is rarely near its
// bounds, so a wrong one would seldom show in an answer.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "filters/frame_case.hpp"
#include "filters/root_sides.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using filters::BernsteinCubic;

namespace {

filters::MagnitudesOf<double> magnitudes(const FrameCase& s) { return {s.size.u, s.size.w, s.size.r}; }
bool in_range(const FrameCase& s) { return filters::within_range(magnitudes(s)); }

}  // namespace

TEST_CASE("the cubic's value and slope at any time are within their bounds") {
  report("value", searched(81, 1, 20000, in_range, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           const double t = time_from(x[24]);
           return over(Exact(3) * Exact(cubic.value(t)) - s.value(Exact(t)), 3 * cubic.value_error());
         }));
  report("slope", searched(82, 1, 40000, in_range, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           const double t = time_from(x[24]);
           return over(Exact(3) * Exact(cubic.slope(t)) - s.slope(Exact(t)), 3 * cubic.slope_error());
         }));
}

TEST_CASE("the cubic's slope near a time is as near as the curvature says") {
  for (const double h : {BernsteinCubic::kGreatestRadius, 0x1p-30}) {
    report("slope nearby", searched(83, 1, 10000, in_range, [h](const FrameCase&, const std::vector<double>& x) {
             // Where u and w all but stand still V'' is all but zero, and its errors are all there is.
             std::vector<double> still = x;
             for (std::size_t k = 0; k < 3 && x[0] > x[1]; ++k) {
               still[15 + k] = x[12 + k] + (x[3 + k] - x[k]);
               still[21 + k] = x[18 + k] + (x[9 + k] - x[6 + k]);
             }
             const FrameCase sample(still);
             const BernsteinCubic cubic = sample.cubic();
             const double t = time_from(x[24]);
             const double spread = cubic.slope_error() + cubic.curvature() * h;
             double worst = 0;
             for (const double away : {-h, h}) {
               const Exact at = Exact(std::clamp(t + away, 0.0, 1.0));
               worst = std::max(worst, over(Exact(3) * Exact(cubic.slope(t)) - sample.slope(at), 3 * spread));
             }
             return worst;
           }));
  }
}

TEST_CASE("the cubic's coefficients over a part of the step are within their bound") {
  report("part", searched(84, 2, 15000, in_range, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           const double p = time_from(x[24]), q = time_from(x[25]);
           const auto part = cubic.restricted_to(p, q);
           double worst = 0;
           for (std::size_t i = 0; i < 4; ++i) {
             const Exact truth = s.blossom(Exact(i > 0 ? q : p), Exact(i > 1 ? q : p), Exact(i > 2 ? q : p));
             worst = std::max(worst, over(Exact(3) * Exact(part[i]) - truth, 3 * cubic.restriction_error()));
           }
           return worst;
         }));
}

TEST_CASE("the side conditions near a root are within their bounds") {
  static constexpr std::array<double, 5> kDistances{0, 0x1p-52, 0x1p-40, 0x1p-20, BernsteinCubic::kGreatestRadius};
  for (const double h : kDistances) {
    const auto search = searched(85, 1, 5000, in_range, [h](const FrameCase& s, const std::vector<double>& x) {
      const double t = time_from(x[24]);
      const auto at = filters::side_values(Kind::edge_edge, s.frame, magnitudes(s), t, h);
      double worst = 0;
      for (const double side : {-h, h}) {
        const Exact time = Exact(std::clamp(t + side, 0.0, 1.0));
        const Exact sign(std::copysign(1.0, at.signed_normal));
        worst = std::max({worst, over(sign * s.cross(0, 1, at.axis, time) - Exact(at.normal.value), at.normal.error),
                          over(sign * s.cross(2, 1, at.axis, time) - Exact(at.first.value), at.first.error),
                          over(sign * s.cross(2, 0, at.axis, time) - Exact(at.second.value), at.second.error)});
      }
      return worst;
    });
    report(("sides within " + std::to_string(h)).c_str(), search);
  }
}

TEST_CASE("no side is certain where n may be zero") {
  // Edges that are all but parallel, and as near to each other as n is to zero.
  Rng rng(91);
  int unknown = 0, known = 0;
  for (int i = 0; i < 40000; ++i) {
    std::vector<double> x(24);
    const int nearness = rng.between(44, 53);
    for (std::size_t k = 0; k < 3; ++k) {
      const double u = 1 + rng.unit();
      const double apart = std::ldexp(rng.symmetric(), -nearness);
      for (const std::size_t side : {0u, 12u}) {
        x[side + 3 + k] = u;
        x[side + 6 + k] = apart;
        x[side + 9 + k] = u + std::ldexp(rng.symmetric(), -nearness);
      }
    }
    const FrameCase s(x);
    const auto found = filters::side_values(Kind::edge_edge, s.frame, magnitudes(s), 0.0, 0.0);
    const auto sides = filters::sides_of(Kind::edge_edge, found);
    ++(sides.unknown ? unknown : known);
    const Exact at(0);
    Exact n = s.cross(0, 1, found.axis, at), first = s.cross(2, 1, found.axis, at),
          second = s.cross(2, 0, found.axis, at);
    if (n.sign() < 0) {
      n = -n;
      first = -first;
      second = -second;
    }
    const bool outside = first.sign() < 0 || second.sign() < 0 || (n - first).sign() < 0 || (n - second).sign() < 0;
    CAPTURE(i);
    if (sides.outside) REQUIRE(outside);
    if (sides.inside) REQUIRE(!outside);
  }
  CHECK(unknown > 1000);
  CHECK(known > 1000);
}

TEST_CASE("a root is certain to within the greatest radius, or not at all") {
  // V = slope (1 / 2 - t) with u and w along x and y: the flatter, the larger the radius.
  int certain = 0, uncertain = 0;
  for (int exponent = 10; exponent <= 50; ++exponent) {
    const double rise = std::ldexp(1.0, -exponent);
    std::vector<double> x = {0, 0, 0, 1, 0, 0, 1, 1, rise, 1, 2, rise, 0, 0, 0, 1, 0, 0, 1, 1, -rise, 1, 2, -rise};
    const BernsteinCubic cubic = FrameCase(x).cubic();
    if (cubic.variations(0, 1) != BernsteinCubic::Variations::one) continue;
    const BernsteinCubic::Root root = cubic.root_between(0, 1);
    ++(root.certain ? certain : uncertain);
    if (root.certain) CHECK(root.radius <= 0x1p-10);  // the slope's error bound assumes it
  }
  CHECK(certain > 10);
  CHECK(uncertain > 0);
}
