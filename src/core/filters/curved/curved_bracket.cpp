// SPDX-License-Identifier: MIT
#include "filters/curved/curved_bracket.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "filters/curved/curved_entry.hpp"
#include "filters/curved/curved_frame.hpp"
#include "filters/curved/curved_projection.hpp"
#include "filters/curved/curved_time.hpp"
#include "filters/curved/curved_walk.hpp"
#include "filters/step_frame.hpp"

namespace touchstone::filters {
namespace {

using numbers::Bounded;
using numbers::BoundedPair;
using numbers::kRounding;
using Index = std::size_t;

/// Where the two lines, or the point and the plane, meet at the roots that the values are for; or whether a point is on
/// an edge or another point.
enum class Side : std::uint8_t {
  inside,
  outside,
  close,   ///< to a border: a closer look may tell
  unknown  ///< n may be zero
};

/// The conditions at a root, each of which must be >= 0, and the denominators of the fractions or weights that they are
/// numerators of.
template <class N>
struct Conditions {
  N normal;  ///< > 0
  std::array<N, 2> denominators;
  std::array<N, 4> values;
  int count = 0;
};

/// Along the axis where n is largest, all with the sign of n there. Edges: f1 and m1 n - f1, f2 and m2 n - f2.
/// Vertex-face: the weights of f0, f1 and f2.
template <class Vector, class N>
Conditions<N> conditions_of(Kind kind, const Vector& between, const Vector& u, const Vector& w,
                            const N& first_multiplier, const N& second_multiplier, Index axis, bool negative) {
  const auto flipped = [negative](const N& x) { return negative ? -x : x; };
  const N n = flipped(geometry::cross_component(u, w, axis));
  if (kind == Kind::edge_edge) {
    const N first = flipped(geometry::cross_component(between, w, axis));
    const N second = flipped(geometry::cross_component(between, u, axis));
    const N whole[2] = {first_multiplier * n, second_multiplier * n};
    return {n, {whole[0], whole[1]}, {first, whole[0] - first, second, whole[1] - second}, 4};
  }
  // With r = A - B in place of B - A, both change their sign.
  const N first = -flipped(geometry::cross_component(between, w, axis));
  const N second = -flipped(geometry::cross_component(u, between, axis));
  const N whole = second_multiplier * n;
  return {n, {whole, whole}, {(whole - first) - second, first, second, whole}, 3};
}

template <class N>
Side side_of(const Conditions<N>& conditions) noexcept {
  if (conditions.normal.sign() <= 0) return Side::unknown;
  Side side = Side::inside;
  for (Index i = 0; i < static_cast<Index>(conditions.count); ++i) {
    const int sign = conditions.values[i].sign();
    if (sign < 0) return Side::outside;
    if (sign == 0) side = Side::close;
  }
  return side;
}

struct NormalAxis {
  Index axis;
  bool negative;
};
NormalAxis largest_axis(const std::array<double, 3>& n) noexcept {
  Index axis = std::fabs(n[0]) > std::fabs(n[1]) ? 0 : 1;
  if (std::fabs(n[2]) > std::fabs(n[axis])) axis = 2;
  return {axis, n[axis] < 0};
}

/// A query on its way through this level.
class CurvedBracketSearch {
 public:
  CurvedBracketSearch(const CurvedQuery& query, double t_max, const CurvedFrame& frame, Answer& answer) noexcept
      : query_(query),
        kind_(query.kind),
        t_max_(t_max),
        frame_(frame),
        answer_(answer),
        between_slope_(slope_of(frame.between)),
        u_slope_(has_cubic(kind_) ? slope_of(frame.u) : 0),
        w_slope_(kind_ != Kind::point_point ? slope_of(frame.w) : 0),
        first_slope_(slope_of(frame.first_multiplier)),
        second_slope_(slope_of(frame.second_multiplier)) {}

  /// Decides from the roots of p: V, or for a point and an edge, or two points, a component that vanishes where they
  /// touch.
  Outcome decide(const ScalarForm& p, Index component = 0) noexcept;

  /// Whether `decide` was uncertain about the touching at one time, so that nothing else is likely to show a miss.
  bool contact_is_likely() const noexcept { return contact_is_likely_; }

 private:
  /// A subinterval of [0, 1] with p's coefficients in the Bernstein basis over it.
  struct Subinterval {
    double low, high;
    double error;
    Index cuts;  ///< how often it was cut out of a larger one
    std::array<double, kMostCurvedDegree + 1> b;
  };
  enum class Variations : std::uint8_t { none, one, uncertain };

  Variations variations(const ScalarForm& p, const Subinterval& interval) const noexcept;
  Outcome decide_at_root(const ScalarForm& p, const Subinterval& interval) noexcept;
  struct Time {
    bool known = false;
    BoundedPair root;
    double lower = 0;  ///< the greatest double below the root, which is no double itself
  };
  Time time_of(const ScalarForm& slope, const Subinterval& interval, double t, double radius) const noexcept;
  Outcome refine(const ScalarForm& slope, const Subinterval& interval, double t, double radius) noexcept;
  BoundedPair value(const FrameAt& frame) const noexcept;
  template <class Frame>
  Side side_of_point(const Frame& frame) const noexcept;
  Side side_over(double t, double radius) const noexcept;

  const CurvedQuery& query_;
  Kind kind_;
  double t_max_;
  const CurvedFrame& frame_;
  Answer& answer_;
  Index component_ = 0;
  bool contact_is_likely_ = false;
  double between_slope_, u_slope_, w_slope_, first_slope_, second_slope_;
};

/// Whether a point is certainly not on the edge, or not on the other point.
template <class Frame>
Side CurvedBracketSearch::side_of_point(const Frame& frame) const noexcept {
  const auto& between = frame.between;
  for (Index k = 0; k < 3; ++k) {
    const int sign =
        kind_ == Kind::point_point ? between[k].sign() : geometry::cross_component(between, frame.w, k).sign();
    if (sign != 0) return Side::outside;
  }
  if (kind_ == Kind::point_point) return Side::close;
  const auto to_end = [&](Index k) { return between[k] + frame.second_multiplier * frame.w[k]; };
  const auto dot = (between[0] * to_end(0) + between[1] * to_end(1)) + between[2] * to_end(2);
  return dot.sign() > 0 ? Side::outside : Side::close;
}

/// At all times within `radius` of t.
Side CurvedBracketSearch::side_over(double t, double radius) const noexcept {
  struct Frame {
    geometry::Vector<Bounded> between, w;
    Bounded second_multiplier;
  } frame;
  frame.between = value_at(frame_.between, t, radius, between_slope_);
  if (kind_ == Kind::point_point) return side_of_point(frame);
  frame.w = value_at(frame_.w, t, radius, w_slope_);
  frame.second_multiplier = value_at(frame_.second_multiplier, t, radius, second_slope_);
  if (kind_ == Kind::point_edge) return side_of_point(frame);
  const auto u = value_at(frame_.u, t, radius, u_slope_);
  const Bounded first = value_at(frame_.first_multiplier, t, radius, first_slope_);
  std::array<double, 3> n;
  for (Index k = 0; k < 3; ++k) n[k] = geometry::cross_component(u, frame.w, k).value;
  const auto [axis, negative] = largest_axis(n);
  return side_of(conditions_of(kind_, frame.between, u, frame.w, first, frame.second_multiplier, axis, negative));
}

CurvedBracketSearch::Variations CurvedBracketSearch::variations(const ScalarForm& p,
                                                                const Subinterval& interval) const noexcept {
  const Index size = static_cast<Index>(p.degree) + 1;
  const double bound = numbers::kBoundSlack * interval.error;
  const auto sign = [&](Index k) { return interval.b[k] > bound ? 1 : interval.b[k] < -bound ? -1 : 0; };
  int previous = sign(0), changes = 0;
  if (previous == 0) return Variations::uncertain;
  Index doubts = 0;
  for (Index k = 1; k < size; ++k) {
    const int s = sign(k);
    if (s == 0) {
      ++doubts;
      continue;
    }
    // One uncertain coefficient between different signs: one change, whatever its sign is.
    if (doubts > (s == previous ? 0U : 1U)) return Variations::uncertain;
    if (s != previous && ++changes > 1) return Variations::uncertain;
    previous = s;
    doubts = 0;
  }
  if (doubts > 0) return Variations::uncertain;
  return changes == 0 ? Variations::none : Variations::one;
}

Outcome CurvedBracketSearch::decide(const ScalarForm& p, Index component) noexcept {
  component_ = component;
  const Index size = static_cast<Index>(p.degree) + 1;
  // An interval is cut at most so many times in a row, and so many intervals are looked at. Each cut adds at most 5
  // binary digits to the ends of an interval. So 10 cuts keep them, and their middle, exact.
  constexpr Index kMostCuts = 10;
  constexpr int kMostIntervals = 32;
  std::array<Subinterval, kMostCuts + 1> intervals;  // still to come, the first one last
  intervals[0].low = 0;
  intervals[0].high = 1;
  intervals[0].cuts = 0;
  const auto& binomial = kBinomial[static_cast<Index>(p.degree)];
  for (Index k = 0; k < size; ++k) intervals[0].b[k] = p.c[0][k] / binomial[k];
  intervals[0].error = p.error + kRounding * p.size + numbers::kUnderflow;
  // What vanishes at all times, or seems to, has no roots to look for.
  const auto vanishes = [&](double b) { return std::fabs(b) <= numbers::kBoundSlack * intervals[0].error; };
  if (std::all_of(intervals[0].b.begin(), intervals[0].b.begin() + p.degree + 1, vanishes)) return Outcome::uncertain;
  if (vanishes(intervals[0].b[0]) && side_over(0, 0) != Side::outside) {
    contact_is_likely_ = true;
    return Outcome::uncertain;
  }
  Index count = 1;
  for (int looked_at = 0; count > 0; ++looked_at) {
    Subinterval& interval = intervals[count - 1];
    if (interval.low > t_max_) return Outcome::no_contact;
    const Variations variations = this->variations(p, interval);
    if (variations == Variations::none) {
      --count;
      continue;
    }
    if (variations == Variations::one) {
      const Outcome finding = decide_at_root(p, interval);
      contact_is_likely_ = finding == Outcome::uncertain;
      if (finding != Outcome::no_contact) return finding;
      --count;
      continue;
    }
    const double middle = 0.5 * (interval.low + interval.high);
    if (side_over(middle, 0.5 * (interval.high - interval.low)) == Side::outside) {
      --count;
      continue;
    }
    if (interval.cuts == kMostCuts || looked_at >= kMostIntervals) return Outcome::uncertain;
    // A cut in the middle is often at a root of a query that people make.
    Subinterval& right = interval;
    Subinterval& left = intervals[count];
    ++count;
    const double error = interval.error + exact_cut_error(p.degree, p.size);
    const std::array<double, kMostCurvedDegree + 1> whole = interval.b;
    double cut = 0;
    for (const double fraction : {0.5, 0.4375, 0.59375}) {
      right.b = whole;
      cut_at(left.b, right.b, p.degree, fraction);
      cut = right.low + fraction * (right.high - right.low);  // exact: at most 5 more digits
      if (std::fabs(right.b[0]) > numbers::kBoundSlack * error) break;
    }
    left.low = right.low;
    left.high = right.low = cut;
    left.error = right.error = error;
    left.cuts = ++right.cuts;
  }
  return Outcome::no_contact;
}

/// Decides at the one root of p in the interval, a simple one; p has certain signs at its ends. `no_contact` says that
/// the elements do not touch there within [0, t_max].
Outcome CurvedBracketSearch::decide_at_root(const ScalarForm& p, const Subinterval& interval) noexcept {
  const double sign_low = interval.b[0] > 0 ? 1 : -1;
  const ScalarForm slope = derivative_of(p);
  // A double near the root, by Newton's method with bisection; only a hint.
  double low = interval.low, high = interval.high, t = 0.5 * (low + high), f = 0, df = 0;
  constexpr int kIterations = 40;
  for (int i = 0; i < kIterations; ++i) {
    f = value_at(p, t).value;
    df = value_at(slope, t).value;
    (f * sign_low > 0 ? low : high) = t;
    double next = t - f / df;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool converged = std::fabs(next - t) <= 0x1p-50 * t;
    t = next;
    if (converged) break;
  }
  f = value_at(p, t).value;
  df = value_at(slope, t).value;
  // Signs that are certain tell on which side of a time the root lies.
  const auto certain_side = [&](double at) { return value_at(p, at).sign() * sign_low; };  // > 0: the root is later
  double radius = 4 * (value_at(p, t).error + std::fabs(f)) / std::fabs(df) + 0x1p-52 * t;
  constexpr int kTries = 3;
  constexpr double kWider = 16;
  bool found = false;
  for (int i = 0; i < kTries && !found; ++i, radius *= kWider) {
    if (!(radius < 1)) return Outcome::uncertain;
    low = std::max(interval.low, t - radius);
    high = std::min(interval.high, t + radius);
    found = (low == interval.low || certain_side(low) > 0) && (high == interval.high || certain_side(high) < 0);
  }
  if (!found) return Outcome::uncertain;
  if (low > t_max_) return Outcome::no_contact;
  const double reach = (1 + 0x1p-50) * std::max(t - low, high - t);
  const Side side = side_over(t, reach);
  if (side == Side::outside) return Outcome::no_contact;
  return side == Side::unknown ? Outcome::uncertain : refine(slope, interval, t, reach);
}

BoundedPair CurvedBracketSearch::value(const FrameAt& frame) const noexcept {
  if (kind_ == Kind::point_point) return frame.between[component_];
  if (kind_ == Kind::point_edge) return geometry::cross_component(frame.between, frame.w, component_);
  return geometry::dot(geometry::cross(frame.u, frame.w), frame.between);
}

/// The root in the interval, which is within `radius` of t. V's slope over all of this is that of `slope`.
CurvedBracketSearch::Time CurvedBracketSearch::time_of(const ScalarForm& slope, const Subinterval& interval, double t,
                                                       double radius) const noexcept {
  const double change = slope_of(slope);
  Time time;
  double off = 0;
  constexpr int kSteps = 2;
  for (int step = 0; step < kSteps; ++step) {
    const Bounded steepness = value_at(slope, t, radius, change);
    const double least_steepness = std::fabs(steepness.value) - numbers::kBoundSlack * steepness.error;
    if (!(least_steepness > 0.5 * std::fabs(steepness.value))) return {};
    const BoundedPair v = value(frame_at(query_, numbers::exact_pair(t)));
    // V(t) is (t - root) times a slope of V in between. So the root's offset from t is -V(t) / slope, off by at most
    // (V(t)'s error + |V(t)| (slope's error) / |slope|) / (least |slope|), and e times it for each of 3 roundings.
    const double offset = -v.value.high / steepness.value;
    const double value_off =
        v.error + std::fabs(v.value.high) * (4 * kRounding + steepness.error / std::fabs(steepness.value));
    off = (1 + 0x1p-20) * (value_off / least_steepness);
    time.root = {numbers::two_sum(t, offset), off};
    const double nearest = time.root.value.high;
    if (!(nearest > interval.low && nearest < interval.high && nearest > 0)) return {};
    constexpr double kGood = 0x1p-75;
    if (off <= kGood * nearest) break;
    // A second step, from a time that is so near that the slope hardly varies.
    t = nearest;
    radius = (1 + 0x1p-50) * (std::fabs(time.root.value.low) + off);
  }
  time.known = double_below(
      time.root, [&](double at) { return value(frame_at(query_, numbers::exact_pair(at))).sign(); }, interval.b[0] > 0,
      time.lower);
  return time;
}

/// Decides at the one root in the interval, which is within `radius` of t.
Outcome CurvedBracketSearch::refine(const ScalarForm& slope, const Subinterval& interval, double t,
                                    double radius) noexcept {
  const Time time = time_of(slope, interval, t, radius);
  if (!time.known) return Outcome::uncertain;
  if (time.lower >= t_max_) return Outcome::no_contact;
  const FrameAt frame = frame_at(query_, time.root);
  if (!has_cubic(kind_)) return side_of_point(frame) == Side::outside ? Outcome::no_contact : Outcome::uncertain;

  std::array<double, 3> n;
  for (Index k = 0; k < 3; ++k) n[k] = geometry::cross_component(frame.u, frame.w, k).value.high;
  const auto [axis, negative] = largest_axis(n);
  const auto conditions = conditions_of(kind_, frame.between, frame.u, frame.w, frame.first_multiplier,
                                        frame.second_multiplier, axis, negative);
  const Side side = side_of(conditions);
  if (side == Side::outside) return Outcome::no_contact;
  if (side != Side::inside) return Outcome::uncertain;
  Answer answer;
  answer.level = Level::bracket;
  answer.contact = true;
  answer.nature = Nature::crossing;
  answer.toi = time.lower;
  answer.toi_upper = after(time.lower);
  const auto weight = [&](Index value, Index denominator) {
    return quotient(conditions.values[value], conditions.denominators[denominator]);
  };
  double sum;  // NaN if a weight is
  if (kind_ == Kind::edge_edge) {
    answer.feature_a = Feature::a;
    answer.feature_b = Feature::b;
    const double first = weight(0, 0), second = weight(2, 1);
    answer.weights_a = {1 - first, first, 0};
    answer.weights_b = {1 - second, second, 0};
    sum = first + second;
  } else {
    answer.feature_a = Feature::v;
    answer.feature_b = Feature::f;
    answer.weights_a = {1, 0, 0};
    answer.weights_b = {weight(0, 0), weight(1, 0), weight(2, 0)};
    sum = answer.weights_b[0] + answer.weights_b[1] + answer.weights_b[2];
  }
  if (!(sum >= 0)) return Outcome::uncertain;
  answer_ = answer;
  return Outcome::contact;
}

}  // namespace

namespace {

/// Decides from the roots of V or, for a point, of components. Where they touch, all three components vanish.
Outcome decide_by_roots(CurvedBracketSearch& search, const CurvedFrame& frame, Kind kind) noexcept {
  if (has_cubic(kind)) return search.decide(coplanarity_of(frame));
  for (Index k = 0; k < 3 && !search.contact_is_likely(); ++k) {
    ScalarForm component;
    if (kind == Kind::point_edge) {
      component = cross_component_of(frame, k);
    } else {
      component.degree = frame.between.degree;
      component.size = frame.between.size;
      component.error = frame.between.error;
      component.c[0] = frame.between.c[k];
    }
    if (search.decide(component, k) == Outcome::no_contact) return Outcome::no_contact;
  }
  return Outcome::uncertain;
}

}  // namespace

Outcome decide_in_brackets(const CurvedQuery& query, double t_max, Answer& answer) noexcept {
  const CurvedFrame frame = curved_frame(query);
  if (!frame.known) return Outcome::uncertain;
  CurvedBracketSearch search(query, t_max, frame, answer);
  const Outcome finding = decide_by_roots(search, frame, query.kind);
  if (finding != Outcome::uncertain || search.contact_is_likely()) return finding;
  return certainly_farther_in_pieces(query, frame, Separation(), t_max) ? Outcome::no_contact : Outcome::uncertain;
}

Outcome decide_in_brackets(const CurvedQuery& query, const Separation& separation, double t_max,
                           Answer& answer) noexcept {
  const CurvedFrame frame = curved_frame(query);
  if (!frame.known) return Outcome::uncertain;
  return decide_entry(query, frame, separation, t_max, answer);
}

}  // namespace touchstone::filters
