// Where faces cut a face or an edge: points of each piece between the cuts.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "mesh/group_relations/point_beside.hpp"

namespace touchstone::mesh {

/// Calls visit(beside) for points on both sides of the middle of each piece into which the borders and cuts of a face
/// divide each other; those outside of the face are left out. Every cell of the face has such a point, and a cell is
/// on the same side of all faces that cut it. visit returns whether to go on.
/// @param face  with an area
/// @param met   the faces that share points with it
template <class Visit>
void for_each_cell(const ExactCorners& face, const std::vector<ExactCorners>& met, const Visit& visit);

/// One point of a face that no other one cuts: of its only cell.
PointBeside point_in(const ExactCorners& face);

/// The middle of each piece of the segment from a to b between the points where it meets the planes of faces, or planes
/// through their edges across them. Of a point, it is that point.
std::vector<RationalPoint> middles_between(const ExactPoint& a, const ExactPoint& b,
                                           const std::vector<ExactCorners>& met);

/// Whether a point is on a face.
bool is_on(const RationalPoint& point, const ExactCorners& face);

/// A segment in the plane of a face, with its points (q + t step) / w for 0 <= t <= 1. It may be a point.
struct FaceCut {
  ExactPoint q, step;
  numbers::Exact w;
  broad_phase::Box box;  ///< around it
};

/// @param normal  of the face
/// The borders of the face, and the segments and points in which the others meet its plane.
std::vector<FaceCut> cuts_of(const ExactCorners& face, const ExactPoint& normal, const std::vector<ExactCorners>& met);

/// The middle of each piece of the cut between the points that others have in common with it.
std::vector<RationalPoint> middles_of(const FaceCut& cut, const std::vector<FaceCut>& all, const ExactPoint& normal);

template <class Visit>
void for_each_cell(const ExactCorners& face, const std::vector<ExactCorners>& met, const Visit& visit) {
  const ExactPoint up = normal_of(face);
  const std::vector<FaceCut> cuts = cuts_of(face, up, met);
  for (const FaceCut& cut : cuts) {
    if (is_zero(cut.step)) continue;
    const ExactPoint left = geometry::cross(up, cut.step);
    const ExactPoint right{{-left[0], -left[1], -left[2]}};
    for (RationalPoint& middle : middles_of(cut, cuts, up)) {
      for (const ExactPoint& across : {left, right}) {
        const PointBeside beside{middle, across, up};
        if (covers(face, beside) != 0 && !visit(beside)) return;
      }
    }
  }
}

}  // namespace touchstone::mesh
