// SPDX-License-Identifier: MIT
#include "filters/boxes.hpp"

#include <algorithm>

namespace touchstone::filters {

bool boxes_disjoint(const Query& query) noexcept { return boxes_apart(query, 0); }

bool boxes_apart(const Query& query, double distance) noexcept {
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
    // A difference that is rounded to more than a double is more than it: rounding is monotone.
    return low[1] - high[0] > distance || low[0] - high[1] > distance;
  };
  return disjoint_along(&Vec3::x) || disjoint_along(&Vec3::y) || disjoint_along(&Vec3::z);
}

}  // namespace touchstone::filters
