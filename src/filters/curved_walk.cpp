// SPDX-License-Identifier: MIT
#include "filters/curved_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "filters/separating_direction.hpp"

namespace touchstone::filters {
namespace {

using numbers::kBoundSlack;
using numbers::kRounding;
using Index = std::size_t;

// Bounds, with e = 2^-53, for a direction whose largest coordinate is 1 and for points up to a size and off by x: a
// projection sums 3 products, with at most 3 roundings each. It is off by 3 x + 9 e size and second-order terms.
constexpr double kProjectionErrors = 3;
constexpr double kProjectionRoundings = 10;
// Points within a distance d of each other differ by at most |n| d along n, and in the metric max by at most (|n_x| +
// |n_y| + |n_z|) d: 5 roundings of the length, and one each of its products with d and with the scale.
constexpr double kReach = 1 + 8 * kRounding;

constexpr int kMostDegree = 6;
constexpr Index kSize = kMostDegree + 1;

/// The corners of the second element minus those of the first, and the scale that they are multiplied by, over a part
/// of the step, in the Bernstein basis.
struct Part {
  double low, high;
  std::array<std::array<std::array<double, kSize>, 3>, 4> pairs;  // B - A first
  std::array<double, kSize> scale;
  double error;  // of the pairs
  double scale_error;
};

struct Walk {
  Kind kind;
  int degree = 0;
  Index pairs = 0;
  double size = 0;        // of the pairs' coefficients
  double scale_size = 0;  // of the scale's
  double distance = 0;    // times the frame's factor
  Metric metric;
};

/// Bernstein coefficients over [0, 1]: a quotient's rounding each.
template <Index Dim>
double copy(const CurvedForm<Dim>& form, std::array<std::array<double, kSize>, Dim>& to) noexcept {
  const auto& b = kBinomial[static_cast<Index>(form.degree)];
  for (Index axis = 0; axis < Dim; ++axis) {
    for (Index k = 0; k <= static_cast<Index>(form.degree); ++k) to[axis][k] = form.c[axis][k] / b[k];
  }
  return form.error + kRounding * form.size;
}

/// False for a degree that there is no room for.
bool start(const CurvedQuery& query, const CurvedFrame& frame, Walk& walk, Part& part) noexcept {
  std::array<VectorForm, 4> forms;
  forms[0] = frame.between;
  walk.pairs = 1;
  if (query.kind != Kind::point_point) {
    const VectorForm w = frame.second_multiplier * frame.w;
    forms[walk.pairs++] = sum(frame.between, w, 1);
    if (query.kind == Kind::vertex_face) {
      forms[walk.pairs++] = sum(frame.between, frame.second_multiplier * frame.u, 1);
    } else if (query.kind == Kind::edge_edge) {
      const VectorForm u = frame.first_multiplier * frame.u;
      forms[walk.pairs++] = sum(frame.between, u, -1);
      forms[walk.pairs++] = sum(forms[1], u, -1);
    }
  }
  ScalarForm scale = frame.first_multiplier * frame.second_multiplier;
  walk.degree = scale.degree;
  for (Index i = 0; i < walk.pairs; ++i) walk.degree = std::max(walk.degree, forms[i].degree);
  if (walk.degree > kMostDegree) return false;
  scale = elevated(scale, walk.degree);
  std::array<std::array<double, kSize>, 1> scale_part;
  part.low = 0;
  part.high = 1;
  part.scale_error = copy(scale, scale_part);
  part.scale = scale_part[0];
  part.error = 0;
  walk.scale_size = scale.size;
  for (Index i = 0; i < walk.pairs; ++i) {
    const VectorForm form = elevated(forms[i], walk.degree);
    part.error = std::max(part.error, copy(form, part.pairs[i]));
    walk.size = std::max(walk.size, form.size);
  }
  return true;
}

/// The coefficients over both sides of a place in (0, 1). In each of n rounds, a coefficient has at most 3 roundings of
/// products and sums, 1 - place counted: 3 e times the size. The errors before are averaged.
void cut(std::array<double, kSize>& left, std::array<double, kSize>& right, int degree, double place) noexcept {
  const Index size = static_cast<Index>(degree) + 1;
  for (Index round = 0; round < size; ++round) {
    left[round] = right[0];
    for (Index i = 0; i + round + 1 < size; ++i) right[i] = (1 - place) * right[i] + place * right[i + 1];
  }
}
constexpr double kCutRoundings = 3;

/// `right` is all of a part at first.
void cut(const Walk& walk, Part& left, Part& right, double place) noexcept {
  for (Index i = 0; i < walk.pairs; ++i) {
    for (Index axis = 0; axis < 3; ++axis) cut(left.pairs[i][axis], right.pairs[i][axis], walk.degree, place);
  }
  cut(left.scale, right.scale, walk.degree, place);
  left.error = right.error = right.error + walk.size * (kCutRoundings * walk.degree * kRounding) + numbers::kUnderflow;
  left.scale_error = right.scale_error =
      right.scale_error + walk.scale_size * (kCutRoundings * walk.degree * kRounding) + numbers::kUnderflow;
  left.low = right.low;
  left.high = right.low = right.low + place * (right.high - right.low);
}

/// A vector between about the closest points where the pairs are `pairs[i]`, from the first element to the second.
Vector between_elements(const Walk& walk, const std::array<Vector, 4>& pairs) noexcept {
  RelativeCorners corners;
  corners.count = corner_count(walk.kind);
  corners.first_count = walk.kind == Kind::edge_edge ? 2 : 1;
  std::array<Vector, 4> at = {};  // A is the origin
  switch (walk.kind) {
    case Kind::edge_edge: at = {Vector{}, pairs[0] - pairs[2], pairs[0], pairs[1]}; break;
    case Kind::vertex_face: at = {Vector{}, pairs[0], pairs[2], pairs[1]}; break;
    case Kind::point_edge: at = {Vector{}, pairs[0], pairs[1], Vector{}}; break;
    case Kind::point_point: at = {Vector{}, pairs[0], Vector{}, Vector{}}; break;
  }
  corners.start = corners.end = at;
  Vector n = between_closest_points(corners, walk.kind);
  if (geometry::dot(n, pairs[0]) < 0) n = {{-n[0], -n[1], -n[2]}};
  return n;
}

/// Whether the direction shows that the elements are farther apart over the part.
bool separates(const Walk& walk, const Part& part, const Vector& direction) noexcept {
  const double largest = std::max({std::fabs(direction[0]), std::fabs(direction[1]), std::fabs(direction[2])});
  if (!(largest > 0)) return false;
  const Vector n = {{direction[0] / largest, direction[1] / largest, direction[2] / largest}};
  const double length =
      walk.metric == Metric::max ? std::fabs(n[0]) + std::fabs(n[1]) + std::fabs(n[2]) : std::sqrt(geometry::dot(n, n));
  const double reach = kReach * (length * walk.distance);
  const double error =
      kProjectionErrors * part.error + kProjectionRoundings * kRounding * walk.size + numbers::kUnderflow;
  for (Index k = 0; k <= static_cast<Index>(walk.degree); ++k) {
    const double kept = kBoundSlack * (error + kReach * (reach * (std::max(part.scale[k], 0.0) + part.scale_error)));
    for (Index i = 0; i < walk.pairs; ++i) {
      const auto& x = part.pairs[i];
      if (!(n[0] * x[0][k] + n[1] * x[1][k] + n[2] * x[2][k] > kept)) return false;
    }
  }
  return true;
}

/// About the part's middle.
std::array<Vector, 4> mean(const Walk& walk, const Part& part) noexcept {
  std::array<Vector, 4> result = {};
  const double share = 1 / (walk.degree + 1.0);
  for (Index i = 0; i < walk.pairs; ++i) {
    for (Index axis = 0; axis < 3; ++axis) {
      for (Index k = 0; k <= static_cast<Index>(walk.degree); ++k) result[i][axis] += share * part.pairs[i][axis][k];
    }
  }
  return result;
}

bool separates_somehow(const Walk& walk, const Part& part) noexcept {
  const std::array<Vector, 4> about = mean(walk, part);
  if (separates(walk, part, between_elements(walk, about))) return true;
  if (walk.metric != Metric::max) return false;
  for (Index axis = 0; axis < 3; ++axis) {
    Vector n = {};
    n[axis] = about[0][axis] < 0 ? -1 : 1;
    if (separates(walk, part, n)) return true;
  }
  return false;
}

/// Whether they are within the distance of each other at the part's start; a hint.
bool seem_near_at_start(const Walk& walk, const Part& part) noexcept {
  std::array<Vector, 4> pairs = {};
  for (Index i = 0; i < walk.pairs; ++i) {
    for (Index axis = 0; axis < 3; ++axis) pairs[i][axis] = part.pairs[i][axis][0];
  }
  const Vector n = between_elements(walk, pairs);
  // The gap along n, which for a face's normal is not the vector between the closest points.
  double gap = geometry::dot(n, pairs[0]);
  for (Index i = 1; i < walk.pairs; ++i) gap = std::min(gap, geometry::dot(n, pairs[i]));
  return !(gap > std::sqrt(geometry::dot(n, n)) * (walk.distance * part.scale[0]));
}

}  // namespace

bool certainly_farther_in_parts(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation,
                                double t_max) noexcept {
  Walk walk;
  walk.kind = query.kind;
  walk.metric = separation.metric;
  walk.distance = frame.factor * separation.distance;
  if (!(walk.distance / frame.factor == separation.distance)) return false;
  constexpr Index kMostCuts = 10;
  constexpr int kMostParts = 48;
  std::array<Part, kMostCuts + 1> parts;  // still to come, the first one last
  if (!start(query, frame, walk, parts[0])) return false;
  if (seem_near_at_start(walk, parts[0])) return false;
  if (t_max < 1) {
    Part whole = parts[0];
    cut(walk, parts[0], whole, t_max);
  }
  Index count = 1;
  for (int looked_at = 0; count > 0; ++looked_at) {
    Part& part = parts[count - 1];
    if (separates_somehow(walk, part)) {
      --count;
      continue;
    }
    if (count == parts.size() || looked_at >= kMostParts) return false;
    cut(walk, parts[count], part, 0.5);
    if (seem_near_at_start(walk, part)) return false;
    ++count;
  }
  return true;
}

}  // namespace touchstone::filters
