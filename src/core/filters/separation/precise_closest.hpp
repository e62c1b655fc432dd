// The closest points of two elements at one time, in double-doubles. entry.cpp places the entry of a Euclidean
// separation with them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "filters/separation/entry_step.hpp"

namespace touchstone::filters {

// Errors in double-doubles, in e^2 = 2^-106. A coordinate of u at t is off by less than 40 e^2 U (see entry_step.hpp).
// Products with s and q in [0, 1] and the sums c = r - s u - q w: less than 80 e^2 S for a coordinate of c. A dot
// product of c, of coordinates at most C, with u: 3 C (40 + 24) e^2 U and sums: less than 300 e^2 C U. The same for c .
// c with the error of c itself: 2 * 3 * 80 e^2 C S and less than 100 e^2 C C. The sum c . c + (s - i) c . u + (q - j) c
// . w is then off by less than 1200 e^2 C S, as C is at most S.
constexpr double kClosestError = 2048 * 0x1p-106;

// The gradient along a parameter is P . u, with P the true difference: c is off by 80 e^2 S in each coordinate, so the
// gradient by another 240 e^2 S U. The bound above covers it with S in place of C.

struct PreciseClosest {
  Parameters p;           ///< s and q, whose corrections are left out
  double ds = 0, dq = 0;  ///< the corrections
  Vector c;               ///< rounded
  double excess;          ///< |c|^2 - d^2
  double cu, cw;          ///< c . u and c . w; about 0 along free parameters
  double difference;      ///< c . w - c . u
  double lowest;          ///< the least c . (corner - c) over the corners, for the direction c that is computed
  double error;           ///< of the excess and of `lowest`
  Vector u, w;            ///< rounded
  double uu, ww, uw;
  double ee = 0;  ///< (u - w) . (u - w), for the border s + q = 1 only
  bool ok = false;
};

/// v - factor d.
inline PreciseVector minus(const PreciseVector& v, double factor, const PreciseVector& d) noexcept {
  PreciseVector result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = numbers::normalised(v[k] - factor * d[k]);
  return result;
}

/// The changes of the free parameters that change c . u by -cu and c . w by -cw.
/// @param difference  cu - cw, which may cancel
inline Parameters changes_of_free(const PreciseClosest& at_t, Free free, double cu, double cw,
                                  double difference) noexcept {
  switch (free) {
    case Free::none: break;
    case Free::s: return {cu / at_t.uu, 0};
    case Free::q: return {0, cw / at_t.ww};
    case Free::sum: {
      const double ds = difference / at_t.ee;
      return {ds, -ds};
    }
    case Free::both: {
      const double determinant = at_t.uu * at_t.ww - at_t.uw * at_t.uw;
      return {(cu * at_t.ww - cw * at_t.uw) / determinant, (cw * at_t.uu - cu * at_t.uw) / determinant};
    }
  }
  return {0, 0};
}

/// Whether the corrected parameters are those of points of the elements: free ones are inside by more than the
/// corrections, and the others are exactly at an end. Corrections are at most 2^-20 each, and 2^-22 in all where
/// closest_near.hpp corrects once more. So a free weight stays 2^-20 or more from 0 and 1, also the one that both
/// correct.
inline bool are_inside(Domain domain, Free free, const Parameters& p) noexcept {
  constexpr double kMargin = 0x1p-18;
  const auto inside = [](double x) { return x >= kMargin && x <= 1 - kMargin; };
  const auto at_end = [](double x) { return x == 0 || x == 1; };
  switch (free) {
    case Free::none: return at_end(p.s) && at_end(p.q) && (domain == Domain::square || p.s + p.q <= 1);
    case Free::s: return inside(p.s) && at_end(p.q);
    case Free::q: return inside(p.q) && at_end(p.s);
    case Free::sum: return inside(p.s) && inside(p.q) && p.s + p.q == 1;
    case Free::both: return inside(p.s) && inside(p.q) && (domain == Domain::square || inside(p.s + p.q));
  }
  return false;
}

/// At most the least of c . (corner - c), where corner (i, j) - c is (s - i) u + (q - j) w. It is a sum of products
/// that are not positive, so nothing cancels. A weight that is not 0 or 1 is at least 2^-20 (see `are_inside`)
/// and off by at most 2 e = 2^-52, so each product is off by less than a 2^-32nd part.
inline double lowest_at_corners(Domain domain, const PreciseClosest& at_t) noexcept {
  const double s = at_t.p.s + at_t.ds, q = at_t.p.q + at_t.dq;
  const auto on_edge = [](double x, double slope) { return slope > 0 ? -(1 - x) * slope : x * slope; };
  switch (domain) {
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

/// The closest points at t near the parameters p, made exact enough by one of Newton's steps towards c . u = c . w = 0;
/// not `ok` where it leads too far, where c is too short, and where a free parameter is at a border.
/// @param distance  d
inline PreciseClosest precise_closest(const Step& step, const PreciseStep& precise, double distance, double t,
                                      const Parameters& p) noexcept {
  PreciseClosest at_t;
  at_t.p = p;
  const PreciseVector r = at(precise.r, t), u = at(precise.u, t), w = at(precise.w, t);
  at_t.u = rounded_vector(u);
  at_t.w = rounded_vector(w);
  at_t.uu = dot(at_t.u, at_t.u);
  at_t.ww = dot(at_t.w, at_t.w);
  at_t.uw = dot(at_t.u, at_t.w);
  const Free free = free_parameters(step.domain, p);
  if (free == Free::sum) {
    const Vector e = rounded_vector(minus(u, 1, w));  // uu - 2 uw + ww would cancel
    at_t.ee = dot(e, e);
  }
  PreciseVector c = minus(minus(r, p.s, u), p.q, w);
  // Along the border s + q = 1 both are large and nearly equal.
  const DoubleDouble slope_s = dot(c, u), slope_q = dot(c, w);
  const auto [ds, dq] = changes_of_free(at_t, free, rounded(slope_s), rounded(slope_q), rounded(slope_s - slope_q));
  constexpr double kLargestCorrection = 0x1p-20;  // a larger one shows that the hint is wrong
  if (!(std::fabs(ds) <= kLargestCorrection && std::fabs(dq) <= kLargestCorrection)) return at_t;
  at_t.ds = ds;
  at_t.dq = dq;
  c = minus(minus(c, ds, u), dq, w);
  at_t.c = rounded_vector(c);
  const DoubleDouble square = dot(c, c);
  at_t.excess = rounded(square - numbers::two_product(distance, distance));
  const DoubleDouble cu = dot(c, u), cw = dot(c, w);
  at_t.cu = rounded(cu);
  at_t.cw = rounded(cw);
  at_t.difference = rounded(cw - cu);
  at_t.lowest = lowest_at_corners(step.domain, at_t) * (1 + 0x1p-32);
  at_t.error = kClosestError * largest_of(at_t.c) * step.size + 8 * kUnit * std::fabs(at_t.excess);
  at_t.ok = largest_of(at_t.c) >= kLeastFraction * step.size && are_inside(step.domain, free, p);
  return at_t;
}

}  // namespace touchstone::filters
