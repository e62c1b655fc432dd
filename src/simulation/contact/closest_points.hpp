// The closest points of two elements at rest, in doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>

#include <touchstone/query.hpp>

#include "scene/scene.hpp"

namespace touchstone::sim {

inline double clamped(double x) { return std::clamp(x, 0.0, 1.0); }

/// The parameters in [0, 1] of the closest points of segments p0 p1 and q0 q1 (Ericson, "Real-Time Collision
/// Detection", 5.1.9).
std::array<double, 2> closest_on_segments(const Vector3& p0, const Vector3& p1, const Vector3& q0, const Vector3& q1);

/// Barycentric coordinates of the point of triangle a b c that is closest to p (Ericson, 5.1.5).
std::array<double, 3> closest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c);

/// The weights of the closest points of both elements of a pair.
struct Weights {
  std::array<double, 3> a{}, b{};
};
Weights closest_weights(Kind kind, const std::array<Vector3, 4>& corners);

}  // namespace touchstone::sim
