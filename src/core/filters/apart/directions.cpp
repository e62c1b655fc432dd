// Directions that are likely to separate. Nothing here needs to be right: a bad direction only fails to separate.
// Closest points after Ericson, Real-Time Collision Detection (2005), 5.1.5 and 5.1.9.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "filters/apart/separating_direction.hpp"

namespace touchstone::filters {
namespace {

using geometry::dot;

Vector middle(const RelativeCorners& corners, std::size_t i) noexcept {
  const Vector& a = corners.start[i];
  const Vector& b = corners.end[i];
  return {{0.5 * a[0] + 0.5 * b[0], 0.5 * a[1] + 0.5 * b[1], 0.5 * a[2] + 0.5 * b[2]}};
}

Vector along(const Vector& p, const Vector& d, double s) noexcept {
  return {{p[0] + s * d[0], p[1] + s * d[1], p[2] + s * d[2]}};
}

double unit_clamp(double s) noexcept { return std::min(std::max(s, 0.0), 1.0); }

Vector closest_on_segment(const Vector& p, const Vector& x, const Vector& y) noexcept {
  const Vector d = y - x;
  const double length2 = dot(d, d);
  return along(x, d, length2 > 0 ? unit_clamp(dot(p - x, d) / length2) : 0.0);
}

Vector between_segments(const Vector& p1, const Vector& q1, const Vector& p2, const Vector& q2) noexcept {
  const Vector d1 = q1 - p1;
  const Vector d2 = q2 - p2;
  const Vector r = p1 - p2;
  const double a = dot(d1, d1);
  const double e = dot(d2, d2);
  const double f = dot(d2, r);
  const double c = dot(d1, r);
  const double b = dot(d1, d2);
  const double denominator = a * e - b * b;
  double s = denominator > 0 ? unit_clamp((b * f - c * e) / denominator) : 0.0;
  double t = e > 0 ? (b * s + f) / e : 0.0;
  if (t < 0) {
    t = 0;
    s = a > 0 ? unit_clamp(-c / a) : 0.0;
  } else if (t > 1) {
    t = 1;
    s = a > 0 ? unit_clamp((b - c) / a) : 0.0;
  }
  return along(p2, d2, t) - along(p1, d1, s);
}

Vector between_point_and_triangle(const Vector& p, const Vector& a, const Vector& b, const Vector& c) noexcept {
  const Vector ab = b - a;
  const Vector ac = c - a;
  const Vector ap = p - a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a - p;
  const Vector bp = p - b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b - p;
  const Vector cp = p - c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c - p;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return closest_on_segment(p, a, b) - p;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return closest_on_segment(p, a, c) - p;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return closest_on_segment(p, b, c) - p;
  return geometry::cross(ab, ac);
}

}  // namespace

Vector between_closest_points(const RelativeCorners& corners, Kind kind) noexcept {
  const Vector x0 = middle(corners, 0);
  const Vector x1 = middle(corners, 1);
  switch (kind) {
    case Kind::edge_edge: return between_segments(x0, x1, middle(corners, 2), middle(corners, 3));
    case Kind::vertex_face: return between_point_and_triangle(x0, x1, middle(corners, 2), middle(corners, 3));
    case Kind::point_edge: return closest_on_segment(x0, x1, middle(corners, 2)) - x0;
    case Kind::point_point: break;
  }
  return x1 - x0;
}

Vector normal_at_mid_step(const RelativeCorners& corners, Kind kind) noexcept {
  const Vector x1 = middle(corners, 1);
  const Vector x2 = middle(corners, 2);
  const Vector x3 = middle(corners, 3);
  if (kind == Kind::edge_edge) return geometry::cross(x1 - middle(corners, 0), x3 - x2);
  return geometry::cross(x2 - x1, x3 - x1);
}

Vector between_centres(const RelativeCorners& corners) noexcept {
  Vector sum[2] = {};
  for (std::size_t i = 0; i < corners.count; ++i) {
    const std::size_t element = i < corners.first_count ? 0 : 1;
    const std::size_t size = element == 0 ? corners.first_count : corners.count - corners.first_count;
    sum[element] = along(sum[element], middle(corners, i), 1.0 / static_cast<double>(size));
  }
  return sum[1] - sum[0];
}

}  // namespace touchstone::filters
