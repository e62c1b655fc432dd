// SPDX-License-Identifier: MIT
#include "contact/closest_points.hpp"

#include <algorithm>

namespace touchstone::sim {
namespace {

// The squared sine of the angle between two edges, a fraction of |u|^2 |w|^2. Below it, rounding decides where the
// lines are nearest, and any point is as good.
constexpr double kParallelSquare = 1e-14;

}  // namespace

std::array<double, 2> closest_on_segments(const Vector3& p0, const Vector3& p1, const Vector3& q0, const Vector3& q1) {
  const Vector3 u = p1 - p0, w = q1 - q0, r = p0 - q0;
  const double a = u.squaredNorm(), e = w.squaredNorm(), b = u.dot(w), c = u.dot(r), f = w.dot(r);
  const double denominator = a * e - b * b;
  double s = denominator > kParallelSquare * a * e ? clamped((b * f - c * e) / denominator) : 0.5;
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0) {
    t = 0;
    s = a > 0 ? clamped(-c / a) : 0;
  } else if (t > 1) {
    t = 1;
    s = a > 0 ? clamped((b - c) / a) : 0;
  }
  return {s, t};
}

std::array<double, 3> closest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - t, t};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

Weights closest_weights(Kind kind, const std::array<Vector3, 4>& x) {
  switch (kind) {
    case Kind::edge_edge: {
      const auto [s, t] = closest_on_segments(x[0], x[1], x[2], x[3]);
      return {{1 - s, s, 0}, {1 - t, t, 0}};
    }
    case Kind::vertex_face: return {{1, 0, 0}, closest_on_triangle(x[0], x[1], x[2], x[3])};
    case Kind::point_edge: {
      const Vector3 along = x[2] - x[1];
      const double t = clamped(along.dot(x[0] - x[1]) / along.squaredNorm());
      return {{1, 0, 0}, {1 - t, t, 0}};
    }
    case Kind::point_point: break;
  }
  return {{1, 0, 0}, {1, 0, 0}};
}

}  // namespace touchstone::sim
