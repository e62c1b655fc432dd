// How a ray passes through a triangle, exactly: its passes tell what is inside a closed surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <touchstone/query.hpp>

#include "broad_phase/box.hpp"
#include "geometry/vector.hpp"
#include "numbers/integers/exact_number.hpp"

namespace touchstone::mesh {

using ExactPoint = geometry::Vector<numbers::Exact>;

inline ExactPoint exact(const Vec3& v) { return {{numbers::Exact(v.x), numbers::Exact(v.y), numbers::Exact(v.z)}}; }

/// A ray along x from the middle of two points, which may be one.
struct Ray {
  Vec3 a, b;

  /// A box around the ray's part up to x = last. Its bounds are doubles beside the middle's coordinates.
  broad_phase::Box box(double last) const noexcept;
};

/// 1 or -1 if the ray along x from the point start / scale leaves the triangle through its outer side or its inner one; 0 if it does not pass the triangle,
/// which may be flat. The ray starts from a place beside its start, infinitely near: eps higher along y and eps^2 along
/// z. So it passes no border, and each triangle that it passes has an area in the projection along x. The sum over a
/// closed oriented surface that the start is not on is the surface's winding number about the start. Where each edge is
/// in an even number of triangles, the start is inside if the sum is odd.
///
/// A triangle that is passed has a point at the start's y and z, with an x that is not less: the limit as eps goes to
/// 0. So its box touches the ray's.
int passes(const ExactPoint& start, const numbers::Exact& scale, const std::array<Vec3, 3>& triangle);
int passes(const Ray& ray, const std::array<Vec3, 3>& triangle);

}  // namespace touchstone::mesh
