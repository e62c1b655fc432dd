// Distances in doubles, each the least over interiors and boundaries.
// SPDX-License-Identifier: MIT
#include "baselines/distance.hpp"

#include <algorithm>
#include <cmath>

// Every feature has its own projection. This is more work than a search for the closest pair of features, but no case
// depends on which side of a threshold a rounded number fell.
namespace touchstone::baselines {

using geometry::cross;
using geometry::dot;

namespace {

// Below this sine, squared, the direction of the common normal is rounding noise, and the boundaries are as near as the
// interiors, up to the same fraction of a length.
constexpr double kParallel = 0x1p-80;

}  // namespace

double point_segment_distance(const Vector& r, const Vector& u) {
  const double uu = dot(u, u);
  const double f = uu > 0 ? std::clamp(dot(r, u) / uu, 0.0, 1.0) : 0.0;
  // Measured from the nearer end: beyond f = 1/2 the other corner's difference has the smaller rounding error.
  return f < 0.5 ? length(r - f * u) : length((r - u) + (1 - f) * u);
}

double segment_distance(const Vector& u, const Vector& w, const Vector& r) {
  double least = std::min({point_segment_distance(r, u), point_segment_distance(r + w, u),
                           point_segment_distance(-r, w), point_segment_distance(u - r, w)});
  const Vector n = cross(u, w);
  const double nn = dot(n, n);
  if (nn > kParallel * dot(u, u) * dot(w, w)) {
    const double f1 = dot(cross(r, w), n);
    const double f2 = dot(cross(r, u), n);
    if (f1 >= 0 && f1 <= nn && f2 >= 0 && f2 <= nn) least = std::min(least, std::fabs(dot(r, n)) / std::sqrt(nn));
  }
  return least;
}

double point_triangle_distance(const Vector& u, const Vector& w, const Vector& r) {
  double least =
      std::min({point_segment_distance(r, u), point_segment_distance(r, w), point_segment_distance(r - u, w - u)});
  const Vector n = cross(u, w);
  const double nn = dot(n, n);
  if (nn > kParallel * dot(u, u) * dot(w, w)) {
    const double f1 = dot(cross(r, w), n);
    const double f2 = dot(cross(u, r), n);
    if (f1 >= 0 && f2 >= 0 && f1 + f2 <= nn) least = std::min(least, std::fabs(dot(r, n)) / std::sqrt(nn));
  }
  return least;
}

double distance_at(const Frame& frame, double t) {
  switch (frame.kind) {
    case Kind::edge_edge: return segment_distance(frame.u.at(t), frame.w.at(t), frame.r.at(t));
    case Kind::vertex_face: return point_triangle_distance(frame.u.at(t), frame.w.at(t), frame.r.at(t));
    case Kind::point_edge: return point_segment_distance(frame.r.at(t), frame.u.at(t));
    case Kind::point_point: break;
  }
  return length(frame.r.at(t));
}

}  // namespace touchstone::baselines
