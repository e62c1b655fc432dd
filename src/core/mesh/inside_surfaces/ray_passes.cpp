// SPDX-License-Identifier: MIT
#include "mesh/inside_surfaces/ray_passes.hpp"

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

}  // namespace

broad_phase::Box Ray::box(double last) const noexcept {
  // Each half is exact, or is wrong by less than half the least double; so the rounded sum is next to the middle.
  const Vec3 middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
  using broad_phase::lowered;
  return {{lowered(middle.x), lowered(middle.y), lowered(middle.z)}, {last, -lowered(-middle.y), -lowered(-middle.z)}};
}

int passes(const Point& start, const Exact& scale, const std::array<Vec3, 3>& triangle) {
  const auto scaled = [&scale](const Vec3& v) { return scale * exact(v); };
  const Point corners[3] = {scaled(triangle[0]), scaled(triangle[1]), scaled(triangle[2])};
  const int side = side_beside(corners[0], corners[1], start);
  if (side == 0 || side != side_beside(corners[1], corners[2], start) ||
      side != side_beside(corners[2], corners[0], start)) {
    return 0;
  }
  const Point normal = geometry::cross(corners[1] - corners[0], corners[2] - corners[0]);
  return numbers::sign_of(geometry::dot(normal, start - corners[0])) == -side ? side : 0;  // 0: it is behind the start
}

int passes(const Ray& ray, const std::array<Vec3, 3>& triangle) {
  return passes(exact(ray.a) + exact(ray.b), Exact(2), triangle);  // in twice its size, where the middle is a sum
}

}  // namespace touchstone::mesh
