// The entry into a Euclidean separation, and the walk to an entry in either metric.
//
// Two bounds enclose the distance D(t) of the elements. Let c be the difference of a point of one element and a point
// of the other. It is r - s u - q w, with parameters (s, q) in a square, a triangle, a segment or a point, and r, u, w
// linear in time.
//   Below: for any direction n, D(t) |n| is at least the least n . c over the elements' corners, where |n| is the
//   Euclidean length or, in the largest-axis metric, the sum of the absolute coordinates. Each n . c of a pair of
//   corners is linear in t. So if it exceeds d |n| at two times, it does so between them.
//   Above: D(t) <= |c| for any allowed (s, q).
// In the Euclidean metric, both bounds meet when (s, q) are the closest points' and n is their c. So the time is walked
// to from below: at each time, the closest points in doubles give a direction, and the direction proves a piece of the
// step free. These pieces become shorter by squares. Near the end, the closest points in double-doubles prove that D >
// d at some double.
//
// From that double until the next one, one pair of features has the only closest points: the conditions for that hold
// strictly at all these times. So D falls all along, and the exact time lies between the two.
//
// A direction may also turn: let it go evenly from n0 to n1 while t goes from t0 to t1. Then n . c is a quadratic,
// whose Bernstein coefficients are n0 . c(t0), the mean of n0 . c(t1) and n1 . c(t0), and n1 . c(t1). The norm is at
// most what goes evenly from |n0| to |n1|. So it is enough that n . c exceeds d |n| at both ends and that n0 . c(t1) +
// n1 . c(t0) > d (|n0| + |n1|).
// SPDX-License-Identifier: MIT
#include "filters/separation/entry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "filters/separation/closest_feet.hpp"
#include "filters/separation/closest_near.hpp"
#include "filters/separation/entry_walk.hpp"
#include "filters/separation/precise_closest.hpp"
#include "filters/separation/straight_differences.hpp"

namespace touchstone::filters {
namespace {

class StraightEntry {
 public:
  StraightEntry(const Query& query, const Separation& separation, double t_max, Answer& answer,
                BoundedPair* time) noexcept
      : kind_(query.kind),
        separation_(separation),
        t_max_(t_max),
        step_(query),
        precise_(query),
        closest_(query.kind, separation.metric, separation.distance),
        answer_(answer),
        time_(time) {}

  Outcome decide() noexcept {
    const bool is_euclidean = separation_.metric == Metric::euclidean;
    return decide_by_walk(
        step_, separation_, t_max_,
        [this, is_euclidean](double t) { return is_euclidean ? closest_iterate(t) : facet_iterate(t); },
        [this](const StepAt& from) { return enter(from); },
        [this](const StepAt& start) { return starts_within(start); });
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  /// The iterate whose direction is between the closest points.
  StepAt closest_iterate(double t) const noexcept {
    StepAt iterate = bare_iterate(step_, t);
    const Parameters p = closest(step_.domain, iterate.r, iterate.u, iterate.w);
    iterate.n = combined(iterate.r, iterate.u, iterate.w, p.s, p.q);
    // |c|^2 falls by twice the approach a time.
    const double approach = -dot(iterate.n, combined(step_.r_slope, step_.u_slope, step_.w_slope, p.s, p.q));
    const double length = std::sqrt(dot(iterate.n, iterate.n));
    if (approach > 0) iterate.until = (length - separation_.distance) * length / approach;
    return iterate;
  }

  /// The iterate whose direction is the best facet's normal. Without one, the direction is 0, which shows nothing.
  StepAt facet_iterate(double t) const noexcept {
    StepAt iterate = bare_iterate(step_, t);
    const auto [facet, distance] = FacetSearch(step_.domain, iterate).best();
    if (!(distance > 0)) return iterate;
    const Vector n = normal_of(facet, iterate.u, iterate.w, 0.0, 1.0);
    iterate.n = scaled_direction(n);
    // D |n|_1 = n . p, where both n and p move.
    const Vector rate = normal_rate(facet, iterate.u, iterate.w);
    const Vector p = combined(iterate.r, iterate.u, iterate.w, facet.s, facet.q);
    double norm_rate = 0;
    for (std::size_t k = 0; k < 3; ++k) norm_rate += n[k] > 0 ? rate[k] : n[k] < 0 ? -rate[k] : 0;
    const double slope = dot(rate, p) + dot(n, corner_velocity(facet)) - distance * norm_rate;
    const double norm = dual_norm(n, Metric::max);
    if (slope < 0) iterate.until = (distance - separation_.distance) * norm / -slope;
    return iterate;
  }

  Vector normal_rate(const Facet& facet, const Vector& u, const Vector& w) const noexcept {
    Vector rate = {{0, 0, 0}};
    if (facet.sort == Sort::edge) {
      rate = axis_cross(facet.axis, edge_of(facet.free, step_.u_slope, step_.w_slope), 0.0);
    } else if (facet.sort == Sort::plane) {
      const Vector of_u = cross(step_.u_slope, w), of_w = cross(u, step_.w_slope);
      rate = {{of_u[0] + of_w[0], of_u[1] + of_w[1], of_u[2] + of_w[2]}};
    }
    for (double& x : rate.c) x *= facet.sign;
    return rate;
  }

  Vector corner_velocity(const Facet& facet) const noexcept {
    return combined(step_.r_slope, step_.u_slope, step_.w_slope, facet.s, facet.q);
  }

  /// The elements are apart up to an iterate, and come within the separation soon after it.
  Outcome enter(const StepAt& from) noexcept {
    const double estimate = from.t + from.until;
    if (!(estimate >= 0 && estimate <= 1)) return Outcome::uncertain;
    const StepAt iterate = bare_iterate(step_, estimate);
    return separation_.metric == Metric::euclidean ? enter_by_points(from, iterate) : enter_by_facet(from, iterate);
  }

  Outcome enter_by_points(const StepAt& from, const StepAt& iterate) noexcept {
    const Parameters p = closest(step_.domain, iterate.r, iterate.u, iterate.w);
    PreciseClosest found;
    double toi = iterate.t;
    const bool is_beside = is_beside_entry(toi, [&](double t) {
      found = precise_closest(step_, precise_, separation_.distance, t, p);
      const double s = found.p.s + found.ds, q = found.p.q + found.dq;
      const double approach = -dot(found.c, combined(step_.r_slope, step_.u_slope, step_.w_slope, s, q));
      return found.ok && approach > 0 ? found.excess / (2 * approach) : kNone;
    });
    if (!is_beside) return Outcome::uncertain;
    const double upper = std::nextafter(toi, 2.0);
    const ClosestNear near(step_, found, upper - toi);
    if (!near.certain()) return Outcome::uncertain;
    // Let n be c as it is computed, in double-doubles. At all corners, n . c is at least |n|^2 + lowest, and at most D
    // |n| at the closest points. So D^2 is between |n|^2 + 2 lowest and |n|^2. If |n|^2 + 2 lowest > d^2, then (|n| +
    // lowest / |n|)^2 is greater, too: n keeps the elements farther apart than d.
    const Bounded excess = {found.excess, 3 * found.error - 2 * found.lowest};
    return conclude(from, toi, upper, excess, near.fall(), found.c,
                    [&](const Bounded& later) { return near.name(kind_, later, answer_); });
  }

  Outcome enter_by_facet(const StepAt& from, const StepAt& iterate) noexcept {
    // All conditions must hold at all times within this radius of the estimate.
    constexpr double kRadius = 0x1p-36;
    const Hint hint = closest_.hint_at(iterate);
    const StraightDifferences<Jet> around = differences_near(step_, iterate.t, kRadius);
    const Feet<Jet> feet = closest_.feet(hint, around, false);
    if (!certainly_closest(feet)) return Outcome::uncertain;
    const Bounded fall = -closest_.excess(feet, around.scale).slope;
    if (fall.sign() <= 0) return Outcome::uncertain;
    StraightDifferences<BoundedPair> x;
    BoundedPair excess;
    double toi = iterate.t;
    const bool is_beside = is_beside_entry(toi, [&](double t) {
      x = differences_at(precise_, numbers::exact_pair(t));
      excess = closest_.excess(closest_.feet(hint, x, false), x.scale);
      return excess.value.high / fall.value;
    });
    if (!is_beside || !(std::fabs(toi - iterate.t) < 0.5 * kRadius)) return Outcome::uncertain;
    Vector n = {};
    if (!find_normal(hint.facet.facet, x, n)) return Outcome::uncertain;
    const double upper = std::nextafter(toi, 2.0);
    return conclude(from, toi, upper, numbers::rounded(excess), fall, n, [&](const Bounded& later) {
      const BoundedPair root = {numbers::two_sum(toi, later.value), later.error};
      return closest_.name(hint, closest_.feet(hint, differences_at(precise_, root), false), answer_);
    });
  }

  /// The facet's normal, off by little more than a rounding of its largest coordinate; false where it is not known so
  /// well.
  static bool find_normal(const Facet& facet, const StraightDifferences<BoundedPair>& x, Vector& n) noexcept {
    constexpr double kSmall = 0x1p-60;
    const auto normal = normal_of(facet, x.u, x.w, numbers::exact_pair(0), numbers::exact_pair(1));
    n = {{normal[0].value.high, normal[1].value.high, normal[2].value.high}};
    if (!(std::max({normal[0].error, normal[1].error, normal[2].error}) <= kSmall * largest_of(n))) return false;
    n = scaled_direction(n);
    return true;
  }

  /// Moves `toi` by Newton's steps to a double that is just before the entry. False where there is none.
  /// @param rest_at  about the time from a double to the entry
  template <class RestAt>
  static bool is_beside_entry(double& toi, const RestAt& rest_at) noexcept {
    constexpr int kMostSteps = 4;
    for (int i = 0; i < kMostSteps; ++i) {
      const double rest = rest_at(toi);
      if (rest > 0 && rest < std::nextafter(toi, 2.0) - toi) return true;
      const DoubleDouble better = numbers::two_sum(toi, rest);
      const double below = better.low < 0 ? std::nextafter(better.high, -1.0) : better.high;
      if (below == toi || !(below >= 0 && below <= 1)) return false;
      toi = below;
    }
    return false;
  }

  /// @param excess  by how much the distance, or its square, is above that of the separation at toi
  /// @param fall    how fast it falls until the next double, `upper`; the closest points are the only ones until then
  /// @param n       a direction along which the elements are farther apart than the separation at toi, up to a rounding
  /// @param name    writes the closest points at a time so much later than toi; false where they are not certain
  template <class Name>
  Outcome conclude(const StepAt& from, double toi, double upper, const Bounded& excess, const Bounded& fall,
                   const Vector& n, const Name& name) noexcept {
    if (excess.sign() <= 0) return Outcome::uncertain;
    if (toi > from.t && !stays_clear(step_, from, toi, n, separation_)) return Outcome::uncertain;
    if (upper > t_max_) return Outcome::no_contact;
    const Bounded later = excess / fall;
    if (fall.sign() <= 0 || (Bounded{upper - toi, 0} - later).sign() <= 0) return Outcome::uncertain;
    if (!name(later)) return Outcome::uncertain;
    answer_.nature = Nature::entering;
    answer_.trend = Trend::approaching;
    answer_.toi = toi;
    answer_.toi_upper = upper;
    if (time_ != nullptr) *time_ = {numbers::two_sum(toi, later.value), later.error};
    return Outcome::contact;
  }

  /// The elements are perhaps within the separation at t = 0.
  Outcome starts_within(const StepAt& start) noexcept {
    const bool still = precise_.is_still();
    if (separation_.metric == Metric::max) {
      return closest_.starts_within(closest_.hint_at(start), differences_near(step_, 0, 0),
                                    differences_at(precise_, numbers::exact_pair(0)), still, answer_);
    }
    const Parameters p = closest(step_.domain, start.r, start.u, start.w);
    const PreciseClosest found = precise_closest(step_, precise_, separation_.distance, 0, p);
    if (!found.ok || !(found.excess < -found.error)) return Outcome::uncertain;
    const ClosestNear near(step_, found, 0);
    const int course = -near.fall().sign();
    if (!near.certain() || (course == 0 && !still)) return Outcome::uncertain;
    if (!near.name(kind_, {}, answer_)) return Outcome::uncertain;
    name_start(course, answer_);
    return Outcome::contact;
  }

  Kind kind_;
  const Separation& separation_;
  double t_max_;
  Step step_;
  PreciseStep precise_;
  ClosestFeet closest_;
  Answer& answer_;
  BoundedPair* time_;
};

}  // namespace

Outcome decide_entry(const Query& query, const Separation& separation, double t_max, Answer& answer,
                     BoundedPair* time) noexcept {
  return StraightEntry(query, separation, t_max, answer, time).decide();
}

}  // namespace touchstone::filters
