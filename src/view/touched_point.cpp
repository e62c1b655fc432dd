// SPDX-License-Identifier: MIT
#include "view/touched_point.hpp"

#include <algorithm>
#include <cmath>
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

Triple meeting_point(const std::vector<Triple>& first, const std::vector<Triple>& second) noexcept {
  if (first.size() == 1) return first[0];
  double t = 0.5;
  if (second.size() == 3) {
    const auto minus = [](const Triple& x, const Triple& y) { return Triple{x[0] - y[0], x[1] - y[1], x[2] - y[2]}; };
    const Triple u = minus(second[1], second[0]), w = minus(second[2], second[0]);
    const Triple n{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
    const auto height = [&](const Triple& x) {
      const Triple d = minus(x, second[0]);
      return n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
    };
    const double from = height(first[0]), to = height(first[1]);
    if (std::isfinite(from - to) && from != to) t = std::clamp(from / (from - to), 0.0, 1.0);
  }
  Triple point;
  for (std::size_t k = 0; k < 3; ++k) point[k] = first[0][k] + t * (first[1][k] - first[0][k]);
  return point;
}

}  // namespace touchstone::view
