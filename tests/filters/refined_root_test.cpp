// Searches, one by one, for violations of the bounds that give a root's neighbouring doubles and its weights.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include <touchstone/solve.hpp>

#include "exact/exact.hpp"
#include "filters/contact_values_steps.hpp"
#include "filters/frame_case.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"

// The functions under test are private to this file, which is compiled here a second time.
#include "filters/refined_root.cpp"  // NOLINT(bugprone-suspicious-include)

using namespace touchstone;
using namespace touchstone::tests;
using filters::BernsteinCubic;
using filters::Offset;
using filters::SimpleRoot;

namespace {

bool is_usable(const FrameCase& s) { return s.usable(); }

/// The significand of x, times a power of two from 2^least to 2^greatest that its low bits choose.
double scale_from(double x, int least, int greatest) {
  int exponent = 0;
  const double s = std::frexp(x, &exponent);  // significand
  const auto choice = static_cast<int>(std::fabs(s) * 0x1p30) % (greatest - least + 1);
  return std::ldexp(s, least + choice);
}

/// How much of its bound f1 = r x w along an axis needs at a root that is `distance` from t, give or take `slip`.
double component_ratio(const FrameCase& sample, double t, double distance, double slip) {
  if (!(t + distance + slip >= 0 && t + distance + slip <= 1)) {
    distance = -distance;
    slip = -slip;
  }
  const std::size_t k = 2;
  const auto corners = filters::corners_of(sample.query);
  const auto w = filters::moving_difference(corners, 3, 2, t), r = filters::moving_difference(corners, 2, 0, t);
  const filters::Component first = filters::cross_component(r, w, k);
  const Exact truth = sample.cross(2, 1, k, Exact(t) + Exact(distance) + Exact(slip));
  // The same component less its true value, as two doubles: its errors stay.
  const double high = numbers::approximate_quotient(truth, Exact(1));
  const double low = numbers::approximate_quotient(truth - Exact(high), Exact(1));
  const Offset offset{distance, std::fabs(slip)};
  const double rest = (first.value.high - high) + (first.value.low - low);
  const double bound = filters::component_spread(offset) * (sample.size.r * sample.size.w);
  return std::fabs(filters::at_root({rest, first.slope}, offset)) / bound;
}

/// A root of a sample's cubic as seen from a time at some distance: the promises of SimpleRoot hold.
struct SeenRoot {
  bool found = false;
  SimpleRoot root{};
};

SeenRoot seen_from(const FrameCase& s, const BernsteinCubic& cubic, double away,
                   double farthest = BernsteinCubic::kGreatestRadius) {
  if (cubic.variations(0, 1) != BernsteinCubic::Variations::one) return {};
  const BernsteinCubic::Root root = cubic.root_between(0, 1);
  if (!root.certain) return {};
  const double t = filters::exact_to_one(std::clamp(root.t + away, 0.0, 1.0));
  const double slope = cubic.slope(t);
  const double radius = std::fabs(t - root.t) + root.radius;
  const bool promised = radius <= farthest && (slope > 0) == (root.slope > 0) &&
                        cubic.slope_error() + cubic.curvature() * radius <= 0.484375 * std::fabs(slope) && s.usable();
  return {promised, {t, radius, slope, cubic.slope_error(), cubic.curvature()}};
}

/// How far a root is from `near`, which is next to it: a step of Newton's with exact values, as good as the root
/// itself.
double missing(const FrameCase& s, const Exact& near) {
  return -numbers::approximate_quotient(s.value(near), s.slope(near));
}

}  // namespace

TEST_CASE("components at a root are as near as they say", "[slow]") {
  struct Place {
    double distance, slip;
  };
  static constexpr std::array<Place, 9> kPlaces = {{{0, 0},
                                                    {0x1p-53, 0},
                                                    {0x1p-52, 0},
                                                    {0x1p-49, 0},
                                                    {0x1p-47, 0},
                                                    {0x1p-40, 0},
                                                    {0x1p-20, 0},
                                                    {0, 0x1p-80},
                                                    {0x1p-40, 0x1p-76}}};
  for (const Place& place : kPlaces) {
    // Between these the slope's errors and the curvature weigh alike: it takes more to tell them apart.
    const int steps = place.distance > 0x1p-53 && place.distance < 0x1p-45 ? 20000 : 6000;
    const auto search = searched(86, 1, steps, is_usable, [&](const FrameCase&, const std::vector<double>& x) {
      // With b0 near the origin r and w are as large as their bounds, and their low parts as long as can be.
      std::vector<double> spread_out = x;
      for (const std::size_t side : {0u, 12u}) {
        for (std::size_t k = 0; k < 3; ++k) spread_out[side + 6 + k] *= 0x1p-40;
      }
      return component_ratio(FrameCase(spread_out), time_from(x[24]), place.distance, place.slip);
    });
    char name[80];
    std::snprintf(name, sizeof name, "component at a root %a away, give or take %a", place.distance, place.slip);
    // Nearer than this there are the errors of the double-doubles alone, which have a search of their own.
    report(name, search, place.distance + place.slip < 0x1p-60 ? 0 : kNear);
  }
}

TEST_CASE("the step to a root is off by no more than it says") {
  report("step to a root", searched(87, 1, 20000, is_usable, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           const auto [found, root] = seen_from(s, cubic, scale_from(x[24], -56, -11));
           if (!found) return std::nan("");
           const double value = filters::contact_values(s.query, root.t, 0).coplanarity;
           const double error = filters::kCoplanarityError * cubic.size();
           const Offset offset = filters::offset_of(root, root.t, value, error);
           return std::fabs(missing(s, Exact(root.t) + Exact(offset.value))) / offset.error;
         }));
}

TEST_CASE("the step to a root from another time is off by no more than it says") {
  report("step from beside", searched(88, 3, 20000, is_usable, [](const FrameCase& s, const std::vector<double>& x) {
           const BernsteinCubic cubic = s.cubic();
           // Seen from farther away than roots are, so that the slopes there and here differ by as much as they may;
           // the curvature is then far above its own error. The time is anywhere, or near the root.
           const double away = scale_from(x[24], -20, -2);
           const auto [found, root] = seen_from(s, cubic, away, 0.25);
           const double time = root.t + scale_from(x[25], -50, -3) - (x[26] > 0 ? away : 0);
           if (!found || !(time >= 0 && time <= 1) || !(std::fabs(time - root.t) <= root.radius)) return std::nan("");
           // V there, as far off as an exact value may be.
           const double value = numbers::approximate_quotient(s.value(Exact(time)), Exact(3)) *
                                (1 + 6 * filters::kUnit * (2 * share(x[26]) - 1));
           const Offset offset = filters::offset_of(root, time, value, filters::exact_value_error(value));
           return std::fabs(missing(s, Exact(time) + Exact(offset.value))) / offset.error;
         }));
}

TEST_CASE("the step to a root of a line is off by what the value is off by") {
  // Where the slope is known for certain: V = slope (t - root).
  BoundSearch search;
  Rng rng(89);
  search_bound(search, rng, 3, 0, 3, 4, 5000, [](const std::vector<double>& x) {
    const SimpleRoot root{0.5, 0x1p-10, x[0], 0, 0};
    const double value = x[1] * 0x1p-20;  // within 2^-50, as exact values are
    const Exact truth = Exact(value) + Exact((2 * share(x[2]) - 1) * 0x1p-50 * std::fabs(value));
    const Offset offset = filters::offset_of(root, 0.5, value, filters::exact_value_error(value));
    const Exact error = truth + Exact(offset.value) * Exact(root.slope);  // times the slope
    return std::fabs(numbers::approximate_quotient(error, Exact(root.slope) * Exact(offset.error)));
  });
  report("step along a line", search);
}

namespace {

/// The corners moved such that the lines all but meet at a time and at given weights.
std::vector<double> meeting(std::vector<double> corners, double t, double f1, double f2) {
  const std::vector<double> x = corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](std::size_t i) { return (1 - t) * x[3 * i + k] + t * x[12 + 3 * i + k]; };
    const double apart = (at(0) + f1 * (at(1) - at(0))) - (at(2) + f2 * (at(3) - at(2)));
    for (const std::size_t i : {6u, 9u, 18u, 21u}) corners[i + k] += apart;
  }
  return corners;
}

/// A short edge that a long one sweeps over while it turns: n stays, and the first weight is as curved in t as can be.
std::vector<double> swept(const std::vector<double>& x) {
  constexpr double kShort = 0x1p-8;
  const std::array<double, 24> base = {0, 0, 0, kShort, kShort, 0, 1,  -1, 1,  2,    -0.5, 1,
                                       0, 0, 0, kShort, kShort, 0, -1, 1,  -1, -1.5, 0,    -1};
  std::vector<double> corners(24);
  for (std::size_t i = 0; i < 24; ++i) corners[i] = base[i] + (i % 12 < 6 ? kShort : 1.0) * 0x1p-6 * x[i];
  return meeting(corners, 0.5 + 0x1p-6 * x[24], share(x[25]), 0.5 * share(x[26]));
}

/// The error of the weights of a contact that refine_root finds, over 2^-50. It sees the root from the side of `away`,
/// from about as far as it can without being uncertain of the weights. NaN when it is never certain of a contact.
double weights_ratio(const FrameCase& s, double away) {
  const BernsteinCubic cubic = s.cubic();
  const SeenRoot nearest = seen_from(s, cubic, 0);
  if (!nearest.found) return std::nan("");
  std::size_t axis = 0;
  double greatest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = std::fabs(numbers::approximate_quotient(s.cross(0, 1, k, Exact(nearest.root.t)), Exact(1)));
    if (n > greatest) {
      greatest = n;
      axis = k;
    }
  }
  filters::RefinedRoot refined;
  const auto contact_from = [&](double distance) {
    auto [found, root] = seen_from(s, cubic, distance);
    if (!found) return false;
    root.magnitudes = {s.size.u, s.size.w, s.size.r};
    root.axis = axis;
    root.inside = true;
    refined = filters::refine_root({s.query, 1, exact::coplanarity_at}, root);
    return refined.finding == filters::Outcome::contact;
  };
  away = std::copysign(0x1p-11, away);
  while (!contact_from(away)) {
    away *= 0.9375;
    if (std::fabs(away) < 0x1p-50) return std::nan("");
  }
  Exact time(refined.toi);
  for (int i = 0; i < 3; ++i) time = time + Exact(missing(s, time));
  const Exact n = s.cross(0, 1, axis, time);
  const auto off = [&](double weight, const Exact& numerator) {
    return std::fabs(numbers::approximate_quotient(Exact(weight) * n - numerator, n));
  };
  const Exact first = s.cross(2, 1, axis, time), second = s.cross(2, 0, axis, time);
  for (const Exact& f : {first, second}) {
    if (f.sign() * n.sign() < 0 || (n - f).sign() * n.sign() < 0) return std::nan("");
  }
  const auto [f1, f2, unused] = refined.weights;
  return 0x1p50 * std::max({off(f1, first), off(1 - f1, n - first), off(f2, second), off(1 - f2, n - second)});
}

}  // namespace

TEST_CASE("weights are within 2^-50 whenever they are certain", "[slow]") {
  for (const bool one_swept : {true, false}) {
    Rng rng(90);
    BoundSearch search;
    search_bound(search, rng, 28, 0, 0, 4, kLongSearches ? 2000 : 100, [&](const std::vector<double>& x) {
      const FrameCase sample(
          one_swept ? swept(x) : meeting({x.begin(), x.begin() + 24}, time_from(x[24]), share(x[25]), share(x[26])));
      return sample.usable() ? weights_ratio(sample, x[27]) : std::nan("");
    });
    report(one_swept ? "weights of an edge that is swept over" : "weights", search);
  }
}

TEST_CASE("a root so near 0 that V underflows beside it is not mistaken for another") {
  // V = 2^-500 (r - t (r + 2^-250)) with r = 2^-580: a root near 2^-330, where V is below every double.
  EdgeEdge query{{{{0, 0, 0}, {0x1p-250, 0, 0}, {0x1p-252, -0x1p-251, 0x1p-580}, {0x1p-252, 0x1p-251, 0x1p-580}}},
                 {{{0, 0, 0}, {0x1p-250, 0, 0}, {0x1p-252, -0x1p-251, -0x1p-250}, {0x1p-252, 0x1p-251, -0x1p-250}}}};
  const Answer exact_one = exact::decide_exactly(query, 1);
  REQUIRE(exact_one.contact);
  CHECK(exact_one.toi < 0x1p-329);
  CHECK(decision_difference(solve(query), exact_one).empty());
}
