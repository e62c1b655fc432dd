// SPDX-License-Identifier: MIT
#include <touchstone/curved_query.hpp>

#include <algorithm>
#include <cstddef>
#include <string>

#include <touchstone/error.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

CurvedCorner CurvedCorner::on_body(int motion, const Vec3& point) { return {motion, 1, {point}}; }

CurvedCorner CurvedCorner::on_curve(std::initializer_list<Vec3> control_points) {
  CurvedCorner corner;
  if (control_points.size() < 1 || control_points.size() > corner.points.size()) {
    throw InvalidQuery("a corner has " + std::to_string(control_points.size()) +
                       " control points; a curve has 1 to 4 of them");
  }
  corner.control_points = static_cast<int>(control_points.size());
  std::copy(control_points.begin(), control_points.end(), corner.points.begin());
  return corner;
}

CurvedQuery::CurvedQuery(const Query& query) : kind(query.kind) {
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    corners[i] = CurvedCorner::on_curve({query.start[i], query.end[i]});
  }
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
