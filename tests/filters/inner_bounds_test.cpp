// The bounds of the cubic and of the side conditions under search, one by one: what the bracket level makes of them is so far
// from the truth that a wrong one would seldom show in an answer.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "filters/frame_case.hpp"
#include "support/catch.hpp"

// The functions under test are private to this file, which is compiled here a second time.
#include "filters/bracket.cpp"  // NOLINT(bugprone-suspicious-include)

using namespace touchstone;
using namespace touchstone::tests;
using filters::BernsteinCubic;

TEST_CASE("the cubic's value and slope at any time are within their bounds") {
  report("value", searched(81, 1, 20000, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           const double t = time_from(x[24]);
           return over(Exact(3) * Exact(cubic.value(t)) - s.value(Exact(t)), 3 * cubic.value_error());
         }));
  report("slope", searched(82, 1, 40000, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           const double t = time_from(x[24]);
           return over(Exact(3) * Exact(cubic.slope(t)) - s.slope(Exact(t)), 3 * cubic.slope_error());
         }));
}

TEST_CASE("the cubic's slope near a time is as near as the curvature says") {
  for (const double h : {BernsteinCubic::kGreatestRadius, 0x1p-30}) {
    report("slope nearby", searched(83, 1, 10000, [h](const FrameCase&, const std::vector<double>& x) {
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
  report("part", searched(84, 2, 15000, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           const double p = time_from(x[24]), q = time_from(x[25]);
           const auto part = cubic.part(p, q);
           double worst = 0;
           for (std::size_t i = 0; i < 4; ++i) {
             const Exact truth = s.blossom(Exact(i > 0 ? q : p), Exact(i > 1 ? q : p), Exact(i > 2 ? q : p));
             worst = std::max(worst, over(Exact(3) * Exact(part[i]) - truth, 3 * cubic.part_error()));
           }
           return worst;
         }));
}

TEST_CASE("the side conditions near a root are within their bounds") {
  static constexpr std::array<double, 5> kDistances{0, 0x1p-52, 0x1p-40, 0x1p-20, BernsteinCubic::kGreatestRadius};
  for (const double h : kDistances) {
    const auto search = searched(85, 1, 5000, [h](const FrameCase& s, const std::vector<double>& x) {
      const double t = time_from(x[24]);
      const filters::SideValues at = filters::side_values(s.query.kind, s.frame, {s.size.u, s.size.w, s.size.r}, t, h);
      double worst = 0;
      for (const double side : {-h, h}) {
        const Exact time = Exact(std::clamp(t + side, 0.0, 1.0));
        const Exact sign(at.sign);
        worst = std::max({worst, over(sign * s.cross(0, 1, at.axis, time) - Exact(at.normal.value), at.normal.error),
                          over(sign * s.cross(2, 1, at.axis, time) - Exact(at.first.value), at.first.error),
                          over(sign * s.cross(2, 0, at.axis, time) - Exact(at.second.value), at.second.error)});
      }
      return worst;
    });
    report(("sides within " + std::to_string(h)).c_str(), search);
  }
}
