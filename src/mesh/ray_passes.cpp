// SPDX-License-Identifier: MIT
#include "mesh/ray_passes.hpp"

#include <algorithm>

namespace touchstone::mesh {
namespace {

using numbers::Exact;
using Point = ExactPoint;

/// On which side of the line from a to b a place beside p is, in the projection along x: the sign of the cross product
/// of b - a and (p_y + eps - a_y, p_z + eps^2 - a_z). 0 if a and b are one point there.
int side_beside(const Point& a, const Point& b, const Point& p) {
  const Exact y = b[1] - a[1], z = b[2] - a[2];
  if (const int sign = numbers::sign_of(y * (p[2] - a[2]) - z * (p[1] - a[1])); sign != 0) return sign;
  if (const int sign = numbers::sign_of(z); sign != 0) return -sign;
  return numbers::sign_of(y);
}

bool is_between(double x, double a, double b, double c) noexcept {
  return std::min({a, b, c}) <= x && x <= std::max({a, b, c});
}

}  // namespace

void RayPasses::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (std::max({a.x, b.x, c.x}) < from_.x) return;
  if (!is_between(from_.y, a.y, b.y, c.y) || !is_between(from_.z, a.z, b.z, c.z)) return;
  const Point p = exact(from_), corners[3] = {exact(a), exact(b), exact(c)};
  const int side = side_beside(corners[0], corners[1], p);
  if (side == 0 || side != side_beside(corners[1], corners[2], p) || side != side_beside(corners[2], corners[0], p)) {
    return;
  }
  const Point normal = geometry::cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (numbers::sign_of(geometry::dot(normal, p - corners[0])) != -side) return;  // the triangle is behind the point
  sum_ += side;
  ++passes_;
}

}  // namespace touchstone::mesh
