// SPDX-License-Identifier: MIT
#include "view/closest_points.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "numbers/roots/real_root.hpp"

namespace touchstone::view {
namespace {

using Points = std::array<ExactVector, 4>;

/// Corners of each element whose affine hulls may hold the closest points.
struct CornerSets {
  std::vector<std::size_t> a, b;
};

std::vector<CornerSets> corner_sets_of(Kind kind) {
  switch (kind) {
    case Kind::edge_edge:
      return {{{0}, {2}},    {{0}, {3}},    {{1}, {2}},    {{1}, {3}},      {{0, 1}, {2}},
              {{0, 1}, {3}}, {{0}, {2, 3}}, {{1}, {2, 3}}, {{0, 1}, {2, 3}}};
    case Kind::vertex_face:
      return {{{0}, {1}}, {{0}, {2}}, {{0}, {3}}, {{0}, {1, 2}}, {{0}, {2, 3}}, {{0}, {3, 1}}, {{0}, {1, 2, 3}}};
    case Kind::point_edge: return {{{0}, {1}}, {{0}, {2}}, {{0}, {1, 2}}};
    case Kind::point_point: break;
  }
  return {{{0}, {1}}};
}

Exact squared_distance(const Points& points, const std::array<Exact, 4>& weights, std::size_t first,
                       std::size_t count) {
  ExactVector gap;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Exact term = weights[i] * points[i][k];
      gap[k] = i < first ? gap[k] - term : gap[k] + term;
    }
  }
  return dot(gap, gap);
}

/// x, so that |rest + sum x_i directions_i| is least, by the normal equations and Cramer's rule; nothing if the
/// directions are dependent or some x_i is not in [0, 1].
std::optional<std::array<Exact, 2>> least_squares(const std::vector<ExactVector>& directions, const ExactVector& rest) {
  const Exact zero(0);
  std::array<Exact, 2> numerators;
  Exact determinant(1);
  if (directions.size() == 1) {
    determinant = dot(directions[0], directions[0]);
    numerators[0] = -dot(directions[0], rest);
  } else if (directions.size() == 2) {
    const Exact aa = dot(directions[0], directions[0]), ab = dot(directions[0], directions[1]),
                bb = dot(directions[1], directions[1]), ar = dot(directions[0], rest), br = dot(directions[1], rest);
    determinant = aa * bb - ab * ab;
    numerators = {ab * br - bb * ar, ab * ar - aa * br};
  }
  if (numbers::is_zero(determinant)) return std::nullopt;
  std::array<Exact, 2> x;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (numerators[i] < zero || numerators[i] > determinant) return std::nullopt;
    x[i] = long_quotient(numerators[i], determinant);
    if (x[i] < zero || x[i] > Exact(1)) return std::nullopt;  // by the quotient's error; the corners stand in
  }
  return x;
}

std::optional<std::array<Exact, 4>> weights_of(const CornerSets& chosen, const Points& points) {
  std::vector<ExactVector> directions;
  std::vector<std::size_t> owners;
  for (std::size_t i = 1; i < chosen.a.size(); ++i) {
    directions.push_back(points[chosen.a[0]] - points[chosen.a[i]]);
    owners.push_back(chosen.a[i]);
  }
  for (std::size_t i = 1; i < chosen.b.size(); ++i) {
    directions.push_back(points[chosen.b[i]] - points[chosen.b[0]]);
    owners.push_back(chosen.b[i]);
  }
  const auto x = least_squares(directions, points[chosen.b[0]] - points[chosen.a[0]]);
  if (!x) return std::nullopt;
  std::array<Exact, 4> weights;
  weights[chosen.a[0]] = Exact(1);
  weights[chosen.b[0]] = Exact(1);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const std::size_t base = i + 1 < chosen.a.size() ? chosen.a[0] : chosen.b[0];
    weights[owners[i]] = (*x)[i];
    weights[base] = weights[base] - (*x)[i];
  }
  for (const Exact& weight : weights) {
    if (weight < Exact(0)) return std::nullopt;
  }
  return weights;
}

/// A time with the elements' distance there.
struct Approach {
  Exact t, squared, denominator;
};

Approach approach_at(const MovingCorners& corners, Exact t) {
  ClosestPoints closest = closest_points(corners, t);
  Exact denominator = value(corners.denominator, t);
  return {std::move(t), std::move(closest.squared_distance), std::move(denominator)};
}

bool closer(const Approach& x, const Approach& y) {
  return x.squared * y.denominator * y.denominator < y.squared * x.denominator * x.denominator;
}

/// Narrows down the least distance between two times that are not closer than one between them.
Approach searched(const MovingCorners& corners, Exact low, Exact high) {
  constexpr int kRounds = 60;
  const Exact quarter = numbers::power_of_two(-2);
  Approach best = approach_at(corners, (low + high) * numbers::power_of_two(-1));
  for (int round = 0; round < kRounds && low < high; ++round) {
    const Exact step = (high - low) * quarter;
    Approach left = approach_at(corners, low + step), right = approach_at(corners, high - step);
    (closer(left, right) ? high : low) = closer(left, right) ? right.t : left.t;
    if (closer(left, best)) best = std::move(left);
    if (closer(right, best)) best = std::move(right);
  }
  return best;
}

}  // namespace

ClosestPoints closest_points(const MovingCorners& corners, const Exact& t) {
  const Points points = corners.at(t);
  std::optional<ClosestPoints> best;
  for (const CornerSets& chosen : corner_sets_of(corners.kind)) {
    const auto weights = weights_of(chosen, points);
    if (!weights) continue;
    Exact distance = squared_distance(points, *weights, corners.first_count, corners.count);
    if (!best || distance < best->squared_distance) best = ClosestPoints{*weights, std::move(distance)};
  }
  return *best;  // two corners always give one
}

Exact closest_approach(const MovingCorners& corners, double t_max) {
  constexpr int kSamples = 64;
  const Exact end(t_max);
  std::vector<Approach> samples;
  std::size_t least = 0;
  for (int i = 0; i <= kSamples; ++i) {
    samples.push_back(approach_at(corners, end * Exact(i) * numbers::power_of_two(-6)));
    if (closer(samples.back(), samples[least])) least = samples.size() - 1;
  }
  Approach best = samples[least];
  const std::size_t before = least == 0 ? 0 : least - 1, after = least + 1 < samples.size() ? least + 1 : least;
  Approach found = searched(corners, samples[before].t, samples[after].t);
  if (closer(found, best)) best = std::move(found);
  const Dense v = corners.coplanarity();
  if (v.size() > 1) {
    const numbers::RootList roots = numbers::isolate_roots(proofs::coefficients(v), end);
    for (int i = 0; i < roots.size(); ++i) {
      const numbers::RealRoot& root = roots[i];
      const Exact low(root.lower()), high(root.upper());
      const bool changes = numbers::sign_of(value(v, low)) * numbers::sign_of(value(v, high)) < 0;
      Approach at_root = approach_at(corners, changes ? narrowed_root(v, low, high) : low);
      if (closer(at_root, best)) best = std::move(at_root);
    }
  }
  return best.t;
}

}  // namespace touchstone::view
