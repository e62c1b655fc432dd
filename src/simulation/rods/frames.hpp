// Reference frames of cable segments, carried along in time (Bergou et al., "Discrete viscous threads", 2010).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace touchstone::sim {

/// One director a rod edge, of length 1 and perpendicular to the edge; the second is tangent x director. One angle a
/// joint, by which the frames of its edges differ beyond the shortest rotation that takes one tangent to the other.
struct Frames {
  std::vector<Vector3> director;
  std::vector<double> reference_twist;
};

/// `u` under the shortest rotation that takes the unit vector `from` to the unit vector `to`.
Vector3 parallel_transport(const Vector3& u, const Vector3& from, const Vector3& to);

/// Any unit vector perpendicular to `t`.
Vector3 any_perpendicular(const Vector3& t);

/// `u` without its part along the unit vector `t`, of length 1.
Vector3 unit_perpendicular(const Vector3& u, const Vector3& t);

/// The angle from u to v about `axis`; all of length 1.
double signed_angle(const Vector3& u, const Vector3& v, const Vector3& axis);

/// `u` turned about the unit vector `axis`, to which it is perpendicular.
Vector3 turned(const Vector3& u, const Vector3& axis, double angle);

}  // namespace touchstone::sim
