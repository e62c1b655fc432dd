// SPDX-License-Identifier: MIT
#include "filters/curved/curved_scale.hpp"

namespace touchstone::filters {
namespace {

using Index = std::size_t;

double largest_of(const Vec3& x) noexcept { return std::max({std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)}); }

}  // namespace

double longest(const CurvedQuery& query) noexcept {
  double longest = 0;
  std::array<bool, 4> used{};
  for (Index i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    const bool on_body = corner.motion != CurvedCorner::kOnCurve;
    if (on_body) used[static_cast<Index>(corner.motion)] = true;
    const Index points = on_body ? 1 : static_cast<Index>(corner.control_points);
    for (Index k = 0; k < points; ++k) longest = std::max(longest, largest_of(corner.points[k]));
  }
  for (Index m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    longest = std::max({longest, largest_of(query.motions[m].p0), largest_of(query.motions[m].p1)});
  }
  return longest;
}

double largest_component(const RigidMotion& motion) noexcept {
  double largest = 0;
  for (Index i = 0; i < 4; ++i) largest = std::max({largest, std::fabs(motion.q0[i]), std::fabs(motion.q1[i])});
  return largest;
}

}  // namespace touchstone::filters
