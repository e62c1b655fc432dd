// The walk to an entry in doubles: the closest points at a time, and the directions that keep the elements apart. See
// entry.cpp for the method.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <touchstone/query.hpp>

#include "filters/step_frame.hpp"

namespace touchstone::filters {

using geometry::dot;

// Errors in doubles, e = 2^-53. Let N, R, U, W be the largest absolute coordinates of n and of the computed r, u, w
// over both ends, S = R + U + W. A dot product n . r: coordinates of r are off by e each, products by e, two sums by 2
// e: 4 e times 3 N R, likewise for u and w: 12 e N S for all three. Their sums r - s u - q w at a corner, at most 3 N
// S: two additions, 6 e N S. Between the ends, (1 - t) g0 + t g1: 3 roundings of at most 3 N S: 9 e N S. In all 27 e N
// S to first order. The rest covers a direction whose own coordinates are off by e, another 3 e N S, and second-order
// terms.
constexpr double kWalkError = 32 * kUnit;

// The same for a position between the ends: its coordinates are off by 4 e S, which makes 12 e N S more, and the sum of
// two such products by 3 e (3 N S) of each. Less than 48 e N S for each product.
constexpr double kTurnError = 48 * kUnit;

// The product d |n|: 3.5 e for the norm, 1 e for the product, and the sum with the error.
constexpr double kNormIncrease = 1 + 8 * kUnit;

// The separation, and |c|, are at least this part of S. Then the squares of c's errors do not count.
constexpr double kLeastShare = 0x1p-40;

/// The pairs of corners that bound the parameters.
enum class Domain : std::uint8_t { square, triangle, segment, point };

inline Domain domain_of(Kind kind) noexcept {
  switch (kind) {
    case Kind::edge_edge: return Domain::square;
    case Kind::vertex_face: return Domain::triangle;
    case Kind::point_edge: return Domain::segment;
    case Kind::point_point: break;
  }
  return Domain::point;
}

/// The largest of 0, x and so on over the corners: of s x + q y.
inline double greatest_at_corners(Domain domain, double x, double y) noexcept {
  switch (domain) {
    case Domain::square: return std::max(x, 0.0) + std::max(y, 0.0);
    case Domain::triangle: return std::max({x, y, 0.0});
    case Domain::segment: return std::max(x, 0.0);
    case Domain::point: break;
  }
  return 0;
}

/// A difference of two corners: one minus other.
struct Difference {
  std::size_t one, other;
};

/// r, u and w as differences of corners; w is none for a segment, and u and w for a point.
struct Differences {
  Difference r, u, w;
};

inline Differences differences_of(Kind kind) noexcept {
  switch (kind) {
    case Kind::edge_edge: return {{2, 0}, {1, 0}, {2, 3}};    // b0 - a0, a1 - a0, b0 - b1
    case Kind::vertex_face: return {{0, 1}, {2, 1}, {3, 1}};  // v - f0, f1 - f0, f2 - f0
    case Kind::point_edge: return {{0, 1}, {2, 1}, {0, 0}};   // p - e0, e1 - e0
    case Kind::point_point: break;
  }
  return {{0, 1}, {0, 0}, {0, 0}};
}

inline double largest_of(const Vector& v) noexcept {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

inline Vector difference(const std::array<Vec3, 4>& x, const Difference& d) noexcept {
  const Vec3 &a = x[d.one], &b = x[d.other];
  return {{a.x - b.x, a.y - b.y, a.z - b.z}};
}

inline Vector between(const Vector& a, const Vector& b, double t) noexcept {
  const double s = 1 - t;
  return {{s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]}};
}

/// r - s u - q w.
inline Vector combined(const Vector& r, const Vector& u, const Vector& w, double s, double q) noexcept {
  return {{(r[0] - s * u[0]) - q * w[0], (r[1] - s * u[1]) - q * w[1], (r[2] - s * u[2]) - q * w[2]}};
}

struct Parameters {
  double s, q;
};

inline double unit_clamp(double s) noexcept { return std::min(std::max(s, 0.0), 1.0); }

/// The parameters of the closest points, after Ericson, Real-Time Collision Detection (2005), 5.1.5 and 5.1.9. Only a
/// hint; at a border they are exactly 0 or 1, or add up to 1.
inline Parameters closest(Domain domain, const Vector& r, const Vector& u, const Vector& w) noexcept {
  const double uu = dot(u, u);
  const double ru = dot(r, u);
  if (domain == Domain::point) return {0, 0};
  if (domain == Domain::segment) return {uu > 0 ? unit_clamp(ru / uu) : 0, 0};
  const double ww = dot(w, w), uw = dot(u, w), rw = dot(r, w);
  if (domain == Domain::square) {
    const double determinant = uu * ww - uw * uw;
    double s = determinant > 0 ? unit_clamp((ru * ww - uw * rw) / determinant) : 0;
    double q = ww > 0 ? (rw - uw * s) / ww : 0;
    if (q < 0) {
      q = 0;
      s = uu > 0 ? unit_clamp(ru / uu) : 0;
    } else if (q > 1) {
      q = 1;
      s = uu > 0 ? unit_clamp((ru - uw) / uu) : 0;
    }
    return {s, q};
  }
  if (ru <= 0 && rw <= 0) return {0, 0};
  const double d3 = ru - uu, d4 = rw - uw;  // of the point relative to f1
  if (d3 >= 0 && d4 <= d3) return {1, 0};
  const double d5 = ru - uw, d6 = rw - ww;  // relative to f2
  if (d6 >= 0 && d5 <= d6) return {0, 1};
  const double vc = ru * d4 - d3 * rw;
  if (vc <= 0 && ru >= 0 && d3 <= 0) return {ru / (ru - d3), 0};
  const double vb = d5 * rw - ru * d6;
  if (vb <= 0 && rw >= 0 && d6 <= 0) return {0, rw / (rw - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double q = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    const double s = 1 - q;
    return {s, 1 - s};  // of two such numbers one is exact, so they add up to 1 exactly
  }
  const double denominator = va + vb + vc;
  return {vb / denominator, vc / denominator};
}

/// The step in doubles.
struct Step {
  Domain domain;
  Vector r[2], u[2], w[2];           ///< at both ends
  Vector r_slope, u_slope, w_slope;  ///< the ends' differences
  double size;                       ///< S
  double speed;                      ///< the sum of the slopes' largest absolute coordinates

  explicit Step(const Query& query) noexcept : domain(domain_of(query.kind)) {
    const Differences d = differences_of(query.kind);
    for (std::size_t end = 0; end < 2; ++end) {
      const auto& x = end == 0 ? query.start : query.end;
      r[end] = difference(x, d.r);
      u[end] = difference(x, d.u);
      w[end] = difference(x, d.w);
    }
    size = std::max(largest_of(r[0]), largest_of(r[1])) + std::max(largest_of(u[0]), largest_of(u[1])) +
           std::max(largest_of(w[0]), largest_of(w[1]));
    r_slope = r[1] - r[0];
    u_slope = u[1] - u[0];
    w_slope = w[1] - w[0];
    speed = largest_of(r_slope) + largest_of(u_slope) + largest_of(w_slope);
  }
};

/// A direction, and the least n . c over the corners as a function of time.
class Direction {
 public:
  Direction(const Step& step, const Vector& n, double distance) noexcept : domain_(step.domain) {
    for (int end = 0; end < 2; ++end) {
      r_[end] = dot(n, step.r[end]);
      u_[end] = dot(n, step.u[end]);
      w_[end] = dot(n, step.w[end]);
    }
    error_ = kWalkError * largest_of(n) * step.size;
    // The norm of a direction that is much shorter may underflow. No such c is as long as the separation.
    const bool is_long = largest_of(n) >= 0.5 * kLeastShare * step.size;
    bound_ = is_long ? kNormIncrease * (distance * std::sqrt(dot(n, n)) + error_) : kNever;
  }

  /// The least n . c, off by at most `error`.
  double least_at(double t) const noexcept {
    const double s = 1 - t;
    return (s * r_[0] + t * r_[1]) - greatest_at_corners(domain_, s * u_[0] + t * u_[1], s * w_[0] + t * w_[1]);
  }
  /// Whether every n . c is certainly greater than d |n| at t.
  bool clear_at(double t) const noexcept { return least_at(t) > bound_; }

  /// About the last time after t up to which the direction keeps the elements apart; greater than 1 when it is none.
  double last_clear_after(double t) const noexcept {
    const double wanted = bound_ + 4 * error_;
    double last = 2;
    const auto corner = [&](double s, double q) {
      const double start = (r_[0] - s * u_[0]) - q * w_[0];
      const double slope = (r_[1] - s * u_[1]) - q * w_[1] - start;
      const double value = start + t * slope;
      if (slope < 0) last = std::min(last, t + (value - wanted) / -slope);
    };
    corner(0, 0);
    if (domain_ != Domain::point) corner(1, 0);
    if (domain_ == Domain::square || domain_ == Domain::triangle) corner(0, 1);
    if (domain_ == Domain::square) corner(1, 1);
    return last;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  Domain domain_;
  double r_[2], u_[2], w_[2];
  double error_, bound_;
};

/// The closest points at a time, in doubles.
struct Place {
  double t;
  Parameters p;
  Vector r, u, w, c;
  double approach;  ///< half of how fast |c|^2 falls

  /// About the time until |c| is the distance; infinite when c does not become shorter.
  double until_entry(double distance) const noexcept {
    const double length = std::sqrt(dot(c, c));
    return approach > 0 ? (length - distance) * length / approach : std::numeric_limits<double>::infinity();
  }
};

inline Place place_at(const Step& step, double t) noexcept {
  Place place = {
      t,  {}, between(step.r[0], step.r[1], t), between(step.u[0], step.u[1], t), between(step.w[0], step.w[1], t),
      {}, 0};
  place.p = closest(step.domain, place.r, place.u, place.w);
  place.c = combined(place.r, place.u, place.w, place.p.s, place.p.q);
  place.approach = -dot(place.c, combined(step.r_slope, step.u_slope, step.w_slope, place.p.s, place.p.q));
  return place;
}

/// Whether a direction that turns from one place's c to the other's keeps the elements apart between them, if each does
/// so at its own time.
inline bool turns_clear(const Step& step, const Place& a, const Place& b, double distance) noexcept {
  const double least = (dot(a.c, b.r) + dot(b.c, a.r)) -
                       greatest_at_corners(step.domain, dot(a.c, b.u) + dot(b.c, a.u), dot(a.c, b.w) + dot(b.c, a.w));
  const double norms = std::sqrt(dot(a.c, a.c)) + std::sqrt(dot(b.c, b.c));
  const double error = kTurnError * (largest_of(a.c) + largest_of(b.c)) * step.size;
  return least > kNormIncrease * (distance * norms + error);
}

}  // namespace touchstone::filters
