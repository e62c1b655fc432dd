// The entry of two elements on curves into a separation.
//
// Directions show that the elements are apart up to a time just before the entry: see curved_walk.cpp. From there on,
// until a little after the entry, one pair of features has the only closest points: the conditions for that, signs of
// polynomials, hold strictly at all times near the entry. So the distance there is gap / measure, and it reaches the
// separation at the root of a polynomial, which falls all along. Double-doubles show between which doubles the root is.
// SPDX-License-Identifier: MIT
#include "filters/curved/curved_entry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "filters/curved/curved_feet.hpp"
#include "filters/curved/curved_time.hpp"
#include "filters/curved/curved_walk.hpp"

namespace touchstone::filters {
namespace {

using numbers::Bounded;
using numbers::BoundedPair;
using numbers::kBoundSlack;
using numbers::kRounding;
using Index = std::size_t;

/// A polynomial with its derivative.
template <class Form>
struct WithSlope {
  Form form, slope;
  double slope_bound, bend_bound;

  explicit WithSlope(const Form& of) noexcept
      : form(of), slope(derivative_of(of)), slope_bound(slope_of(form)), bend_bound(slope_of(slope)) {}
};

Jet jet_at(const WithSlope<ScalarForm>& p, double t, double radius) noexcept {
  return {value_at(p.form, t, radius, p.slope_bound), value_at(p.slope, t, radius, p.bend_bound)};
}
geometry::Vector<Jet> jet_at(const WithSlope<VectorForm>& p, double t, double radius) noexcept {
  const auto value = value_at(p.form, t, radius, p.slope_bound), slope = value_at(p.slope, t, radius, p.bend_bound);
  return {{Jet{value[0], slope[0]}, Jet{value[1], slope[1]}, Jet{value[2], slope[2]}}};
}

template <class V>
V negative(const V& v) noexcept {
  return {{-v[0], -v[1], -v[2]}};
}

/// From a frame, whose u and w may be missing: see CurvedFrame.
template <class N>
PointDifferences<N> differences_of(Kind kind, const geometry::Vector<N>& between, const geometry::Vector<N>& u,
                                   const geometry::Vector<N>& w, const N& first, const N& second) noexcept {
  PointDifferences<N> x = {between, u, negative(w), second, second, first * second};
  if (kind == Kind::edge_edge) x.first = first;
  if (kind == Kind::vertex_face) x.u = negative(u);
  if (kind == Kind::point_edge) x.u = x.w;
  return x;
}

/// Which points are the closest ones, as doubles tell.
struct Hint {
  Parameters p = {0, 0};
  Free free = Free::none;
  SignedFacet facet;    ///< in the metric max
  double distance = 0;  ///< without the scale
};

class CurvedEntry {
 public:
  CurvedEntry(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation, double t_max,
              Answer& answer) noexcept
      : query_(query),
        frame_(frame),
        kind_(query.kind),
        domain_(domain_of(query.kind)),
        metric_(separation.metric),
        t_max_(t_max),
        walk_(query, frame, separation),
        answer_(answer) {}

  Outcome decide() noexcept {
    if (!walk_.known()) return Outcome::uncertain;
    const CurvedWalk::Result walked = walk_.walk(t_max_);
    switch (walked.end) {
      case WalkEnd::clear: return Outcome::no_contact;
      case WalkEnd::near: return enter(walked.low, walked.high);
      case WalkEnd::start: return starts_within();
      case WalkEnd::lost: break;
    }
    return Outcome::uncertain;
  }

 private:
  StepAt iterate_at(double t) const noexcept;
  Hint hint_at(double t) const noexcept;
  double about_entry(double low, double high) const noexcept;
  PointDifferences<Jet> near(double t, double radius) const noexcept;
  PointDifferences<BoundedPair> at(const BoundedPair& t) const noexcept;
  template <class N>
  Feet<N> feet(const Hint& hint, const PointDifferences<N>& x, bool own_level) const noexcept;
  template <class N>
  N excess(const Feet<N>& feet, const N& scale) const noexcept;
  Outcome enter(double low, double high) noexcept;
  Outcome starts_within() noexcept;
  bool describe(const Hint& hint, const Feet<BoundedPair>& feet, Answer& answer) const noexcept;

  const CurvedQuery& query_;
  const CurvedFrame& frame_;
  Kind kind_;
  Domain domain_;
  Metric metric_;
  double t_max_;
  CurvedWalk walk_;
  Answer& answer_;
};

/// In doubles, with the multipliers.
StepAt CurvedEntry::iterate_at(double t) const noexcept {
  const auto vector = [t](const VectorForm& form, double factor) {
    const auto v = value_at(form, t, 0, 0);
    return Vector{{factor * v[0].value, factor * v[1].value, factor * v[2].value}};
  };
  const double first = value_at(frame_.first_multiplier, t).value, second = value_at(frame_.second_multiplier, t).value;
  StepAt iterate = {};
  iterate.t = first * second;  // the scale
  iterate.r = vector(frame_.between, 1);
  if (kind_ == Kind::point_point) return iterate;
  const Vector w = vector(frame_.w, -second);
  if (kind_ == Kind::point_edge) {
    iterate.u = w;
    return iterate;
  }
  iterate.w = w;
  iterate.u = vector(frame_.u, kind_ == Kind::edge_edge ? first : -second);
  return iterate;
}

Hint CurvedEntry::hint_at(double t) const noexcept {
  const StepAt iterate = iterate_at(t);
  Hint hint;
  if (metric_ == Metric::euclidean) {
    hint.p = closest(domain_, iterate.r, iterate.u, iterate.w);
    hint.free = free_parameters(domain_, hint.p);
    const Vector c = combined(iterate.r, iterate.u, iterate.w, hint.p.s, hint.p.q);
    hint.distance = std::sqrt(dot(c, c)) / iterate.t;
    return hint;
  }
  const auto [facet, distance] = FacetSearch(domain_, iterate).best();
  hint.facet.facet = facet;
  hint.distance = distance / iterate.t;
  hint.free = facet.free;
  hint.p = {facet.s, facet.q};
  const Vector n = normal_of(facet, iterate.u, iterate.w, 0.0, 1.0);
  // An edge is measured along the two axes that count, and a plane's normal, without its sign, along all.
  const Vector along = facet.sort == Sort::edge ? edge_of(facet.free, iterate.u, iterate.w) : n;
  double largest = -1;
  for (Index k = 0; k < 3; ++k) {
    const bool counts = facet.sort == Sort::plane || (facet.sort == Sort::face) == (k == facet.axis);
    hint.facet.sigma[k] = !counts ? 0 : n[k] < 0 ? -1 : 1;
    if (!counts || std::fabs(along[k]) <= largest) continue;
    largest = std::fabs(along[k]);
    hint.facet.axis = k;
    hint.facet.sign = (along[k] < 0) == (facet.sort == Sort::plane && facet.sign < 0) ? 1 : -1;
  }
  return hint;
}

/// By regula falsi, as Illinois has it: the distance is above the separation at `low` and below it at `high`.
double CurvedEntry::about_entry(double low, double high) const noexcept {
  constexpr int kMostSteps = 60;
  constexpr double kNear = 0x1p-48;
  const double goal = walk_.distance();
  double at_low = hint_at(low).distance - goal, at_high = hint_at(high).distance - goal;
  int side = 0;
  double t = high;
  for (int i = 0; i < kMostSteps && high - low > kNear * high; ++i) {
    t = low + (high - low) * (at_low / (at_low - at_high));
    if (!(t > low && t < high)) t = 0.5 * (low + high);
    const double value = hint_at(t).distance - goal;
    if (value == 0) return t;
    if (value > 0) {
      if (side > 0) at_high *= 0.5;
      low = t;
      at_low = value;
      side = 1;
    } else {
      if (side < 0) at_low *= 0.5;
      high = t;
      at_high = value;
      side = -1;
    }
    if (std::fabs(value) <= kNear * goal) break;
  }
  return t;
}

PointDifferences<Jet> CurvedEntry::near(double t, double radius) const noexcept {
  const auto jet = [&](const auto& form) { return jet_at(WithSlope(form), t, radius); };
  const geometry::Vector<Jet> none = {};
  return differences_of(kind_, jet(frame_.between), has_cubic(kind_) ? jet(frame_.u) : none,
                        kind_ != Kind::point_point ? jet(frame_.w) : none, jet(frame_.first_multiplier),
                        jet(frame_.second_multiplier));
}

PointDifferences<BoundedPair> CurvedEntry::at(const BoundedPair& t) const noexcept {
  const FrameAt frame = frame_at(query_, t);
  return differences_of(kind_, frame.between, frame.u, frame.w, frame.first_multiplier, frame.second_multiplier);
}

/// @param own_level  for the metric max: the closest points at their own distance in place of the separation
template <class N>
Feet<N> CurvedEntry::feet(const Hint& hint, const PointDifferences<N>& x, bool own_level) const noexcept {
  if (metric_ == Metric::euclidean) return feet_of(domain_, hint.free, hint.p, x);
  if (own_level) return feet_of<N>(domain_, hint.facet, x, nullptr);
  const LevelOf<N> level = {exact_number<N>(walk_.distance()) * x.scale, exact_number<N>(1)};
  return feet_of(domain_, hint.facet, x, &level);
}

/// It has the sign of the distance minus the separation.
template <class N>
N CurvedEntry::excess(const Feet<N>& feet, const N& scale) const noexcept {
  const N reach = exact_number<N>(walk_.distance()) * scale;
  return feet.gap - (metric_ == Metric::euclidean ? reach * reach : reach) * feet.measure;
}

bool CurvedEntry::describe(const Hint& hint, const Feet<BoundedPair>& feet, Answer& answer) const noexcept {
  const auto weight = [&feet](Index i) { return quotient(feet.weights[i], feet.units[i]); };
  double s = hint.p.s, q = hint.p.q, rest = 0;
  switch (hint.free) {
    case Free::none: break;
    case Free::s: s = weight(0); break;
    case Free::q: q = weight(0); break;
    case Free::sum:
      q = weight(0);
      s = 1 - q;
      break;
    case Free::both:
      s = weight(0);
      q = weight(1);
      if (domain_ == Domain::triangle) rest = weight(2);
      break;
  }
  if (!(s + q + rest >= 0)) return false;  // NaN
  name_closest(kind_, s, q, hint.free, answer);
  if (hint.free == Free::both && domain_ == Domain::triangle) answer.weights_b[0] = rest;
  answer.level = Level::bracket;
  answer.contact = true;
  return true;
}

/// The elements are apart up to about `low`, and seem to be within the separation at `high`.
Outcome CurvedEntry::enter(double low, double high) noexcept {
  // All conditions must hold at all times within this radius of about the time of entry.
  constexpr double kRadius = 0x1p-24;
  constexpr double kLonger = 0x1p-46;
  double t = about_entry(low, high);
  const double start = t - kRadius;
  if (!(t > 0 && t + kRadius <= 1)) return Outcome::uncertain;
  const Hint hint = hint_at(t);
  const PointDifferences<Jet> around = near(t, kRadius);
  const Feet<Jet> closest = feet(hint, around, false);
  if (!certainly_closest(closest)) return Outcome::uncertain;
  const Bounded slope = excess(closest, around.scale).slope;
  const double steep = -slope.value, least_steep = steep - kBoundSlack * slope.error;
  if (!(least_steep > 0.5 * steep)) return Outcome::uncertain;

  // The excess falls all around t. With the value v at t, its root is at t + v / s for a slope -s in between: off by at
  // most (v's error + |v| (s's error) / s) / (least s), and e times it for each of 3 roundings. There is a root if
  // |v| / (least s) does not lead out of the times that are looked at.
  BoundedPair root;
  constexpr int kSteps = 2;
  for (int step = 0; step < kSteps; ++step) {
    const PointDifferences<BoundedPair> x = at(numbers::exact_pair(t));
    const BoundedPair v = excess(feet(hint, x, false), x.scale);
    const double size = std::fabs(v.value.high);
    const double reach = 1.125 * ((size + v.error) / least_steep);
    const double radius = step == 0 ? std::min(kRadius, t) : 0x1p-40;
    if (!(reach < std::min(radius, t))) return Outcome::uncertain;
    const double off = (1 + 0x1p-20) * ((v.error + size * (4 * kRounding + slope.error / steep)) / least_steep);
    root = {numbers::two_sum(t, v.value.high / steep), off};
    constexpr double kGood = 0x1p-75;
    t = root.value.high;
    if (!(t > 0)) return Outcome::uncertain;
    if (off <= kGood * t) break;
  }
  const auto sign_at = [&](double time) {
    const PointDifferences<BoundedPair> x = at(numbers::exact_pair(time));
    return excess(feet(hint, x, false), x.scale).sign();
  };
  double lower = 0;
  if (!double_below(root, sign_at, true, lower)) return Outcome::uncertain;
  if (start > low * (1 - kLonger) && !walk_.farther_between(low, start)) return Outcome::uncertain;
  if (lower >= t_max_) return Outcome::no_contact;
  Answer answer;
  if (!describe(hint, feet(hint, at(root), false), answer)) return Outcome::uncertain;
  answer.nature = Nature::entering;
  answer.trend = Trend::approaching;
  answer.toi = lower;
  answer.toi_upper = after(lower);
  answer_ = answer;
  return Outcome::contact;
}

/// The elements seem to be within the separation at t = 0.
Outcome CurvedEntry::starts_within() noexcept {
  const Hint hint = hint_at(0);
  const PointDifferences<Jet> around = near(0, 0);
  const Feet<Jet> closest = feet(hint, around, true);
  if (!certainly_closest(closest) || excess(closest, around.scale).sign() >= 0) return Outcome::uncertain;
  // The distance, or its square, without the scale: gap / whole.
  const Jet factor = metric_ == Metric::euclidean ? around.scale * around.scale : around.scale;
  const Jet whole = closest.measure * factor;
  const int course = (closest.gap.slope * whole.value - closest.gap.value * whole.slope).sign();
  if (course == 0) return Outcome::uncertain;
  Answer answer;
  if (!describe(hint, feet(hint, at(numbers::exact_pair(0)), true), answer)) return Outcome::uncertain;
  answer.nature = Nature::sustained;
  answer.trend = course < 0 ? Trend::approaching : Trend::leaving;
  answer.toi = answer.toi_upper = 0;
  answer.starts_within = true;
  answer_ = answer;
  return Outcome::contact;
}

}  // namespace

Outcome decide_entry(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation, double t_max,
                     Answer& answer) noexcept {
  return CurvedEntry(query, frame, separation, t_max, answer).decide();
}

}  // namespace touchstone::filters
