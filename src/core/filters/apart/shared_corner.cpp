// SPDX-License-Identifier: MIT
#include "filters/apart/shared_corner.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/kind_traits.hpp"
#include "geometry/vector.hpp"

namespace touchstone::filters {
namespace {

using Vector = geometry::Vector<double>;

bool equal(const Vec3& a, const Vec3& b) noexcept { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Whether two edges are certainly not parallel (nor points) at t = 0.
///
/// Let U and W be the largest absolute coordinates of their directions. A component of the cross product has 2
/// monomials that pass through 2 differences, a product and a subtraction each: 8 e U W, e = 2^-53. The rest of the
/// constant covers second-order terms and, for U W >= 2^-1000, underflow. Overflow is no error: products are at most
/// U W, so where one overflows U W is infinite and no component exceeds it, and an infinite difference of finite
/// numbers is not zero.
bool certainly_not_parallel(const Query& q) noexcept {
  constexpr double kBound = 9 * 0x1p-53;
  const auto direction = [&](std::size_t from, std::size_t to) {
    const Vec3& a = q.start[from];
    const Vec3& b = q.start[to];
    return Vector{{b.x - a.x, b.y - a.y, b.z - a.z}};
  };
  const auto largest = [](const Vector& v) { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); };
  const Vector u = direction(0, 1);
  const Vector w = direction(2, 3);
  const double uw = largest(u) * largest(w);
  return uw >= 0x1p-1000 && largest(geometry::cross(u, w)) > kBound * uw;
}

constexpr std::array<double, 3> corner_weights(std::size_t i) noexcept {
  return {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
}

}  // namespace

bool touch_in_shared_corner(const Query& query, double t_max, Answer& answer) noexcept {
  const std::size_t first_count = geometry::corners_of_first(query.kind), count = corner_count(query.kind);
  const auto coincide_at_start = [&](std::size_t i, std::size_t j) { return equal(query.start[i], query.start[j]); };
  for (std::size_t i = 0; i < first_count; ++i) {
    for (std::size_t j = first_count; j < count; ++j) {
      if (!coincide_at_start(i, j) || !equal(query.end[i], query.end[j])) continue;
      // A point touches nowhere else. Two edges touch nowhere else if they leave the corner in different directions.
      if (query.kind == Kind::edge_edge && !certainly_not_parallel(query)) return false;
      // Of corners that coincide, the first gives its name. (The corners of an edge differ, since it is not a point.)
      std::size_t named = first_count;
      while (!coincide_at_start(i, named)) ++named;
      answer.contact = true;
      answer.nature = t_max > 0 ? Nature::sustained : Nature::isolated;
      answer.toi = answer.toi_upper = 0;
      const auto& [first, second] = geometry::traits_of(query.kind);
      answer.feature_a = first.corner(i);
      answer.feature_b = second.corner(named - first_count);
      answer.weights_a = corner_weights(i);
      answer.weights_b = corner_weights(named - first_count);
      return true;
    }
  }
  return false;
}

}  // namespace touchstone::filters
