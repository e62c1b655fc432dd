// SPDX-License-Identifier: MIT
#include "mesh/group_relations/point_beside.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace touchstone::mesh {
namespace {

using numbers::Exact;

/// The direction in which the side of the line a b grows, in the projection along x.
ExactPoint across_projected(const ExactPoint& a, const ExactPoint& b) { return {{Exact(), a[2] - b[2], b[1] - a[1]}}; }

/// As `passes` of ray_passes.hpp, of another start.
int leaves(const ExactCorners& face, const PointBeside& beside) {
  const int side = beside.side(across_projected(face[0], face[1]), face[0]);
  if (side == 0 || side != beside.side(across_projected(face[1], face[2]), face[1]) ||
      side != beside.side(across_projected(face[2], face[0]), face[2])) {
    return 0;
  }
  return beside.side(normal_of(face), face[0]) == -side ? side : 0;
}

}  // namespace

// approximate_quotient is within 2^-50 of a coordinate, or at the next double where that
// underflows; it is infinite only next to the greatest double.
broad_phase::Box box_around(const RationalPoint& point) {
  broad_phase::Box box{};
  for (std::size_t k = 0; k < 3; ++k) {
    constexpr double kMost = std::numeric_limits<double>::max(), kInfinity = std::numeric_limits<double>::infinity();
    const double x = numbers::approximate_quotient(point.x[k], point.w);
    const double room = std::min(std::abs(x), kMost) * 0x1p-49;
    box.low[k] = std::nextafter(std::min(x, kMost) - room, -kInfinity);
    box.high[k] = std::nextafter(std::max(x, -kMost) + room, kInfinity);
  }
  return box;
}

int PointBeside::side(const ExactPoint& normal, const ExactPoint& origin, int terms) const {
  const ExactPoint from{
      {point.x[0] - point.w * origin[0], point.x[1] - point.w * origin[1], point.x[2] - point.w * origin[2]}};
  for (int term = 0; term < terms; ++term) {
    const int sign = term == 0   ? numbers::sign_of(geometry::dot(normal, from))
                     : term == 1 ? numbers::sign_of(geometry::dot(normal, across))
                     : term == 2 ? numbers::sign_of(geometry::dot(normal, up))
                                 : numbers::sign_of(normal[term == 3 ? 1 : 2]);
    if (sign != 0) return sign;
  }
  return 0;
}

ExactCorners exact(const Corners& face) { return {exact(face[0]), exact(face[1]), exact(face[2])}; }

ExactPoint normal_of(const ExactCorners& face) { return geometry::cross(face[1] - face[0], face[2] - face[0]); }

bool is_zero(const ExactPoint& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

int covers(const ExactCorners& face, const PointBeside& beside) {
  int all = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    // A normal of the edge within the plane, so that `up` does not count.
    const ExactPoint inwards = geometry::cross(beside.up, face[(i + 1) % 3] - face[i]);
    const int side = beside.side(inwards, face[i], 2);
    if (side == 0 || (i > 0 && side != all)) return 0;
    all = side;
  }
  return all;
}

void GroupFaces::add(const Corners& face) {
  corners.push_back(face);
  broad_phase::Box box = broad_phase::empty_box();
  for (const Vec3& corner : face) broad_phase::extend(box, corner);
  boxes.push_back(box);
}

int winding_number(const GroupFaces& faces, const PointBeside& beside, const broad_phase::Box& around) {
  int winding = 0;
  for (std::size_t f = 0; f < faces.boxes.size(); ++f) {
    const broad_phase::Box& box = faces.boxes[f];
    if (box.high[0] < around.low[0] || box.high[1] < around.low[1] || box.high[2] < around.low[2] ||
        box.low[1] > around.high[1] || box.low[2] > around.high[2]) {
      continue;
    }
    winding += leaves(exact(faces.corners[f]), beside);
  }
  return winding;
}

}  // namespace touchstone::mesh
