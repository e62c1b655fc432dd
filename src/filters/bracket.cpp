// SPDX-License-Identifier: MIT
#include "filters/bracket.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "filters/bernstein_cubic.hpp"
#include "filters/refined_root.hpp"
#include "filters/step_frame.hpp"

namespace touchstone::filters {
namespace {

// With U, W and R between these, no product of three underflows or overflows to an effect, and no low part of one does.
// The loss is at most 2^-1074 per product, 2^-500 of U W and 2^-300 of U W R.
constexpr double kLeast = 0x1p-250;
constexpr double kGreatest = 0x1p250;

bool within_range(const Magnitudes& m) noexcept {
  return std::min({m.u, m.w, m.r}) >= kLeast && std::max({m.u, m.w, m.r}) <= kGreatest;
}

Vector at(const Vector& start, const Vector& end, double t) noexcept {
  const double s = 1 - t;
  return {{s * start[0] + t * end[0], s * start[1] + t * end[1], s * start[2] + t * end[2]}};
}

/// A value; the true one is at most `error` away.
struct Bounded {
  double value;
  double error;
};

/// n, f1 and f2 along the axis where n is largest, each times the sign of n there. The side conditions compare them.
struct SideValues {
  std::size_t axis;
  double sign;
  Bounded normal, first, second;
};

// At t, exact_to_one, the vectors u, w and r are off by at most 3 e times their bound: the rounded differences, two
// products and a sum. A component of a cross product of two of them has 2 monomials with 3 + 3 + 2 roundings: 16 e. Its
// slope in t is at most 2 (2 + 2) = 8 times the product of the bounds, since a coordinate changes by at most twice its
// bound over the step. So at any time within h of t the component is off by at most (16 e + 8 h) times the product.
// Within kMargin of the step, bounds and slopes grow by less than 2^-18 of themselves; the constants cover that.
SideValues side_values(bool edges, const StepFrame<double>& f, const Magnitudes& m, double t, double h) noexcept {
  const geometry::Frame<Vector> frame = {at(f.start.u, f.end.u, t), at(f.start.w, f.end.w, t),
                                         at(f.start.r, f.end.r, t)};
  const Vector n = geometry::normal(frame);
  std::size_t k = std::fabs(n[0]) > std::fabs(n[1]) ? 0 : 1;
  if (std::fabs(n[2]) > std::fabs(n[k])) k = 2;
  const double spread = 17 * kUnit + (8 + 0x1p-10) * h;
  const double sign = n[k] > 0 ? 1 : -1;
  return {k,
          sign,
          {std::fabs(n[k]), spread * m.u * m.w},
          {sign * geometry::first_numerator(frame, k), spread * m.r * m.w},
          {sign * geometry::second_numerator(edges, frame, k), spread * m.r * m.u}};
}

/// Where the two lines, or the point and the plane, meet at the roots that the values are for.
enum class Side : std::uint8_t {
  inside,
  outside,
  close,   ///< to a border: a closer look may tell
  unknown  ///< n may be zero
};

Side side_of(bool edges, const SideValues& values) noexcept {
  const auto& [axis, sign, normal, first, second] = values;
  if (!(normal.value > normal.error)) return Side::unknown;
  // Each must be >= 0. `minus` counts its own rounding; the slack of 1 e in `spread` is for terms of e^2.
  const auto minus = [](const Bounded& a, const Bounded& b) {
    return Bounded{a.value - b.value, a.error + b.error + kUnit * (std::fabs(a.value) + std::fabs(b.value))};
  };
  Bounded conditions[4] = {first, second, {}, {}};
  int count;
  if (edges) {
    conditions[2] = minus(normal, first);
    conditions[3] = minus(normal, second);
    count = 4;
  } else {
    conditions[2] = minus(minus(normal, first), second);
    count = 3;
  }
  Side side = Side::inside;
  for (int i = 0; i < count; ++i) {
    if (conditions[i].value < -conditions[i].error) return Side::outside;
    if (!(conditions[i].value > conditions[i].error)) side = Side::close;
  }
  return side;
}

/// A question on its way through this level, with the values computed for it here.
struct Search {
  const Question& question;
  const StepFrame<double>& frame;
  const Magnitudes& magnitudes;
  const BernsteinCubic& cubic;
};

/// Decides at the one root between p and q. `no_contact` says that the elements do not touch there within [0, t_max].
/// Nothing where the root could not be told apart from others or from the ends of the range.
std::optional<Finding> decide_at_root(const Search& s, double p, double q, Answer& answer) {
  const auto& [query, t_max, exact_value, wanted] = s.question;
  const BernsteinCubic::Root root = s.cubic.root_between(p, q);
  if (!root.certain) return std::nullopt;
  if (root.t - root.radius > t_max || root.t + root.radius < 0) return Finding::no_contact;
  const bool edges = query.kind == Kind::edge_edge;
  const SideValues values = side_values(edges, s.frame, s.magnitudes, root.t, root.radius);
  const Side side = side_of(edges, values);
  if (side == Side::outside) return Finding::no_contact;
  if (side == Side::unknown) return Finding::uncertain;
  const bool inside = side == Side::inside;
  const bool in_time = root.t - root.radius > 0 && root.t + root.radius < t_max;
  if (wanted == Wanted::contact && inside && in_time) {
    answer.contact = true;
    return Finding::contact;
  }
  const RefinedRoot refined = refine_root(s.question, {root.t, root.radius, root.slope, s.cubic.slope_error(),
                                                       s.cubic.curvature(), s.magnitudes, values.axis, inside});
  if (refined.finding == Finding::contact) {
    answer.contact = true;
    answer.nature = Nature::crossing;
    answer.toi = refined.toi;
    answer.toi_upper = refined.toi_upper;
    if (edges) {
      answer.feature_a = Feature::a;
      answer.feature_b = Feature::b;
      answer.weights_a = {1 - refined.weights[0], refined.weights[0], 0};
      answer.weights_b = {1 - refined.weights[1], refined.weights[1], 0};
    } else {
      answer.feature_a = Feature::v;
      answer.feature_b = Feature::f;
      answer.weights_a = {1, 0, 0};
      answer.weights_b = refined.weights;
    }
  }
  return refined.finding;
}

/// Decides from the cubic's roots in [low, high], of which [0, 1] is a part. Nothing where roots could not be told
/// apart from each other or from the ends of the range.
std::optional<Finding> decide_over(const Search& s, double low, double high, Answer& answer) {
  using Variations = BernsteinCubic::Variations;
  const Variations whole = s.cubic.variations(low, high);
  if (whole == Variations::none) return Finding::no_contact;
  double split[4] = {low, high};
  const int segments = whole == Variations::one ? 1 : s.cubic.split_points(low, high, split);
  // A root that lies after t_max ends the loop, since its segment ends after it.
  for (int i = 0; i < segments && !(split[i] > s.question.t_max); ++i) {
    const Variations variations = segments == 1 ? whole : s.cubic.variations(split[i], split[i + 1]);
    if (variations == Variations::none) continue;
    if (variations == Variations::uncertain) return std::nullopt;
    const std::optional<Finding> finding = decide_at_root(s, split[i], split[i + 1], answer);
    if (finding != Finding::no_contact) return finding;
  }
  return Finding::no_contact;
}

}  // namespace

Finding decide_in_brackets(const Question& question, Answer& answer) {
  // The first test has computed these already. Keeping them would slow down the many queries that it settles.
  const StepFrame<double> frame = frame_of(question.query);
  const Magnitudes m = {largest(frame.start.u, frame.end.u), largest(frame.start.w, frame.end.w),
                        largest(frame.start.r, frame.end.r)};
  if (!within_range(m)) return Finding::uncertain;
  const BernsteinCubic cubic(coplanarity_coefficients(frame), m.u * m.w * m.r);
  const Search search = {question, frame, m, cubic};
  std::optional<Finding> finding = decide_over(search, 0, 1, answer);
  if (!finding) {
    // A root may lie at an end of the step, where no sign of V is certain. A little beyond the end it is.
    finding = decide_over(search, -BernsteinCubic::kMargin, 1 + BernsteinCubic::kMargin, answer);
  }
  return finding.value_or(Finding::uncertain);
}

}  // namespace touchstone::filters
