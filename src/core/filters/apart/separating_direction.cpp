// SPDX-License-Identifier: MIT
#include "filters/apart/separating_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/step_frame.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::filters {
namespace {

// Let D and M be the largest absolute coordinates of the direction and of the computed differences. A projection is a
// sum of 3 products d_k (x_k - o_k). Each product passes through one difference, one product and at most two additions.
// So the error is at most 3 ((1 + e)^4 - 1) D M (1 + e) = 12 e D M to first order. The rest of the constant covers
// second-order terms, the rounding of the bound, and underflow (3 * 2^-1075, below e D M / 2 when D M >= 2^-1000).
// Overflow needs no guard: gap_along looks for projections that are infinite or NaN, and no gap exceeds an infinite
// bound.
constexpr double kProjectionBound = 13 * kUnit;

// The norm of a direction, its product with the distance, the sum with the gap's error, and this product itself: at
// most 2.5 e from the square, 1 e from the root, and 3 e more, or 2 e in place of 3.5 e for the sum of absolute values.
// So 8 e cover all of it. A product that underflows is off by less than the least normal number. Squares from
// kLeastSquare up have no underflow that counts.
constexpr double kDirectionFactor = 1 + 8 * kUnit;
constexpr double kLeastNormal = std::numeric_limits<double>::min();
constexpr double kLeastSquare = 0x1p-900;

double largest_of(const Vector& v) noexcept { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); }

Vector relative(const Vec3& x, const Vec3& origin) noexcept {
  return {{x.x - origin.x, x.y - origin.y, x.z - origin.z}};
}

}  // namespace

RelativeCorners relative_corners(const Query& query) noexcept {
  RelativeCorners corners;
  corners.count = corner_count(query.kind);
  corners.first_count = geometry::corners_of_first(query.kind);
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

namespace {

/// gap_along for elements of so many corners.
template <std::size_t FirstCount, std::size_t Count>
Gap gap_of(const RelativeCorners& corners, const Vector& direction) noexcept {
  const double bound = projection_bound(corners, direction);
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  // The plane may move with the elements. A projection is linear in time. So the difference of two corners' projections
  // is never less than the smaller of its two values at the ends of the step.
  double above = inf;  // how far the second element is above the first, at the end of the step where that is least
  double below = inf;
  for (const auto* at : {&corners.start, &corners.end}) {
    double least[2] = {inf, inf};
    double greatest[2] = {-inf, -inf};
    for (std::size_t i = 0; i < Count; ++i) {
      const std::size_t element = i < FirstCount ? 0 : 1;
      const double projection = geometry::dot(direction, (*at)[i]);
      // A NaN comes from a direction that is not finite. std::min would drop it.
      if (!(std::fabs(projection) < inf)) return {nan, nan};
      least[element] = std::min(least[element], projection);
      greatest[element] = std::max(greatest[element], projection);
    }
    above = std::min(above, least[1] - greatest[0]);
    below = std::min(below, least[0] - greatest[1]);
  }
  // Each of the two projections is off by at most `bound`. A third `bound` covers the rounding of their difference: e
  // times a value of at most 6 D M (1 + 4 e).
  return {std::max(above, below), 3 * bound};
}

}  // namespace

Gap gap_along(const RelativeCorners& corners, const Vector& direction) noexcept {
  if (corners.count == 4) {
    return corners.first_count == 2 ? gap_of<2, 4>(corners, direction) : gap_of<1, 4>(corners, direction);
  }
  return corners.count == 3 ? gap_of<1, 3>(corners, direction) : gap_of<1, 2>(corners, direction);
}

bool separates(const RelativeCorners& corners, const Vector& direction) noexcept {
  const Gap gap = gap_along(corners, direction);
  return gap.value > gap.error;
}

bool separates_by(const RelativeCorners& corners, const Vector& direction, const Separation& separation) noexcept {
  // |n . x| <= |n| |x| with the Euclidean norms, and with the sum of n's absolute coordinates and the largest of x's.
  double norm;
  if (separation.metric == Metric::euclidean) {
    const double square = geometry::dot(direction, direction);
    if (!(square >= kLeastSquare)) return false;
    norm = std::sqrt(square);
  } else {
    norm = std::fabs(direction[0]) + std::fabs(direction[1]) + std::fabs(direction[2]);
  }
  const Gap gap = gap_along(corners, direction);
  const double least = (gap.error + separation.distance * norm) * kDirectionFactor + kLeastNormal;
  return gap.value > least;
}

bool separated(const Query& query) noexcept {
  const RelativeCorners corners = relative_corners(query);
  const Vector direction = between_closest_points(corners, query.kind);
  const bool touch_at_mid_step = direction[0] == 0 && direction[1] == 0 && direction[2] == 0;
  return !touch_at_mid_step && separates(corners, direction);
}

}  // namespace touchstone::filters
