// One step of two elements as differences of corners, for the filters that find when a separation is entered.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "filters/step_frame.hpp"
#include "numbers/doubles/double_double.hpp"

namespace touchstone::filters {

using geometry::dot;
using numbers::DoubleDouble;
using numbers::rounded;
using PreciseVector = geometry::Vector<DoubleDouble>;

// The separation, and |c|, are at least this fraction of S. Then the squares of c's errors do not count.
constexpr double kLeastFraction = 0x1p-40;

// Sizes for which no product of five factors overflows, or underflows by more than the bounds allow.
constexpr double kLeastSize = 0x1p-150;
constexpr double kGreatestSize = 0x1p150;

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
  double u_size, w_size;             ///< U and W, their largest absolute coordinates
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
    u_size = std::max(largest_of(u[0]), largest_of(u[1]));
    w_size = std::max(largest_of(w[0]), largest_of(w[1]));
    size = std::max(largest_of(r[0]), largest_of(r[1])) + u_size + w_size;
    r_slope = r[1] - r[0];
    u_slope = u[1] - u[0];
    w_slope = w[1] - w[0];
    speed = largest_of(r_slope) + largest_of(u_slope) + largest_of(w_slope);
  }
};

/// The step in double-doubles: differences of corners, exactly.
struct PreciseStep {
  PreciseVector r[2], u[2], w[2];

  explicit PreciseStep(const Query& query) noexcept {
    const Differences d = differences_of(query.kind);
    for (std::size_t end = 0; end < 2; ++end) {
      const auto& x = end == 0 ? query.start : query.end;
      r[end] = exact(x, d.r);
      u[end] = exact(x, d.u);
      w[end] = exact(x, d.w);
    }
  }
  /// Whether all differences are the same at both ends: the elements do not move against each other.
  bool is_still() const noexcept { return same(r) && same(u) && same(w); }

  static bool same(const PreciseVector (&v)[2]) noexcept {
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k) same &= v[0][k].high == v[1][k].high && v[0][k].low == v[1][k].low;
    return same;
  }
  static PreciseVector exact(const std::array<Vec3, 4>& x, const Difference& d) noexcept {
    const Vec3 &a = x[d.one], &b = x[d.other];
    return {{numbers::two_difference(a.x, b.x), numbers::two_difference(a.y, b.y), numbers::two_difference(a.z, b.z)}};
  }
};

/// A difference at the time t. Its coordinates are off by less than 40 e^2 U, where U is the largest one of both ends
/// and e^2 = 2^-106. They are from + t (to - from). Both ends are exact, with low parts of at most e U. The difference,
/// at most 2 U: low parts 2 ..., 4 ..., in all 6 e^2 U. Its product with t: low parts 4 ..., 6 ...: 10 e^2 U. The sum:
/// low parts 7 ..., 10 ...: 17 e^2 U, in all 33 e^2 U.
inline PreciseVector at(const PreciseVector (&v)[2], double t) noexcept {
  PreciseVector result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = numbers::normalised(v[0][k] + t * (v[1][k] - v[0][k]));
  return result;
}

inline Vector rounded_vector(const PreciseVector& v) noexcept {
  return {{rounded(v[0]), rounded(v[1]), rounded(v[2])}};
}

/// Whether the bounds hold for the step and a separation of this distance.
inline bool of_ordinary_size(const Step& step, double distance) noexcept {
  return step.size >= kLeastSize && step.size <= kGreatestSize && distance >= kLeastFraction * step.size &&
         distance <= kGreatestSize;
}

/// The closest points' parameters that are free: neither, one, or both, or along the border s + q = 1.
enum class Free : std::uint8_t { none, s, q, sum, both };

inline Free free_parameters(Domain domain, const Parameters& p) noexcept {
  if (domain == Domain::point) return Free::none;
  if (domain == Domain::triangle && p.s > 0 && p.q > 0) return p.s + p.q >= 1 ? Free::sum : Free::both;
  const bool s = p.s > 0 && p.s < 1;
  const bool q = domain != Domain::segment && p.q > 0 && p.q < 1;
  return s && q ? Free::both : s ? Free::s : q ? Free::q : Free::none;
}

/// Calls f(i, j) for each bound that holds the parameters of the closest points. Its Lagrange multiplier is
/// n . (i u + j w), with n the direction between the points: where all are positive, n . c grows on all ways from the
/// points into the domain but those along free parameters. At the bound s + q <= 1, n . u and n . w are the same where
/// the other parameter is free.
template <class F>
void for_each_multiplier(Domain domain, Free free, const Parameters& p, const F& f) {
  if (domain == Domain::point || free == Free::both) return;
  if (domain == Domain::triangle) {
    if (free == Free::sum) return f(1, 0);
    if (free == Free::none && p.s == 1) {
      f(1, 0);
      return f(1, -1);
    }
    if (free == Free::none && p.q == 1) {
      f(0, 1);
      return f(-1, 1);
    }
  }
  if (free != Free::s) f(p.s == 1 ? 1 : -1, 0);
  if (free != Free::q && domain != Domain::segment) f(0, p.q == 1 ? 1 : -1);
}

/// Writes the closest points into the answer. Parameters that are not free are exactly 0 or 1.
inline void name_closest(Kind kind, double s, double q, Free free, Answer& answer) noexcept {
  const auto on_edge = [](double x, const std::array<Feature, 3>& features, Feature& feature) -> std::array<double, 3> {
    feature = features[x == 0 ? 0 : x == 1 ? 1 : 2];
    return {1 - x, x, 0};
  };
  answer.weights_a = answer.weights_b = {1, 0, 0};
  switch (kind) {
    case Kind::edge_edge:
      answer.weights_a = on_edge(s, {Feature::a0, Feature::a1, Feature::a}, answer.feature_a);
      answer.weights_b = on_edge(q, {Feature::b0, Feature::b1, Feature::b}, answer.feature_b);
      break;
    case Kind::vertex_face:
      answer.feature_a = Feature::v;
      answer.weights_b = {free == Free::sum ? 0 : (1 - s) - q, s, q};
      answer.feature_b = free == Free::both  ? Feature::f
                         : free == Free::sum ? Feature::f12
                         : free == Free::s   ? Feature::f01
                         : free == Free::q   ? Feature::f20
                         : s == 1            ? Feature::f1
                         : q == 1            ? Feature::f2
                                             : Feature::f0;
      break;
    case Kind::point_edge:
      answer.feature_a = Feature::p;
      answer.weights_b = on_edge(s, {Feature::e0, Feature::e1, Feature::e}, answer.feature_b);
      break;
    case Kind::point_point:
      answer.feature_a = Feature::p;
      answer.feature_b = Feature::q;
      break;
  }
}

}  // namespace touchstone::filters
