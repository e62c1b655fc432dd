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

#include "filters/separation/entry_walk.hpp"
#include "filters/separation/max_entry.hpp"

namespace touchstone::filters {
namespace {

// Errors in double-doubles, in e^2 = 2^-106. A coordinate of u at t is off by less than 40 e^2 U (see entry_step.hpp).
// Products with s and q in [0, 1] and the sums c = r - s u - q w: less than 80 e^2 S for a coordinate of c. A dot
// product of c, of coordinates at most C, with u: 3 C (40 + 24) e^2 U and sums: less than 300 e^2 C U. The same for c .
// c with the error of c itself: 2 * 3 * 80 e^2 C S and less than 100 e^2 C C. The sum c . c + (s - i) c . u + (q - j) c
// . w is then off by less than 1200 e^2 C S, as C is at most S.
constexpr double kPreciseError = 2048 * 0x1p-106;

// The gradient along a parameter is P . u, with P the true difference: c is off by 80 e^2 S in each coordinate, so the
// gradient by another 240 e^2 S U. The bound above covers it with S in place of C.

/// v - factor d.
PreciseVector minus(const PreciseVector& v, double factor, const PreciseVector& d) noexcept {
  PreciseVector result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = numbers::normalised(v[k] - factor * d[k]);
  return result;
}

/// The closest points at one time, in double-doubles.
struct ClosestPoints {
  Parameters p;           ///< s and q, whose corrections are left out
  double ds = 0, dq = 0;  ///< the corrections
  Vector c;               ///< rounded
  double excess;          ///< |c|^2 - d^2
  double cu, cw;          ///< c . u and c . w; about 0 along free parameters
  double difference;      ///< c . w - c . u
  double lowest;          ///< the least c . (corner - c) over the corners
  double error;           ///< of the excess and of `lowest`
  Vector u, w;            ///< rounded
  double uu, ww, uw;
  double ee = 0;  ///< (u - w) . (u - w), for the border s + q = 1 only
  bool ok = false;
};

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

  /// The closest points at t near the parameters p, made exact enough.
  ClosestPoints refine(double t, const Parameters& p) const noexcept {
    ClosestPoints at_t;
    at_t.p = p;
    const PreciseVector r = at(precise_.r, t), u = at(precise_.u, t), w = at(precise_.w, t);
    at_t.u = rounded_vector(u);
    at_t.w = rounded_vector(w);
    at_t.uu = dot(at_t.u, at_t.u);
    at_t.ww = dot(at_t.w, at_t.w);
    at_t.uw = dot(at_t.u, at_t.w);
    const Free free = free_parameters(step_.domain, p);
    if (free == Free::sum) {
      const Vector e = rounded_vector(minus(u, 1, w));  // uu - 2 uw + ww would cancel
      at_t.ee = dot(e, e);
    }
    PreciseVector c = minus(minus(r, p.s, u), p.q, w);
    // Along the border s + q = 1 both are large and nearly equal.
    const DoubleDouble slope_s = dot(c, u), slope_q = dot(c, w);
    if (!correct(at_t, free, rounded(slope_s), rounded(slope_q), rounded(slope_s - slope_q))) return at_t;
    c = minus(minus(c, at_t.ds, u), at_t.dq, w);
    at_t.c = rounded_vector(c);
    const DoubleDouble square = dot(c, c);
    at_t.excess = rounded(square - numbers::two_product(distance_, distance_));
    const DoubleDouble cu = dot(c, u), cw = dot(c, w);
    at_t.cu = rounded(cu);
    at_t.cw = rounded(cw);
    at_t.difference = rounded(cw - cu);
    at_t.lowest = lowest_at_corners(at_t) * (1 + 0x1p-32);
    at_t.error = kPreciseError * largest_of(at_t.c) * step_.size + 8 * kUnit * std::fabs(at_t.excess);
    at_t.ok = largest_of(at_t.c) >= kLeastFraction * step_.size;
    return at_t;
  }

  /// At most the least of c . (corner - c), where corner (i, j) - c is (s - i) u + (q - j) w. It is a sum of products
  /// that are not positive, so nothing cancels. A weight that is not 0 or 1 is at least 2^-20 (see `allowed`) and off
  /// by at most 2 e = 2^-52, so each product is off by less than 2^-32 of it.
  double lowest_at_corners(const ClosestPoints& at_t) const noexcept {
    const double s = at_t.p.s + at_t.ds, q = at_t.p.q + at_t.dq;
    const auto on_edge = [](double x, double slope) { return slope > 0 ? -(1 - x) * slope : x * slope; };
    switch (step_.domain) {
      case Domain::square: return on_edge(s, at_t.cu) + on_edge(q, at_t.cw);
      case Domain::segment: return on_edge(s, at_t.cu);
      case Domain::point: return 0;
      case Domain::triangle: break;
    }
    const auto below_zero = [](double a, double b) { return std::min(a, 0.0) + std::min(b, 0.0); };
    const double rest = (1 - at_t.p.s - at_t.p.q) - (at_t.ds + at_t.dq);  // f0's weight
    return std::min({below_zero(s * at_t.cu, q * at_t.cw), below_zero(q * at_t.difference, -rest * at_t.cu),
                     below_zero(-s * at_t.difference, -rest * at_t.cw)});
  }

  /// Newton's step of the free parameters towards c . u = c . w = 0. False where it is not determined.
  static bool correct(ClosestPoints& at_t, Free free, double cu, double cw, double difference) noexcept {
    switch (free) {
      case Free::none: return true;
      case Free::s: at_t.ds = cu / at_t.uu; break;
      case Free::q: at_t.dq = cw / at_t.ww; break;
      case Free::sum:
        at_t.ds = difference / at_t.ee;
        at_t.dq = -at_t.ds;
        break;
      case Free::both: {
        const double determinant = at_t.uu * at_t.ww - at_t.uw * at_t.uw;
        at_t.ds = (cu * at_t.ww - cw * at_t.uw) / determinant;
        at_t.dq = (cw * at_t.uu - cu * at_t.uw) / determinant;
        break;
      }
    }
    constexpr double kLargestCorrection = 0x1p-20;  // a larger one shows that the hint is wrong
    return std::fabs(at_t.ds) <= kLargestCorrection && std::fabs(at_t.dq) <= kLargestCorrection;
  }

  /// The corrected parameters are those of points of the elements: free ones are inside by more than the corrections.
  /// Those are at most 2^-20 each, so a free weight stays 2^-20 or more from 0 and 1, also the one that both correct.
  bool allowed(const ClosestPoints& at_t) const noexcept {
    constexpr double kMargin = 0x1p-18;
    const Parameters& p = at_t.p;
    const auto inside = [](double x) { return x >= kMargin && x <= 1 - kMargin; };
    switch (free_parameters(step_.domain, p)) {
      case Free::none: return true;
      case Free::s: return inside(p.s);
      case Free::q: return inside(p.q);
      case Free::sum: return inside(p.s) && inside(p.q) && p.s + p.q == 1;
      case Free::both: return inside(p.s) && inside(p.q) && (step_.domain == Domain::square || inside(p.s + p.q));
    }
    return false;
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
      const ClosestPoints found = refine(toi, p);
      if (!found.ok || !allowed(found)) return Outcome::uncertain;
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

  Vector velocity_of(const ClosestPoints& found) const noexcept {
    return combined(step_.r_slope, step_.u_slope, step_.w_slope, found.p.s + found.ds, found.p.q + found.dq);
  }

  Outcome conclude(const StepAt& from, double toi, double upper, const ClosestPoints& found,
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
  Parameters rates(const ClosestPoints& found, const Vector& velocity, Free free) const noexcept {
    const double u = dot(velocity, found.u) + dot(found.c, step_.u_slope);
    const double w = dot(velocity, found.w) + dot(found.c, step_.w_slope);
    switch (free) {
      case Free::none: break;
      case Free::s: return {u / found.uu, 0};
      case Free::q: return {0, w / found.ww};
      case Free::sum: {
        const double rate = (u - w) / found.ee;
        return {rate, -rate};
      }
      case Free::both: {
        const double determinant = found.uu * found.ww - found.uw * found.uw;
        return {(u * found.ww - w * found.uw) / determinant, (w * found.uu - u * found.uw) / determinant};
      }
    }
    return {0, 0};
  }

  /// The answer, once the exact time is known to lie in [toi, upper], where h = upper - toi and the velocity is that of
  /// c.
  Outcome describe(double toi, double upper, double h, const ClosestPoints& found, const Vector& velocity,
                   double approach, double slope_error, Nature nature) noexcept {
    const double speed = step_.speed;
    const double c_size = largest_of(found.c);
    const double u_size = std::max(largest_of(step_.u[0]), largest_of(step_.u[1]));
    const double w_size = std::max(largest_of(step_.w[0]), largest_of(step_.w[1]));
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
    // relative to the first derivatives. The velocity's part 2 e S, times h <= e, is far below kPreciseError S.
    constexpr double kRateError = 0x1p-40;
    const double drift = 4 * speed * (rest_error + kRateError * h);
    const double bend = 8 * h * h * speed * speed + 8 * h * shift * speed * (u_size + w_size);
    const double cu_error = drift * (u_size + c_size) + bend + kPreciseError * step_.size * (c_size + u_size);
    const double cw_error = drift * (w_size + c_size) + bend + kPreciseError * step_.size * (c_size + w_size);
    double cu_most = std::fabs(found.cu) + cu_error;
    double cw_most = std::fabs(found.cw) + cw_error;
    // Whether a squared length is that of an edge which neither the time h nor roundings change by more than 2^-38.
    const auto is_long = [h, speed](double square, double size) {
      constexpr double kLong = 0x1p80;
      return square >= kLong * (16 * h * h * speed * speed) && square * kLong >= size * size;
    };
    double ds = 0, dq = 0;  // how far the parameters may be from those of the exact time
    double longer = 0;      // at least as much as |c|^2 may exceed the squared distance for that
    constexpr double kSolveReserve = 4;
    switch (free) {
      case Free::none: break;
      case Free::s:
        if (!is_long(found.uu, u_size)) return Outcome::uncertain;
        ds = kSolveReserve * cu_most / found.uu;
        longer = ds * cu_most;
        break;
      case Free::q:
        if (!is_long(found.ww, w_size)) return Outcome::uncertain;
        dq = kSolveReserve * cw_most / found.ww;
        longer = dq * cw_most;
        break;
      case Free::sum: {
        if (!is_long(found.ee, u_size + w_size)) return Outcome::uncertain;
        const double most = std::fabs(found.difference) + cu_error + cw_error;
        ds = dq = kSolveReserve * most / found.ee;
        longer = ds * most;
        break;
      }
      case Free::both: {
        // Changes by 2^-38 of the lengths, and roundings, change a determinant of this size by less than a tenth.
        const double determinant = found.uu * found.ww - found.uw * found.uw;
        if (!is_long(found.uu, u_size) || !is_long(found.ww, w_size)) return Outcome::uncertain;
        if (!(determinant >= 0x1p-24 * found.uu * found.ww)) return Outcome::uncertain;
        // The rates solve a system of two equations by Cramer's rule. Let A be u^2 w^2 / determinant, F and G the first
        // derivatives of c . u and c . w: F <= 3 speed (U + C), off by 16 e F, and G likewise. The products and the
        // difference are off by 5 e, the determinant by 4 e A of its size. Put into the first equation, the rates leave
        // less than (2 (16 e + 5 e) A + 8 e A^2) (F + G |u| / |w|), and into the second the same with u for w.
        const double amplified = found.uu * found.ww / determinant;
        const double left = 64 * kUnit * amplified * amplified * 3 * speed * h;
        const double ratio = std::sqrt(found.uu / found.ww);
        const double first = left * (u_size + c_size), second = left * (w_size + c_size);
        cu_most += first + second * ratio;
        cw_most += second + first / ratio;
        ds = kSolveReserve * (cu_most * found.ww + cw_most * std::fabs(found.uw)) / determinant;
        dq = kSolveReserve * (cw_most * found.uu + cu_most * std::fabs(found.uw)) / determinant;
        longer = ds * cu_most + dq * cw_most;
        break;
      }
    }
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
  bool strictly_closest(const ClosestPoints& found, Free free, double cu_error, double cw_error) const noexcept {
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
    const ClosestPoints found = refine(0, closest_at(start));
    if (!found.ok || !allowed(found) || !(found.excess < -found.error)) return Outcome::uncertain;
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
