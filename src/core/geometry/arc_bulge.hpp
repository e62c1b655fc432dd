// How far a point of a body that turns leaves the straight line between the ends of its path.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::geometry {

/// A body's quaternion is interpolated straight from q0 to q1, of length 1, with q0 . q1 >= 0. Then at each time t in
/// [0, 1] a point of the body at the distance r from its origin is at most kArcBulge |q1 - q0|^2 r away from the point
/// at t of the straight motion between the ends of its path.
///
/// The body turns by the angle a about an axis. Take a plane across the axis, the distance from the axis as the unit, s
/// = 2 t - 1, k = tan(a / 4) and T = s k. The point is at the angle 2 atan(T) from the middle of its arc, at (2 T, 1 -
/// T^2) / (1 + T^2). The straight motion is at (2 s k, 1 - k^2) / (1 + k^2). Along the first axis they are apart by
/// 2 s k^3 (1 - s^2) / ((1 + T^2) (1 + k^2)), along the second by 2 k^2 (1 - s^2) / ((1 + T^2) (1 + k^2)). q0 . q1 >= 0
/// makes k <= 1. So the distance is at most k^2 / (1 + k^2) sqrt(4 + 0.6 k^2) <= 2.2 k^2 / (1 + k^2), and |q1 - q0|^2 =
/// 4 k^2 / (1 + k^2).
inline constexpr double kArcBulge = 0.55;

}  // namespace touchstone::geometry
