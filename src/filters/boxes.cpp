// SPDX-License-Identifier: MIT
#include "filters/boxes.hpp"

#include <algorithm>

namespace touchstone::filters {

bool boxes_disjoint(const Query& query) noexcept {
  const std::size_t count = corner_count(query.kind);
  const std::size_t first_count = corners_of_first(query.kind);
  const auto disjoint_along = [&](double Vec3::*axis) {
    double low[2], high[2];
    for (std::size_t element = 0; element < 2; ++element) {
      const std::size_t begin = element == 0 ? 0 : first_count;
      const std::size_t end = element == 0 ? first_count : count;
      low[element] = std::min(query.start[begin].*axis, query.end[begin].*axis);
      high[element] = std::max(query.start[begin].*axis, query.end[begin].*axis);
      for (std::size_t i = begin + 1; i < end; ++i) {
        low[element] = std::min({low[element], query.start[i].*axis, query.end[i].*axis});
        high[element] = std::max({high[element], query.start[i].*axis, query.end[i].*axis});
      }
    }
    return high[0] < low[1] || high[1] < low[0];
  };
  return disjoint_along(&Vec3::x) || disjoint_along(&Vec3::y) || disjoint_along(&Vec3::z);
}

}  // namespace touchstone::filters
