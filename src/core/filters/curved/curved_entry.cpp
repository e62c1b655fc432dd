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

#include "filters/curved/curved_time.hpp"
#include "filters/curved/curved_walk.hpp"
#include "filters/separation/closest_feet.hpp"

namespace touchstone::filters {
namespace {

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

class CurvedEntry {
 public:
  CurvedEntry(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation, double t_max,
              Answer& answer) noexcept
      : query_(query),
        frame_(frame),
        kind_(query.kind),
        t_max_(t_max),
        walk_(query, frame, separation),
        closest_(query.kind, separation.metric, walk_.distance()),
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
  double about_entry(double low, double high) const noexcept;
  PointDifferences<Jet> near(double t, double radius) const noexcept;
  PointDifferences<BoundedPair> at(const BoundedPair& t) const noexcept;
  Outcome enter(double low, double high) noexcept;
  Outcome starts_within() noexcept;

  const CurvedQuery& query_;
  const CurvedFrame& frame_;
  Kind kind_;
  double t_max_;
  CurvedWalk walk_;
  ClosestFeet closest_;
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

/// By regula falsi, as Illinois has it: the distance is above the separation at `low` and below it at `high`.
double CurvedEntry::about_entry(double low, double high) const noexcept {
  constexpr int kMostSteps = 60;
  constexpr double kNear = 0x1p-48;
  const double goal = walk_.distance();
  const auto beyond = [&](double t) {
    const StepAt iterate = iterate_at(t);
    return closest_.hint_at(iterate).distance / iterate.t - goal;
  };
  double at_low = beyond(low), at_high = beyond(high);
  int side = 0;
  double t = high;
  for (int i = 0; i < kMostSteps && high - low > kNear * high; ++i) {
    t = low + (high - low) * (at_low / (at_low - at_high));
    if (!(t > low && t < high)) t = 0.5 * (low + high);
    const double value = beyond(t);
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

/// The elements are apart up to about `low`, and seem to be within the separation at `high`.
Outcome CurvedEntry::enter(double low, double high) noexcept {
  // All conditions must hold at all times within this radius of about the time of entry.
  constexpr double kRadius = 0x1p-24;
  constexpr double kLonger = 0x1p-46;
  double t = about_entry(low, high);
  const double start = t - kRadius;
  if (!(t > 0 && t + kRadius <= 1)) return Outcome::uncertain;
  const Hint hint = closest_.hint_at(iterate_at(t));
  const PointDifferences<Jet> around = near(t, kRadius);
  const Feet<Jet> feet = closest_.feet(hint, around, false);
  if (!certainly_closest(feet)) return Outcome::uncertain;
  const Bounded fall = -closest_.excess(feet, around.scale).slope;
  if (fall.sign() <= 0) return Outcome::uncertain;

  // The excess falls all around t. There is a root if the rest does not lead out of the times that are looked at.
  const auto excess_at = [&](double time) {
    const PointDifferences<BoundedPair> x = at(numbers::exact_pair(time));
    return closest_.excess(closest_.feet(hint, x, false), x.scale);
  };
  BoundedPair root;
  constexpr int kSteps = 2;
  for (int step = 0; step < kSteps; ++step) {
    const BoundedPair v = excess_at(t);
    const double radius = step == 0 ? std::min(kRadius, t) : 0x1p-40;
    const Bounded rest = numbers::rounded(v) / fall;
    if (!(std::fabs(rest.value) + 2 * rest.error < std::min(radius, t))) return Outcome::uncertain;
    root = {numbers::two_sum(t, rest.value), (1 + 0x1p-20) * rest.error};  // with room for the bound's own roundings
    constexpr double kGood = 0x1p-75;
    t = root.value.high;
    if (!(t > 0)) return Outcome::uncertain;
    if (root.error <= kGood * t) break;
  }
  double lower = 0;
  const auto sign_at = [&](double time) { return excess_at(time).sign(); };
  if (!double_below(root, sign_at, true, lower)) return Outcome::uncertain;
  if (start > low * (1 - kLonger) && !walk_.farther_between(low, start)) return Outcome::uncertain;
  if (lower >= t_max_) return Outcome::no_contact;
  Answer answer;
  if (!closest_.name(hint, closest_.feet(hint, at(root), false), answer)) return Outcome::uncertain;
  answer.level = Level::bracket;
  answer.nature = Nature::entering;
  answer.trend = Trend::approaching;
  answer.toi = lower;
  answer.toi_upper = after(lower);
  answer_ = answer;
  return Outcome::contact;
}

/// The elements seem to be within the separation at t = 0.
Outcome CurvedEntry::starts_within() noexcept {
  const Outcome finding =
      closest_.starts_within(closest_.hint_at(iterate_at(0)), near(0, 0), at(numbers::exact_pair(0)), false, answer_);
  if (finding == Outcome::contact) answer_.level = Level::bracket;
  return finding;
}

}  // namespace

Outcome decide_entry(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation, double t_max,
                     Answer& answer) noexcept {
  return CurvedEntry(query, frame, separation, t_max, answer).decide();
}

}  // namespace touchstone::filters
