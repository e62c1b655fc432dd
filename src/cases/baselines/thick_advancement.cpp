// Additive continuous collision detection with a minimum separation.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "baselines/distance.hpp"
#include "baselines/separation_baseline.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::baselines {
namespace {

/// A bound on the relative displacement of any two points: the largest of a corner of one element plus the largest of a
/// corner of the other, both relative to the mean, as in the paper.
double displacement_bound(const Query& query, int exponent) {
  const std::size_t corners = corner_count(query.kind);
  std::array<Vector, 4> moved;
  Vector mean{};
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec3 &a = query.start[i], &b = query.end[i];
    moved[i] = {{std::scalbn(b.x, -exponent) - std::scalbn(a.x, -exponent),
                 std::scalbn(b.y, -exponent) - std::scalbn(a.y, -exponent),
                 std::scalbn(b.z, -exponent) - std::scalbn(a.z, -exponent)}};
    mean = mean + (1.0 / static_cast<double>(corners)) * moved[i];
  }
  const std::size_t of_first = geometry::corners_of_first(query.kind);
  double first = 0, second = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    double& largest = i < of_first ? first : second;
    largest = std::max(largest, length(moved[i] - mean));
  }
  return first + second;
}

}  // namespace

Result solve_thick_advancement(const Query& query, double separation, double t_max, double tolerance) {
  const Frame frame = frame_of(query);
  const double apart = std::scalbn(separation, -frame.exponent);
  const double bound = displacement_bound(query, frame.exponent);
  const auto gap_at = [&](double t) { return distance_at(frame, t) - apart; };
  const double first_gap = gap_at(0);
  if (first_gap <= 0) return {true, 0};
  const double fraction = tolerance >= 0 ? std::min(tolerance, 1.0) : 0.0;
  const double enough = fraction * first_gap;
  double t = 0;
  double gap = first_gap;
  for (int step = 0; step < kAdvancementSteps; ++step) {
    const double next = t + (1 - fraction) * gap / bound;  // infinite or no number at all when nothing moves
    if (!(next <= t_max)) return {};
    gap = gap_at(next);
    if (gap < enough || gap <= 0) return {true, t};
    t = next;
  }
  return {true, t};
}

}  // namespace touchstone::baselines
