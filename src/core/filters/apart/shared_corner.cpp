// SPDX-License-Identifier: MIT
#include "filters/apart/shared_corner.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// The names of both elements' corners.
struct CornerFeatures {
  std::size_t first_count;  ///< corners of the first element
  const Feature* first;
  const Feature* second;
};

CornerFeatures corner_features(Kind kind) noexcept {
  static constexpr Feature a[] = {Feature::a0, Feature::a1};
  static constexpr Feature b[] = {Feature::b0, Feature::b1};
  static constexpr Feature v[] = {Feature::v};
  static constexpr Feature f[] = {Feature::f0, Feature::f1, Feature::f2};
  static constexpr Feature p[] = {Feature::p};
  static constexpr Feature e[] = {Feature::e0, Feature::e1};
  static constexpr Feature q[] = {Feature::q};
  switch (kind) {
    case Kind::edge_edge: return {2, a, b};
    case Kind::vertex_face: return {1, v, f};
    case Kind::point_edge: return {1, p, e};
    case Kind::point_point: break;
  }
  return {1, p, q};
}

}  // namespace

bool touch_in_shared_corner(const Query& query, double t_max, Answer& answer) noexcept {
  const CornerFeatures corners = corner_features(query.kind);
  const std::size_t count = corner_count(query.kind);
  const auto coincide_at_start = [&](std::size_t i, std::size_t j) { return equal(query.start[i], query.start[j]); };
  for (std::size_t i = 0; i < corners.first_count; ++i) {
    for (std::size_t j = corners.first_count; j < count; ++j) {
      if (!coincide_at_start(i, j) || !equal(query.end[i], query.end[j])) continue;
      // A point touches nowhere else. Two edges touch nowhere else if they leave the corner in different directions.
      if (query.kind == Kind::edge_edge && !certainly_not_parallel(query)) return false;
      // Of corners that coincide, the first gives its name. (The corners of an edge differ, since it is not a point.)
      std::size_t named = corners.first_count;
      while (!coincide_at_start(i, named)) ++named;
      answer.contact = true;
      answer.nature = t_max > 0 ? Nature::sustained : Nature::isolated;
      answer.toi = answer.toi_upper = 0;
      answer.feature_a = corners.first[i];
      answer.feature_b = corners.second[named - corners.first_count];
      answer.weights_a = corner_weights(i);
      answer.weights_b = corner_weights(named - corners.first_count);
      return true;
    }
  }
  return false;
}

}  // namespace touchstone::filters
