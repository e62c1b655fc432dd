// Equality of curved queries, bit for bit.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstring>

#include <touchstone/curved_query.hpp>

namespace touchstone::tests {

/// Whether both are one query: the same bits in all that is read. Motions that no corner names are not.
inline bool same(const CurvedQuery& a, const CurvedQuery& b) {
  const auto equal = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  if (a.kind != b.kind) return false;
  for (std::size_t i = 0; i < corner_count(a.kind); ++i) {
    const CurvedCorner &one = a.corners[i], &other = b.corners[i];
    if (one.motion != other.motion) return false;
    const bool on_a_body = one.motion != CurvedCorner::kOnCurve;
    if (!on_a_body && one.control_points != other.control_points) return false;
    const std::size_t points = on_a_body ? 1 : static_cast<std::size_t>(one.control_points);
    for (std::size_t k = 0; k < points; ++k) {
      if (!equal(one.points[k], other.points[k])) return false;
    }
    if (!on_a_body) continue;
    const auto m = static_cast<std::size_t>(one.motion);
    const RigidMotion &motion = a.motions[m], &its = b.motions[m];
    if (!equal(motion.q0, its.q0) || !equal(motion.q1, its.q1) || !equal(motion.p0, its.p0) ||
        !equal(motion.p1, its.p1)) {
      return false;
    }
  }
  return true;
}

}  // namespace touchstone::tests
