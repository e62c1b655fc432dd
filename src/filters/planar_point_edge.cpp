// SPDX-License-Identifier: MIT
#include "filters/planar_point_edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace touchstone::filters {
namespace {

using Axis = double Vec3::*;

bool is_constant(const Query& q, Axis axis) noexcept {
  const double value = q.start[0].*axis;
  for (std::size_t i = 0; i < 3; ++i) {
    if (q.start[i].*axis != value || q.end[i].*axis != value) return false;
  }
  return true;
}

/// The power of two that is about as large as the elements and how far they are apart; 0 when that is nothing, or no double.
/// Any positive number would be right: with this one the bounds of the tests that follow are tight.
double size_of(const Query& q, Axis x, Axis y) noexcept {
  double largest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    for (const Axis axis : {x, y}) {
      largest = std::max(
          {largest, std::fabs(q.start[i].*axis - q.start[0].*axis), std::fabs(q.end[i].*axis - q.end[0].*axis)});
    }
  }
  return largest > 0 && std::isfinite(largest) ? std::ldexp(1.0, std::ilogb(largest)) : 0;
}

}  // namespace

bool as_crossing_edges(const Query& point_edge, Query& edges) noexcept {
  const Query& q = point_edge;
  constexpr Axis kPlanes[][3] = {
      {&Vec3::z, &Vec3::x, &Vec3::y}, {&Vec3::x, &Vec3::y, &Vec3::z}, {&Vec3::y, &Vec3::z, &Vec3::x}};
  for (const auto& [across, x, y] : kPlanes) {
    if (!is_constant(q, across)) continue;
    const double size = size_of(q, x, y);
    if (size == 0) return false;
    const auto place = [x = x, y = y](const Vec3& from, double z) { return Vec3{from.*x, from.*y, z}; };
    edges.kind = Kind::edge_edge;
    edges.start = {place(q.start[0], -size), place(q.start[0], size), place(q.start[1], 0), place(q.start[2], 0)};
    edges.end = {place(q.end[0], -size), place(q.end[0], size), place(q.end[1], 0), place(q.end[2], 0)};
    return true;
  }
  return false;
}

void name_point_and_edge(Answer& answer) noexcept {
  answer.nature = Nature::isolated;  // the kind has no cubic
  answer.feature_a = Feature::p;
  answer.feature_b = Feature::e;
  answer.weights_a = {1, 0, 0};
}

}  // namespace touchstone::filters
