// SPDX-License-Identifier: MIT
#include "fuzz/margin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

#include "filters/apart/same_side.hpp"
#include "filters/apart/separating_direction.hpp"
#include "filters/curved/curved_paths.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::fuzz {
namespace {

using filters::Vector;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// value / bound; +infinity when that has no meaning.
double quotient(double value, double bound) noexcept {
  const double q = value / bound;
  return std::isnan(q) || bound <= 0 ? kInfinity : q;
}

double least(std::initializer_list<double> quotients) noexcept {
  return std::min(quotients, [](double a, double b) { return std::fabs(a) < std::fabs(b); });
}

Vector between(const Vector& a, const Vector& b, double t) noexcept {
  return {{(1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1], (1 - t) * a[2] + t * b[2]}};
}

/// V at t from its coefficients b0, 3 b1, 3 b2, b3.
double value(const std::array<double, 4>& c, double t) noexcept {
  const double s = 1 - t;
  return ((c[0] * s + c[1] * t) * s + c[2] * t * t) * s + c[3] * t * t * t;
}

/// The time between 0 and 1 at which V changes sign, when its signs at both ends differ; by bisection.
double sign_change(const std::array<double, 4>& c) noexcept {
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    ((value(c, middle) > 0) == (c[0] > 0) ? low : high) = middle;
  }
  return low;
}

/// The weights of the touching point at the root over their rounding errors, about 2^-49 of the terms' size.
double side_margin(const Query& query, const filters::StepFrame<double>& f, double t) noexcept {
  constexpr double kRounding = 0x1p-49;
  const geometry::Frame<Vector> at = {between(f.start.u, f.end.u, t), between(f.start.w, f.end.w, t),
                                      between(f.start.r, f.end.r, t)};
  const Vector n = geometry::normal(at);
  std::size_t k = std::fabs(n[0]) > std::fabs(n[1]) ? 0 : 1;
  if (std::fabs(n[2]) > std::fabs(n[k])) k = 2;
  const double first = geometry::first_numerator(at, k) / n[k];
  const double second = geometry::second_numerator(query.kind, at, k) / n[k];
  const double third = query.kind == Kind::edge_edge ? 1 - first : 1 - first - second;
  const double margin = least({quotient(first, kRounding), quotient(second, kRounding), quotient(third, kRounding)});
  return query.kind == Kind::edge_edge ? least({margin, quotient(1 - second, kRounding)}) : margin;
}

double cubic_margin(const Query& query) noexcept {
  const filters::StepFrame<double> frame = filters::frame_of(query);
  const auto c = filters::coplanarity_coefficients(frame);
  const auto bounds = filters::coplanarity_bounds(frame);
  const double margin = !bounds.valid ? kInfinity
                                      : least({quotient(c[0], bounds.ends), quotient(c[1], bounds.middle),
                                               quotient(c[2], bounds.middle), quotient(c[3], bounds.ends)});
  const bool crosses = (c[0] > 0) != (c[3] > 0);
  return crosses ? least({margin, side_margin(query, frame, sign_change(c))}) : margin;
}

double direction_margin(const Query& query) noexcept {
  const auto corners = filters::relative_corners(query);
  const filters::Gap gap = filters::gap_along(corners, filters::between_closest_points(corners, query.kind));
  return quotient(gap.value, gap.error);
}

// With a separation. Below, e = 2^-53, and 8 e is the rounding that the filters allow for d |n|.

constexpr double kNormRounding = 8 * filters::kUnit;

double norm_of(const Vector& v, Metric metric) noexcept {
  return metric == Metric::euclidean ? std::sqrt(geometry::dot(v, v))
                                     : std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]);
}

/// V's coefficients against d max |n|, as in filters::certain_clearance.
double clearance_margin(const Query& query, const Separation& separation) noexcept {
  const filters::StepFrame<double> f = filters::frame_of(query);
  const auto bounds = filters::coplanarity_bounds(f);
  if (!bounds.valid) return kInfinity;
  const auto n = filters::normal_coefficients(f);
  const auto c = filters::coplanarity_coefficients(f, n);
  const double norm =
      separation.metric == Metric::euclidean ? filters::greatest_norm<true>(n) : filters::greatest_norm<false>(n);
  const double kept = separation.distance * norm;
  const double uw = filters::largest(f.start.u, f.end.u) * filters::largest(f.start.w, f.end.w);
  const double rounding = separation.distance * filters::kNormBound * uw + kNormRounding * kept;
  const auto margin = [&](double value, double factor, double bound) {
    return quotient(std::copysign(std::fabs(value) - factor * kept, value), bound + factor * rounding);
  };
  return least({margin(c[0], 1, bounds.ends), margin(c[1], 3, bounds.middle), margin(c[2], 3, bounds.middle),
                margin(c[3], 1, bounds.ends)});
}

/// The gap along the direction between the closest points at mid-step, less the distance: over the rounding, and in the
/// unit of length.
struct GapBeyond {
  double margin;
  double length;
};
GapBeyond gap_beyond(const Query& query, const Separation& separation) noexcept {
  const auto corners = filters::relative_corners(query);
  const Vector direction = filters::between_closest_points(corners, query.kind);
  const filters::Gap gap = filters::gap_along(corners, direction);
  const double norm = norm_of(direction, separation.metric);
  const double kept = separation.distance * norm;
  return {quotient(gap.value - kept, gap.error + kNormRounding * kept), gap.value / norm - separation.distance};
}

/// The query at rest at one time.
Query at_rest(const Query& query, double t) noexcept {
  Query rest = query;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const auto position = [t](double a, double b) { return (1 - t) * a + t * b; };
    const Vec3 &a = query.start[i], &b = query.end[i];
    rest.start[i] = rest.end[i] = {position(a.x, b.x), position(a.y, b.y), position(a.z, b.z)};
  }
  return rest;
}

/// At the step's start alone, at its end, and at a time of least distance, where elements that graze are.
double instants_margin(const Query& query, const Separation& separation) noexcept {
  const GapBeyond start = gap_beyond(at_rest(query, 0), separation), end = gap_beyond(at_rest(query, 1), separation);
  const double margin = least({start.margin, end.margin});
  // The time of the least distance, by ternary search: right where the distance has one minimum, else a guess.
  double low = 0, high = 1;
  for (int i = 0; i < 30; ++i) {
    const double third = (high - low) / 3;
    const double a = gap_beyond(at_rest(query, low + third), separation).length;
    const double b = gap_beyond(at_rest(query, high - third), separation).length;
    (a < b ? high : low) = a < b ? high - third : low + third;
  }
  return least({margin, gap_beyond(at_rest(query, low), separation).margin});
}

double separation_margin(const Query& query, const Separation& separation) noexcept {
  const double margin = least({gap_beyond(query, separation).margin, instants_margin(query, separation)});
  return filters::has_cubic(query.kind) ? least({margin, clearance_margin(query, separation)}) : margin;
}

}  // namespace

double filter_margin(const Query& query, const Separation& separation) noexcept {
  if (separation.distance > 0) return separation_margin(query, separation);
  const double margin = direction_margin(query);
  return filters::has_cubic(query.kind) ? least({margin, cubic_margin(query)}) : margin;
}

double filter_margin(const CurvedQuery& query, const Separation& separation) noexcept {
  const filters::CurvedPaths paths = filters::curved_paths(query);
  if (!paths.known) return kInfinity;
  const std::size_t first_of_b = geometry::corners_of_first(query.kind);
  std::array<Vector, 2> middle{};
  std::array<double, 2> count{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const std::size_t element = i < first_of_b ? 0 : 1;
    for (std::size_t k = 0; k < paths.corners[i].count; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) middle[element][axis] += paths.corners[i].points[k][axis];
      ++count[element];
    }
  }
  Vector between;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    between[axis] = middle[1][axis] / count[1] - middle[0][axis] / count[0];
  }
  double margin = -kInfinity;  // of the direction that separates most
  for (const Vector& direction : {Vector{{1, 0, 0}}, Vector{{0, 1, 0}}, Vector{{0, 0, 1}}, Vector{{-1, 0, 0}},
                                  Vector{{0, -1, 0}}, Vector{{0, 0, -1}}, between}) {
    double most = -kInfinity, least = kInfinity;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (std::size_t k = 0; k < paths.corners[i].count; ++k) {
        const double along = geometry::dot(direction, paths.corners[i].points[k]);
        if (i < first_of_b) most = std::max(most, along);
        if (i >= first_of_b) least = std::min(least, along);
      }
    }
    const double largest = std::max({std::fabs(direction[0]), std::fabs(direction[1]), std::fabs(direction[2])});
    const double kept = separation.distance > 0 ? separation.distance * norm_of(direction, separation.metric) : 0;
    const double m = quotient(least - most - kept, 8 * largest * paths.error + kNormRounding * kept);
    if (m > margin && m < kInfinity) margin = m;
  }
  return std::isfinite(margin) ? margin : kInfinity;
}

}  // namespace touchstone::fuzz
