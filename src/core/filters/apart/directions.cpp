// Directions that are likely to separate. Nothing here needs to be right: a bad direction only fails to separate.
// SPDX-License-Identifier: MIT
#include "filters/apart/separating_direction.hpp"
#include "filters/separation/entry_step.hpp"

namespace touchstone::filters {
namespace {

Vector middle(const RelativeCorners& corners, std::size_t i) noexcept {
  const Vector& a = corners.start[i];
  const Vector& b = corners.end[i];
  return {{0.5 * a[0] + 0.5 * b[0], 0.5 * a[1] + 0.5 * b[1], 0.5 * a[2] + 0.5 * b[2]}};
}

Vector along(const Vector& p, const Vector& d, double s) noexcept {
  return {{p[0] + s * d[0], p[1] + s * d[1], p[2] + s * d[2]}};
}

}  // namespace

Vector between_closest_points(const RelativeCorners& corners, Kind kind) noexcept {
  const Differences d = differences_of(kind);
  const auto difference = [&](const Difference& of) { return middle(corners, of.one) - middle(corners, of.other); };
  const Vector r = difference(d.r), u = difference(d.u), w = difference(d.w);
  const auto [s, q] = closest(domain_of(kind), r, u, w);
  // Within a face the two points are so near each other that their difference may have no good digit.
  if (kind == Kind::vertex_face && s > 0 && q > 0 && s + q < 1) return geometry::cross(u, w);
  return combined(r, u, w, s, q);
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
