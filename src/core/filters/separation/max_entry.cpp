// In the largest-axis metric, the elements are within d of each other when the polygon of all differences c = r - s u -
// q w meets the cube [-d, d]^3. The sum of the polygon and the cube has facets of three sorts. So these directions n
// are enough to tell (separating axes of two convex bodies):
//   face:  n is an axis: a face of the cube and a corner of the polygon;
//   edge:  n = axis x e: an edge of the cube and an edge e of the polygon;
//   plane: n = u x w: a corner of the cube and the polygon itself.
// D(t) is the largest value of n . c / |n|_1 over these n, each at the corner c at which n . c is least.
//
// Near the entry one facet decides. Let p be a corner of the polygon on it, sigma_k the sign of n_k, and
// a = p - d sigma. Then h(t) = n . a = n . p - d |n|_1 is a polynomial of degree 1, 2 or 3. It is evaluated in
// double-doubles at two neighbouring doubles.
//   D > d at toi: h > 0 there, and the other corners have greater n . c. Before toi: see the walk.
//   D = d at a root of h between the two doubles: c = d sigma along the axes with n_k != 0 is a linear system for the
//   point on the facet. Its solution must lie inside the polygon's edge or plane, and within d along the other axes.
//   After the root D < d: as h falls, so does the level at which the system's solution lies, and with it D.
// The other corners have greater n . c, and every n_k of an edge or plane is not zero. So no other point is as near.
// SPDX-License-Identifier: MIT
#include "filters/separation/max_entry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "filters/separation/entry_walk.hpp"
#include "filters/separation/precise_facet.hpp"

namespace touchstone::filters {
namespace {

// Errors in doubles, in units of e = 2^-53: a coordinate of n is off by at most 16 N, of a position by 8 S. A product
// of two such vectors is off by less than 3 (16 + 8 + 4) N S = 84 N S.
constexpr double kError = 128 * kUnit;

class MaxEntry {
 public:
  MaxEntry(const Query& query, const Separation& separation, double t_max, Answer& answer) noexcept
      : kind_(query.kind),
        separation_(separation),
        distance_(separation.distance),
        t_max_(t_max),
        step_(query),
        precise_(query),
        answer_(answer) {}

  Outcome decide() noexcept {
    return decide_by_walk(
        step_, separation_, t_max_, [this](double t) { return facet_iterate(t); },
        [this](const StepAt& from) { return enter(from); },
        [this](const StepAt& start) { return starts_within(start); });
  }

 private:
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
    if (slope < 0) iterate.until = (distance - distance_) * norm / -slope;
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

  /// How fast h falls, and how far the rate may be off over a time after `at_t`. Derivatives: h' = n' . a + n . p',
  /// with |n'_k| at most 0, speed, or 4 speed S, and h'' = n'' . a + 2 n' . p'. A slope is a difference of two
  /// roundings, so it is off by e (speed + 2 S).
  struct Fall {
    double rate, error;
  };
  Fall fall_of(const Facet& facet, const PreciseFacet& at_t, double time) const noexcept {
    const Vector n = rounded_vector(at_t.n), a = rounded_vector(at_t.a);
    const Vector n_rate = normal_rate(facet, rounded_vector(at_t.u), rounded_vector(at_t.w));
    const Vector velocity = corner_velocity(facet);
    double rate = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (at_t.sign[k] != 0) rate -= n_rate[k] * a[k] + n[k] * velocity[k];
    }
    const double speed = step_.speed, reach = step_.size + distance_;
    double first = speed + step_.size, second = 0;  // at least a part of the terms of h', and of those of h''
    if (facet.sort == Sort::edge) {
      first *= reach;
      second = speed * speed;
    } else if (facet.sort == Sort::plane) {
      first *= step_.size * reach;
      second = speed * speed * reach;
    }
    return {rate, 256 * kUnit * first + 64 * time * second};
  }

  /// The elements are apart up to an iterate, and come within the separation soon after it.
  Outcome enter(const StepAt& from) noexcept {
    const double estimate = from.t + from.until;
    if (!(estimate >= 0 && estimate <= 1)) return Outcome::uncertain;
    const auto [facet, distance] = FacetSearch(step_.domain, bare_iterate(step_, estimate)).best();
    if (!(distance > 0)) return Outcome::uncertain;
    // Newton's steps in double-doubles find the neighbouring doubles.
    double toi = estimate;
    constexpr int kMostSteps = 4;
    for (int i = 0; i < kMostSteps; ++i) {
      const PreciseFacet found = precise_facet(precise_, facet, toi, {distance_, 0});
      const double upper = std::nextafter(toi, 2.0);
      const Fall fall = fall_of(facet, found, upper - toi);
      if (!(fall.rate > fall.error)) return Outcome::uncertain;
      const double rest = rounded(found.h) / fall.rate;  // until the entry
      if (!(rest > 0 && rest < upper - toi)) {
        const DoubleDouble better = numbers::two_sum(toi, rest);
        const double below = better.low < 0 ? std::nextafter(better.high, -1.0) : better.high;
        if (below == toi || !(below >= 0 && below <= 1)) return Outcome::uncertain;
        toi = below;
        continue;
      }
      return conclude(from, facet, toi, upper, found, fall);
    }
    return Outcome::uncertain;
  }

  Outcome conclude(const StepAt& from, const Facet& facet, double toi, double upper, const PreciseFacet& found,
                   const Fall& fall) noexcept {
    const double error = kFacetError * normal_size(step_, facet) * (step_.size + distance_);
    if (!(rounded(found.h) > error)) return Outcome::uncertain;
    if (!stands_alone(facet, found) || !solve(facet, found).ok) return Outcome::uncertain;
    if (toi > from.t) {
      if (!stays_clear(step_, from, toi, scaled_direction(rounded_vector(found.n)), separation_)) {
        return Outcome::uncertain;
      }
    }
    if (upper > t_max_) return Outcome::no_contact;
    const PreciseFacet next = precise_facet(precise_, facet, upper, {distance_, 0});
    if (!(rounded(next.h) < -error)) return Outcome::uncertain;
    // h falls evenly but for a small rest, so the root is at this fraction of the time between the doubles.
    constexpr double kSmall = 0x1p-20;
    if (!(fall.error <= kSmall * fall.rate)) return Outcome::uncertain;
    const double fraction = rounded(found.h) / (rounded(found.h) - rounded(next.h));
    if (!locate(facet, found, &next, fraction, upper - toi, distance_)) return Outcome::uncertain;
    answer_.nature = Nature::entering;
    answer_.trend = Trend::approaching;
    return finish(toi, upper);
  }

  /// Whether every n_k that counts is certainly not zero, and all corners of the polygon that are not on the facet have
  /// certainly greater n . c. Both from the time of `found` to the next double, over which n . u changes by less than
  /// 16 e N speed.
  bool stands_alone(const Facet& facet, const PreciseFacet& found) const noexcept {
    const Vector n = rounded_vector(found.n);
    const double size = normal_size(step_, facet);
    const double change = facet.sort == Sort::plane ? step_.size * step_.speed : step_.speed;
    if (facet.sort != Sort::face) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (found.sign[k] != 0 && !(std::fabs(n[k]) > kError * (size + change))) return false;
      }
    }
    if (facet.sort == Sort::plane) return true;
    const double margin = kError * size * (step_.size + step_.speed);
    const double u = dot(n, rounded_vector(found.u)), w = dot(n, rounded_vector(found.w));
    bool farther = true;
    for_each_multiplier(step_.domain, facet.free, {facet.s, facet.q},
                        [&](int i, int j) { farther &= i * u + j * w > margin; });
    return farther;
  }

  /// The parameters at which c is the level along the axes that count.
  struct Solution {
    double s, q;
    double size;  ///< of the number by which both are divided
    bool ok;
  };
  Solution solve(const Facet& facet, const PreciseFacet& found) const noexcept {
    // What is divided is off by less than kFacetError times this.
    const double reach = step_.size + distance_;
    constexpr double kMostError = 0x1p-60;
    if (facet.sort == Sort::face) return {facet.s, facet.q, 1, true};
    if (facet.sort == Sort::edge) {
      std::size_t k = (facet.axis + 1) % 3;
      if (std::fabs(rounded(found.e[k])) < std::fabs(rounded(found.e[(facet.axis + 2) % 3]))) k = (facet.axis + 2) % 3;
      const double e = rounded(found.e[k]);
      const double x = rounded(found.a[k]) / e;
      const bool ok = kFacetError * reach <= kMostError * std::fabs(e);
      if (facet.free == Free::sum) return {1 - x, x, std::fabs(e), ok};
      return facet.free == Free::s ? Solution{x, facet.q, std::fabs(e), ok} : Solution{facet.s, x, std::fabs(e), ok};
    }
    // a = s u + q w.
    std::size_t k = std::fabs(rounded(found.n[0])) > std::fabs(rounded(found.n[1])) ? 0 : 1;
    if (std::fabs(rounded(found.n[2])) > std::fabs(rounded(found.n[k]))) k = 2;
    const double n = facet.sign * rounded(found.n[k]);
    const double s = rounded(geometry::cross_component(found.a, found.w, k)) / n;
    const double q = rounded(geometry::cross_component(found.u, found.a, k)) / n;
    return {s, q, std::fabs(n), kFacetError * step_.size * reach <= kMostError * std::fabs(n)};
  }

  /// Writes the closest points at the time between `found` and `next` of which `fraction` of the time is gone, for a
  /// distance about `level` at that time; at the time of `found` when there is no `next`. False where they are not
  /// certain. `time`: between the two.
  bool locate(const Facet& facet, const PreciseFacet& found, const PreciseFacet* next, double fraction, double time,
              double level) noexcept {
    Solution at_root = solve(facet, found);
    if (!at_root.ok) return false;
    if (next != nullptr && facet.sort != Sort::face) {
      // The parameters are quotients of polynomials, whose second-order terms over the time do not count: at most 2^-34
      // of change, off by a relative 2^-20, and second derivatives of at most 16 speed^2 in the numerators.
      const Solution later = solve(facet, *next);
      constexpr double kMostChange = 0x1p-34, kMostBend = 0x1p-60;
      const double ds = later.s - at_root.s, dq = later.q - at_root.q;
      if (!(later.ok && std::fabs(ds) <= kMostChange && std::fabs(dq) <= kMostChange)) return false;
      const double turn = facet.sort == Sort::plane ? 8 * step_.size * step_.speed : 2 * step_.speed;
      if (!(time * turn <= kMostChange * at_root.size)) return false;
      if (!(time * time * 16 * step_.speed * step_.speed <= kMostBend * at_root.size)) return false;
      at_root.s += fraction * ds;
      at_root.q += fraction * dq;
    }
    if (!inside(facet, at_root)) return false;
    // Along the other axes c is certainly shorter than the level, also while the time goes on to the next double.
    const Vector c =
        combined(rounded_vector(found.r), rounded_vector(found.u), rounded_vector(found.w), at_root.s, at_root.q);
    const double most = level - kError * (step_.size + step_.speed + level);
    for (std::size_t k = 0; k < 3; ++k) {
      if (found.sign[k] == 0 && !(std::fabs(c[k]) < most)) return false;
    }
    name_closest(kind_, at_root.s, at_root.q, facet.free, answer_);
    return true;
  }

  /// Whether free parameters are certainly those of an interior.
  bool inside(const Facet& facet, const Solution& p) const noexcept {
    constexpr double kMargin = 0x1p-32;
    const auto between_ends = [](double x) { return x >= kMargin && x <= 1 - kMargin; };
    switch (facet.free) {
      case Free::none: return true;
      case Free::s: return between_ends(p.s);
      case Free::q:
      case Free::sum: return between_ends(p.q);
      case Free::both: break;
    }
    return between_ends(p.s) && between_ends(p.q) && (step_.domain == Domain::square || between_ends((1 - p.s) - p.q));
  }

  Outcome finish(double toi, double upper) noexcept {
    answer_.contact = true;
    answer_.toi = toi;
    answer_.toi_upper = upper;
    return Outcome::contact;
  }

  /// The elements are perhaps within the separation at t = 0.
  Outcome starts_within(const StepAt& start) noexcept {
    const auto [facet, distance] = FacetSearch(step_.domain, start).best();
    if (!(distance > 0)) return Outcome::uncertain;
    // The level at which h = 0: D, if the closest points are found.
    const PreciseFacet zero = precise_facet(precise_, facet, 0, {0, 0});
    const Vector n = rounded_vector(zero.n);
    double norm = 0;
    for (std::size_t k = 0; k < 3; ++k) norm += std::fabs(n[k]);
    const double first = rounded(zero.h) / norm;
    const PreciseFacet near = precise_facet(precise_, facet, 0, {first, 0});
    const double rest = rounded(near.h) / norm;
    const double level = first + rest;
    const double margin = kError * (step_.size + distance_);
    if (!(level > margin && level < distance_ - margin)) return Outcome::uncertain;
    const PreciseFacet found = precise_facet(precise_, facet, 0, numbers::two_sum(first, rest));
    if (!stands_alone(facet, found)) return Outcome::uncertain;
    const Fall fall = fall_of(facet, found, 0);
    const bool still = precise_.is_still();
    if (!still && !(std::fabs(fall.rate) > fall.error)) return Outcome::uncertain;
    if (!locate(facet, found, nullptr, 0, 0, level)) return Outcome::uncertain;
    answer_.nature = Nature::sustained;
    answer_.trend = still ? Trend::constant : fall.rate > 0 ? Trend::approaching : Trend::leaving;
    answer_.starts_within = true;
    return finish(0, 0);
  }

  Kind kind_;
  const Separation& separation_;
  double distance_, t_max_;
  Step step_;
  PreciseStep precise_;
  Answer& answer_;
};

}  // namespace

Outcome decide_max_entry(const Query& query, const Separation& separation, double t_max, Answer& answer) noexcept {
  return MaxEntry(query, separation, t_max, answer).decide();
}

}  // namespace touchstone::filters
