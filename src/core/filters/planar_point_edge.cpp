// SPDX-License-Identifier: MIT
#include "filters/planar_point_edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace touchstone::filters {

std::optional<Query> as_crossing_edges(const Query& query) noexcept {
  using Axis = double Vec3::*;
  if (query.kind != Kind::point_edge) return std::nullopt;
  const auto& start = query.start;
  const auto& end = query.end;
  const auto is_constant = [&](Axis axis) {
    const double value = start[0].*axis;
    for (std::size_t i = 0; i < 3; ++i) {
      if (start[i].*axis != value || end[i].*axis != value) return false;
    }
    return true;
  };
  constexpr Axis kPlanes[][3] = {
      {&Vec3::z, &Vec3::x, &Vec3::y}, {&Vec3::x, &Vec3::y, &Vec3::z}, {&Vec3::y, &Vec3::z, &Vec3::x}};
  for (const auto& [across, x, y] : kPlanes) {
    if (!is_constant(across)) continue;
    double largest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      for (const Axis axis : {x, y}) {
        largest =
            std::max({largest, std::fabs(start[i].*axis - start[0].*axis), std::fabs(end[i].*axis - end[0].*axis)});
      }
    }
    if (!(largest > 0 && std::isfinite(largest))) return std::nullopt;
    // Half the length of the segment across the plane. Any positive number would be right. With a power of two about as
    // large as the elements and the distance between them, the bounds of the tests that follow are tight.
    const double size = std::ldexp(1.0, std::ilogb(largest));
    const auto moved = [x = x, y = y](const Vec3& from, double z) { return Vec3{from.*x, from.*y, z}; };
    std::optional<Query> edges(std::in_place);
    edges->kind = Kind::edge_edge;
    edges->start = {moved(start[0], -size), moved(start[0], size), moved(start[1], 0), moved(start[2], 0)};
    edges->end = {moved(end[0], -size), moved(end[0], size), moved(end[1], 0), moved(end[2], 0)};
    return edges;
  }
  return std::nullopt;
}

void name_point_and_edge(Answer& answer) noexcept {
  answer.nature = Nature::isolated;  // the kind has no cubic
  answer.feature_a = Feature::p;
  answer.feature_b = Feature::e;
  answer.weights_a = {1, 0, 0};
}

}  // namespace touchstone::filters
