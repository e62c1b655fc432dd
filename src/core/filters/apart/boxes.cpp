// SPDX-License-Identifier: MIT
#include "filters/apart/boxes.hpp"

#include "geometry/kind_traits.hpp"

namespace touchstone::filters {

bool boxes_disjoint(const Query& query) noexcept { return boxes_apart(query, 0); }

bool boxes_apart(const Query& query, double distance) noexcept {
  const auto apart_along = [&](double Vec3::*axis) {
    const auto corner = [&](int side, std::size_t i) { return (side == 0 ? query.start : query.end)[i].*axis; };
    return ranges_apart<double>(geometry::corners_of_first(query.kind), corner_count(query.kind), distance, corner) !=
           0;
  };
  return apart_along(&Vec3::x) || apart_along(&Vec3::y) || apart_along(&Vec3::z);
}

}  // namespace touchstone::filters
