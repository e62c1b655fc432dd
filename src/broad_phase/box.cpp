// SPDX-License-Identifier: MIT
#include "broad_phase/box.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace touchstone::broad_phase {

Box empty_box() noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

void extend(Box& box, const Vec3& corner) noexcept {
  const std::array<double, 3> x{corner.x, corner.y, corner.z};
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(box.low[k], x[k]);
    box.high[k] = std::max(box.high[k], x[k]);
  }
}

void grow(Box& box, double margin) noexcept {
  if (margin == 0) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    // A rounded difference is at most one double away from the exact one.
    box.low[k] = std::nextafter(box.low[k] - margin, -infinity);
    box.high[k] = std::nextafter(box.high[k] + margin, infinity);
  }
}

bool overlap(const Box& a, const Box& b) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) return false;
  }
  return true;
}

}  // namespace touchstone::broad_phase
