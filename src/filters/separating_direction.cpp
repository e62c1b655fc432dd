// SPDX-License-Identifier: MIT
#include "filters/separating_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/coplanarity_form.hpp"

namespace touchstone::filters {
namespace {

// A projection is a sum of 3 products d_k (x_k - o_k): each passes through one difference, one product and at most two
// additions, so its error is at most 3 ((1 + e)^4 - 1) D M (1 + e) = 12 e D M to first order, with D and M the largest
// absolute coordinates of the direction and of the computed differences. The rest of the constant covers second-order
// terms, the rounding of the bound and underflow (3 * 2^-1075, below e D M / 2 when D M >= 2^-1000). Overflow needs no
// guard: a projection that is infinite or NaN is seen as such, and an infinite bound is never exceeded.
constexpr double kProjectionBound = 13 * kUnit;

double largest_of(const Vector& v) noexcept { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); }

std::size_t corners_of_first(Kind kind) noexcept { return kind == Kind::edge_edge ? 2 : 1; }

Vector relative(const Vec3& x, const Vec3& origin) noexcept {
  return {{x.x - origin.x, x.y - origin.y, x.z - origin.z}};
}

}  // namespace

RelativeCorners relative_corners(const Query& query) noexcept {
  RelativeCorners corners;
  corners.count = corner_count(query.kind);
  corners.first_count = corners_of_first(query.kind);
  corners.largest = 0;
  const Vec3& origin = query.start[0];
  for (std::size_t i = 0; i < corners.count; ++i) {
    corners.start[i] = relative(query.start[i], origin);
    corners.end[i] = relative(query.end[i], origin);
    corners.largest = std::max({corners.largest, largest_of(corners.start[i]), largest_of(corners.end[i])});
  }
  return corners;
}

double projection_bound(const RelativeCorners& corners, const Vector& direction) noexcept {
  const double product = largest_of(direction) * corners.largest;
  if (!(product >= kLeastProduct)) return std::numeric_limits<double>::quiet_NaN();
  return kProjectionBound * product;
}

Gap gap_along(const RelativeCorners& corners, const Vector& direction) noexcept {
  const double bound = projection_bound(corners, direction);
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  // The plane may move with the elements: a projection is linear in time, so that of a corner of one element exceeds that
  // of a corner of the other by at least the lesser of what it does at both ends of the step.
  double above = inf;  // how far the second element is above the first, at the end where that is least
  double below = inf;
  for (const auto* at : {&corners.start, &corners.end}) {
    double least[2] = {inf, inf};
    double greatest[2] = {-inf, -inf};
    for (std::size_t i = 0; i < corners.count; ++i) {
      const std::size_t element = i < corners.first_count ? 0 : 1;
      const double place = geometry::dot(direction, (*at)[i]);
      // A NaN (of a direction that is not finite) must not drop out of a minimum unseen.
      if (!(std::fabs(place) < inf)) return {nan, nan};
      least[element] = std::min(least[element], place);
      greatest[element] = std::max(greatest[element], place);
    }
    above = std::min(above, least[1] - greatest[0]);
    below = std::min(below, least[0] - greatest[1]);
  }
  // Either projection is off by at most `bound`. A third one covers the rounding of their difference: e times a value
  // of at most 6 D M (1 + 4 e).
  return {std::max(above, below), 3 * bound};
}

bool separates(const RelativeCorners& corners, const Vector& direction) noexcept {
  const Gap gap = gap_along(corners, direction);
  return gap.value > gap.error;
}

bool boxes_disjoint(const Query& query) noexcept {
  const std::size_t count = corner_count(query.kind);
  const std::size_t first_count = corners_of_first(query.kind);
  const auto disjoint_along = [&](double Vec3::*axis) {
    double low[2], high[2];
    for (std::size_t element = 0; element < 2; ++element) {
      const std::size_t begin = element == 0 ? 0 : first_count;
      const std::size_t end = element == 0 ? first_count : count;
      low[element] = std::min(query.start[begin].*axis, query.end[begin].*axis);
      high[element] = std::max(query.start[begin].*axis, query.end[begin].*axis);
      for (std::size_t i = begin + 1; i < end; ++i) {
        low[element] = std::min({low[element], query.start[i].*axis, query.end[i].*axis});
        high[element] = std::max({high[element], query.start[i].*axis, query.end[i].*axis});
      }
    }
    return high[0] < low[1] || high[1] < low[0];
  };
  return disjoint_along(&Vec3::x) || disjoint_along(&Vec3::y) || disjoint_along(&Vec3::z);
}

}  // namespace touchstone::filters
