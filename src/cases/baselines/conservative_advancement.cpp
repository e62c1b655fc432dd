// Conservative advancement: nothing can touch before the distance has been travelled.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "baselines/baseline.hpp"
#include "baselines/distance.hpp"

namespace touchstone::baselines {
namespace {

double squared_length(const Vector& v) { return geometry::dot(v, v); }

/// An upper bound on the relative speed of any point of one element and any of the other. Their relative displacement
/// is a convex combination of those of pairs of corners, and the longest of these bounds it.
double speed_bound(const Frame& frame) {
  const Vector u = frame.u.delta();
  const Vector w = frame.w.delta();
  const Vector r = frame.r.delta();
  double squared = std::max(squared_length(r), squared_length(r - u));  // b0 against a0 and a1; v against f0 and f1
  if (frame.kind == Kind::edge_edge) squared = std::max({squared, squared_length(r + w), squared_length((r + w) - u)});
  if (frame.kind == Kind::vertex_face) squared = std::max(squared, squared_length(r - w));
  return std::sqrt(squared);
}

}  // namespace

Result solve_conservative_advancement(const Query& query, double t_max, double tolerance) {
  const Frame frame = frame_of(query);
  const double near = std::scalbn(tolerance, -frame.exponent);
  const double speed = speed_bound(frame);
  double t = 0;
  for (int step = 0; step < kAdvancementSteps; ++step) {
    const double distance = distance_at(frame, t);
    if (distance <= near) return {true, t};
    const double next = t + distance / speed;  // infinite or no number at all when nothing moves
    if (!(next <= t_max)) return {};
    t = next;
  }
  return {true, t};
}

}  // namespace touchstone::baselines
