// A point infinitely near a rational point, and what is around it, exactly.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <touchstone/query.hpp>

#include "broad_phase/box.hpp"
#include "mesh/inside_surfaces/ray_passes.hpp"

namespace touchstone::mesh {

/// The point x / w, with w > 0.
struct RationalPoint {
  ExactPoint x;
  numbers::Exact w{1};
};

/// point + e across + e^2 up + e^3 (0, 1, 0) + e^4 (0, 0, 1) for every e > 0 that is small enough: a linear function of
/// the point has the sign of the first term that is not 0.
struct PointBeside {
  RationalPoint point;
  ExactPoint across, up;

  /// The sign of normal . (this - origin). @param terms  how many of the five terms count
  int side(const ExactPoint& normal, const ExactPoint& origin, int terms = 5) const;
};

/// A box with the point in it.
broad_phase::Box box_around(const RationalPoint& point);

using Corners = std::array<Vec3, 3>;
using ExactCorners = std::array<ExactPoint, 3>;

ExactCorners exact(const Corners& face);
ExactPoint normal_of(const ExactCorners& face);  ///< 0 of a flat face
bool is_zero(const ExactPoint& v);

/// Whether a face covers a point beside: 1 if its normal has the direction of `up`, -1 for the other one, 0 if it does
/// not cover it. Its plane has the rational point in it, and is at a right angle to `up`.
int covers(const ExactCorners& face, const PointBeside& beside);

/// Faces of one group, with their boxes.
struct GroupFaces {
  std::vector<Corners> corners;
  std::vector<broad_phase::Box> boxes;

  void add(const Corners& face);
};

/// The winding number of the faces about the point, which is on none of them: how often the ray from it along x leaves
/// through outer sides, less how often it does through inner ones. The terms e^3 and e^4 keep the ray away from edges.
/// @param around  box_around the rational point beside it
int winding_number(const GroupFaces& faces, const PointBeside& beside, const broad_phase::Box& around);

}  // namespace touchstone::mesh
