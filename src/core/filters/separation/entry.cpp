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
// d up to some double, and that D <= d at the next one.
//
// A direction may also turn: let it go evenly from n0 to n1 while t goes from t0 to t1. Then n . c is a quadratic,
// whose Bernstein coefficients are n0 . c(t0), the mean of n0 . c(t1) and n1 . c(t0), and n1 . c(t1). The norm is at
// most what goes evenly from |n0| to |n1|. So it is enough that n . c exceeds d |n| at both ends and that n0 . c(t1) +
// n1 . c(t0) > d (|n0| + |n1|).
// SPDX-License-Identifier: MIT
#include "filters/separation/entry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "filters/separation/entry_walk.hpp"
#include "filters/separation/max_entry.hpp"
#include "filters/separation/precise_closest.hpp"

namespace touchstone::filters {
namespace {

class EuclideanEntry {
 public:
  EuclideanEntry(const Query& query, const Separation& separation, double t_max, Answer& answer) noexcept
      : kind_(query.kind),
        separation_(separation),
        distance_(separation.distance),
        t_max_(t_max),
        step_(query),
        precise_(query),
        answer_(answer) {}

  Outcome decide() noexcept {
    return decide_by_walk(
        step_, separation_, t_max_, [this](double t) { return closest_iterate(t); },
        [this](const StepAt& from) { return enter(from); },
        [this](const StepAt& start) { return starts_within(start); });
  }

 private:
  Parameters closest_at(const StepAt& iterate) const noexcept {
    return closest(step_.domain, iterate.r, iterate.u, iterate.w);
  }

  /// The iterate whose direction is between the closest points.
  StepAt closest_iterate(double t) const noexcept {
    StepAt iterate = bare_iterate(step_, t);
    const Parameters p = closest_at(iterate);
    iterate.n = combined(iterate.r, iterate.u, iterate.w, p.s, p.q);
    // |c|^2 falls by twice the approach a time.
    const double approach = -dot(iterate.n, combined(step_.r_slope, step_.u_slope, step_.w_slope, p.s, p.q));
    const double length = std::sqrt(dot(iterate.n, iterate.n));
    if (approach > 0) iterate.until = (length - distance_) * length / approach;
    return iterate;
  }

  /// The elements are apart up to an iterate, and come within the separation soon after it.
  Outcome enter(const StepAt& from) noexcept {
    const double estimate = from.t + from.until;
    if (!(estimate >= 0 && estimate <= 1)) return Outcome::uncertain;
    const Parameters p = closest_at(bare_iterate(step_, estimate));
    // Newton's steps in double-doubles find the neighbouring doubles.
    double toi = estimate;
    constexpr int kMostSteps = 4;
    for (int i = 0; i < kMostSteps; ++i) {
      const PreciseClosest found = precise_closest(step_, precise_, distance_, toi, p);
      if (!found.ok) return Outcome::uncertain;
      const Vector velocity = velocity_of(found);
      const double approach = -dot(found.c, velocity);
      if (!(approach > 0)) return Outcome::uncertain;
      const double rest = found.excess / (2 * approach);  // until the entry
      const double upper = std::nextafter(toi, 2.0);
      if (!(rest > 0 && rest < upper - toi)) {
        const DoubleDouble better = numbers::two_sum(toi, rest);
        const double below = better.low < 0 ? std::nextafter(better.high, -1.0) : better.high;
        if (below == toi || !(below >= 0 && below <= 1)) return Outcome::uncertain;
        toi = below;
        continue;
      }
      return conclude(from, toi, upper, found, velocity);
    }
    return Outcome::uncertain;
  }

  Vector velocity_of(const PreciseClosest& found) const noexcept {
    return combined(step_.r_slope, step_.u_slope, step_.w_slope, found.p.s + found.ds, found.p.q + found.dq);
  }

  Outcome conclude(const StepAt& from, double toi, double upper, const PreciseClosest& found,
                   const Vector& velocity) noexcept {
    const double length = std::sqrt(dot(found.c, found.c));
    // D > d up to toi. For n = c, |n|^2 - d |n| = |n| / (|n| + d) (|n|^2 - d^2).
    if (toi > from.t) {
      if (!(found.excess > found.error)) return Outcome::uncertain;
      const double fraction = length / (length + distance_) * (1 - 8 * kUnit);
      if (!(fraction * (found.excess - found.error) + found.lowest > found.error)) return Outcome::uncertain;
      if (!stays_clear(step_, from, toi, found.c, separation_)) return Outcome::uncertain;
    }
    if (upper > t_max_) return Outcome::no_contact;
    // D <= d at the next double: |c + h velocity|^2 - d^2 <= 0. Nothing cancels in the change, because `describe` asks
    // for an approach far above the terms that are taken from it.
    const double h = upper - toi;
    const double approach = -dot(found.c, velocity);
    const double speed = step_.speed;
    const double slope_error = kWalkError * largest_of(found.c) * (speed + step_.size);
    const double change = 2 * h * (approach - slope_error) - 5 * h * h * speed * speed;
    if (!(found.excess + found.error < change * (1 - 8 * kUnit))) return Outcome::uncertain;
    return describe(toi, upper, h, found, velocity, approach, slope_error, Nature::entering);
  }

  /// How fast the free parameters move, from c . u = 0 and c . w = 0 at all times: the derivative of c for fixed
  /// parameters is the velocity.
  Parameters rates(const PreciseClosest& found, const Vector& velocity, Free free) const noexcept {
    const double u = dot(velocity, found.u) + dot(found.c, step_.u_slope);
    const double w = dot(velocity, found.w) + dot(found.c, step_.w_slope);
    return changes_of_free(found, free, u, w, u - w);
  }

  /// How far the parameters may be from those of the closest points at the exact time; infinite where that is unknown.
  struct ParameterError {
    double ds, dq;
    double longer;  ///< at least as much as |c|^2 may exceed the squared distance for that
  };
  /// @param h         the time between the neighbouring doubles
  /// @param cu_error  how far c . u may be from 0 for a free s at the exact time, beyond found.cu; likewise cw_error
  ParameterError parameter_error(const PreciseClosest& found, Free free, double h, double cu_error,
                                 double cw_error) const noexcept {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    constexpr double kSolveReserve = 4;
    const double speed = step_.speed, u_size = step_.u_size, w_size = step_.w_size;
    // Whether a squared length is that of an edge which neither the time h nor roundings change by more than 2^-38.
    const auto is_long = [h, speed](double square, double size) {
      constexpr double kLong = 0x1p80;
      return square >= kLong * (16 * h * h * speed * speed) && square * kLong >= size * size;
    };
    // Along one edge, whose product with c may be so large.
    const auto along = [&](double square, double size, double most) {
      return is_long(square, size) ? kSolveReserve * most / square : kUnknown;
    };
    double cu_most = std::fabs(found.cu) + cu_error, cw_most = std::fabs(found.cw) + cw_error;
    switch (free) {
      case Free::none: break;
      case Free::s: {
        const double ds = along(found.uu, u_size, cu_most);
        return {ds, 0, ds * cu_most};
      }
      case Free::q: {
        const double dq = along(found.ww, w_size, cw_most);
        return {0, dq, dq * cw_most};
      }
      case Free::sum: {
        const double most = std::fabs(found.difference) + cu_error + cw_error;
        const double ds = along(found.ee, u_size + w_size, most);
        return {ds, ds, ds * most};
      }
      case Free::both: {
        // Changes by 2^-38 of the lengths, and roundings, change a determinant of this size by less than a tenth.
        const double determinant = found.uu * found.ww - found.uw * found.uw;
        const bool are_long = is_long(found.uu, u_size) && is_long(found.ww, w_size);
        if (!(are_long && determinant >= 0x1p-24 * found.uu * found.ww)) return {kUnknown, kUnknown, kUnknown};
        // The rates solve a system of two equations by Cramer's rule. Let A be u^2 w^2 / determinant, F and G the first
        // derivatives of c . u and c . w: F <= 3 speed (U + C), off by 16 e F, and G likewise. The products and the
        // difference are off by 5 e, the determinant by 4 e A of its size. Put into the first equation, the rates leave
        // less than (2 (16 e + 5 e) A + 8 e A^2) (F + G |u| / |w|), and into the second the same with u for w.
        const double c_size = largest_of(found.c);
        const double amplified = found.uu * found.ww / determinant;
        const double left = 64 * kUnit * amplified * amplified * 3 * speed * h;
        const double ratio = std::sqrt(found.uu / found.ww);
        const double first = left * (u_size + c_size), second = left * (w_size + c_size);
        cu_most += first + second * ratio;
        cw_most += second + first / ratio;
        const double ds = kSolveReserve * (cu_most * found.ww + cw_most * std::fabs(found.uw)) / determinant;
        const double dq = kSolveReserve * (cw_most * found.uu + cu_most * std::fabs(found.uw)) / determinant;
        return {ds, dq, ds * cu_most + dq * cw_most};
      }
    }
    return {0, 0, 0};
  }

  /// The answer, once the exact time is known to lie in [toi, upper], where h = upper - toi and the velocity is that of
  /// c.
  Outcome describe(double toi, double upper, double h, const PreciseClosest& found, const Vector& velocity,
                   double approach, double slope_error, Nature nature) noexcept {
    const double speed = step_.speed;
    const double c_size = largest_of(found.c);
    const double u_size = step_.u_size, w_size = step_.w_size;
    // The exact time is toi + rest. |c|^2 falls by 2 approach a time. That is off by slope_error and by what `approach`
    // itself changes; `approach_error` below asks for less than kSmall of it in all. c is longer than the distance by
    // their difference at the parameters' own errors; that is less than found.error, too.
    constexpr double kSmall = 0x1p-30;
    double rest = 0, rest_error = 0;
    if (h > 0) {
      rest = std::clamp(found.excess / (2 * approach), 0.0, h);
      rest_error = found.error / approach + 4 * kSmall * h;
    }
    // How far the parameters move until the exact time, as far as it is known.
    const Free free = free_parameters(step_.domain, found.p);
    const Parameters rate = rates(found, velocity, free);
    const double shift = (rest + rest_error) * (std::fabs(rate.s) + std::fabs(rate.q));
    constexpr double kMostChange = 0x1p-40;  // small beside the margin of free parameters
    if (!(shift <= kMostChange)) return Outcome::uncertain;
    // How far c . u and c . w, for parameters that move at their rates, may be from 0 at the exact time. Their first
    // derivatives for fixed parameters are at most 3 speed (U + C). Their second ones are at most 6 speed^2 and,
    // because u and w change while the parameters move, 12 (|s'| + |q'|) speed (U + W). The rates' own roundings are
    // relative to the first derivatives. The velocity's part 2 e S, times h <= e, is far below kClosestError S.
    constexpr double kRateError = 0x1p-40;
    const double drift = 4 * speed * (rest_error + kRateError * h);
    const double bend = 8 * h * h * speed * speed + 8 * h * shift * speed * (u_size + w_size);
    const double cu_error = drift * (u_size + c_size) + bend + kClosestError * step_.size * (c_size + u_size);
    const double cw_error = drift * (w_size + c_size) + bend + kClosestError * step_.size * (c_size + w_size);
    const auto [ds, dq, longer] = parameter_error(found, free, h, cu_error, cw_error);
    constexpr double kMostError = 0x1p-52;  // leaves room for roundings below 2^-50
    if (!(ds <= kMostError && dq <= kMostError)) return Outcome::uncertain;
    if (!(longer <= found.error)) return Outcome::uncertain;
    // `approach` changes by |velocity|^2 h, and as c and the velocity change with the parameters: by at most
    // 3 speed (U + W + C) for each unit of these.
    const double approach_error =
        slope_error + 4 * h * speed * speed + 4 * (shift + ds + dq) * speed * (u_size + w_size + c_size);
    if (h > 0 && !(approach_error <= kSmall * approach)) return Outcome::uncertain;
    // Multipliers at the exact time: c . u and c . w also change with the time and the parameters themselves.
    const double moved = 4 * (2 * kMostError + shift) * (u_size + w_size) + 4 * h * speed;
    const double turned = 4 * h * speed * c_size;
    if (!strictly_closest(found, free, cu_error + moved * u_size + turned, cw_error + moved * w_size + turned)) {
      return Outcome::uncertain;
    }
    // The distance falls or rises at the exact time, too, but for elements that do not move against each other.
    const bool still = nature == Nature::sustained && precise_.is_still();
    const bool certain = nature == Nature::entering ? approach > approach_error : std::fabs(approach) > approach_error;
    if (!certain && !still) return Outcome::uncertain;
    answer_.contact = true;
    answer_.toi = toi;
    answer_.toi_upper = upper;
    answer_.nature = nature;
    answer_.trend = still ? Trend::constant : approach > 0 ? Trend::approaching : Trend::leaving;
    answer_.starts_within = nature == Nature::sustained;
    name_closest(kind_, found.p.s + (found.ds + rest * rate.s), found.p.q + (found.dq + rest * rate.q), free, answer_);
    return Outcome::contact;
  }

  /// Whether moving a parameter off its border certainly takes the points apart, to first order.
  bool strictly_closest(const PreciseClosest& found, Free free, double cu_error, double cw_error) const noexcept {
    bool strictly = true;
    for_each_multiplier(step_.domain, free, found.p, [&](int i, int j) {
      const bool of_both = (i != 0 && j != 0) || free == Free::sum;
      const double error = of_both ? 2 * (cu_error + cw_error) : i != 0 ? cu_error : cw_error;
      strictly &= (i == 0 ? j * found.cw : j == 0 ? i * found.cu : j * found.difference) > error;
    });
    return strictly;
  }

  /// The elements are perhaps within the separation at t = 0.
  Outcome starts_within(const StepAt& start) noexcept {
    const PreciseClosest found = precise_closest(step_, precise_, distance_, 0, closest_at(start));
    if (!found.ok || !(found.excess < -found.error)) return Outcome::uncertain;
    const Vector velocity = velocity_of(found);
    const double approach = -dot(found.c, velocity);
    const double speed = step_.speed;
    return describe(0, 0, 0, found, velocity, approach, kWalkError * largest_of(found.c) * (speed + step_.size),
                    Nature::sustained);
  }

  Kind kind_;
  const Separation& separation_;
  double distance_, t_max_;
  Step step_;
  PreciseStep precise_;
  Answer& answer_;
};

}  // namespace

Outcome decide_entry(const Query& query, const Separation& separation, double t_max, Answer& answer) noexcept {
  if (separation.metric == Metric::max) return decide_max_entry(query, separation, t_max, answer);
  return EuclideanEntry(query, separation, t_max, answer).decide();
}

}  // namespace touchstone::filters
