// How often a ray from a point passes through triangles, exactly: what is inside a closed surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "geometry/vector.hpp"
#include "numbers/exact_number.hpp"

namespace touchstone::mesh {

using ExactPoint = geometry::Vector<numbers::Exact>;

inline ExactPoint exact(const Vec3& v) { return {{numbers::Exact(v.x), numbers::Exact(v.y), numbers::Exact(v.z)}}; }

/// Counts the triangles that a ray along x passes through. The ray starts from a place beside the point, infinitely near:
/// eps higher along y and eps^2 along z. So it passes no border, and each triangle that it passes has an area in the
/// projection along x. For the triangles of a closed surface that the point is not on, `sum` is the surface's winding
/// number about the point, with normals outwards, and the point is inside if `passes` is odd.
class RayPasses {
 public:
  explicit RayPasses(const Vec3& from) noexcept : from_(from) {}

  /// A triangle; it may be flat. Its orientation is that of its corners.
  void add(const Vec3& a, const Vec3& b, const Vec3& c);

  int sum() const noexcept { return sum_; }  ///< passes to the outer side of a triangle, less those to its inner one
  int passes() const noexcept { return passes_; }  ///< all passes

 private:
  Vec3 from_;
  int sum_ = 0, passes_ = 0;
};

}  // namespace touchstone::mesh
