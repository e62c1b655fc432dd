// SPDX-License-Identifier: MIT
#include "view/touched_point.hpp"

#include <cstddef>

#include "geometry/kind_traits.hpp"

namespace touchstone::view {

Triple touched_point(const Query& query, const Answer& answer) noexcept {
  Triple point{};
  const std::size_t corners = geometry::corners_of_first(query.kind);
  for (std::size_t c = 0; c < corners; ++c) {
    const Vec3 &from = query.start[c], &to = query.end[c];
    const double weight = corners == 1 ? 1 : answer.weights_a[c], t = answer.toi;
    point[0] += weight * ((1 - t) * from.x + t * to.x);
    point[1] += weight * ((1 - t) * from.y + t * to.y);
    point[2] += weight * ((1 - t) * from.z + t * to.z);
  }
  return point;
}

}  // namespace touchstone::view
