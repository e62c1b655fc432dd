// SPDX-License-Identifier: MIT
#include "mesh/folds.hpp"

#include <cmath>

#include "geometry/vector.hpp"
#include "mesh/rounded_vectors.hpp"

namespace touchstone::mesh {
namespace {

using Vector = geometry::Vector<double>;

/// Whether `x`, the rounded difference of two points, certainly has a positive scalar product with n. Each of the three
/// terms passes a difference, a product and two sums: its error is at most 4 e, e = 2^-53, and second-order terms,
/// relative to it. The bound is twice that, of the rounded terms. 2^-1000 covers underflow in the products.
bool certainly_above(const Vector& n, const Vector& x) noexcept {
  const double terms[3] = {n[0] * x[0], n[1] * x[1], n[2] * x[2]};
  const double size = std::fabs(terms[0]) + std::fabs(terms[1]) + std::fabs(terms[2]);
  return terms[0] + terms[1] + terms[2] > 8 * 0x1p-53 * size + 0x1p-1000;
}

/// Whether three vectors, rounded differences of points, are certainly not in one plane. A monomial of the determinant
/// passes 3 differences, 2 products and 3 sums: its error is at most 8 e, and second-order terms, relative to it, and
/// the bound is twice that of the sum of the rounded monomials' sizes. Where no component exceeds 2^300, underflow in a
/// product of two, at most 2^-1074, is multiplied by at most 2^300.
bool certainly_not_coplanar(const Vector& a, const Vector& b, const Vector& c) noexcept {
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (!(std::fabs(a[i]) < 0x1p300 && std::fabs(b[i]) < 0x1p300 && std::fabs(c[i]) < 0x1p300)) return false;
    const double one = b[j] * c[k], other = b[k] * c[j];
    sum += a[i] * (one - other);
    size += std::fabs(a[i]) * (std::fabs(one) + std::fabs(other));
  }
  return std::fabs(sum) > 16 * 0x1p-53 * size + 0x1p-760;
}

}  // namespace

// The segment leaves the triangle's plane, or a plane through the shared point has the segment on its positive side and
// the other points not. Its normal n goes to the segment's direction from that of the nearest other point. Any n is as
// good for the proof: if it does not separate, or is no number, nothing is proved.
bool certainly_unfolded(const Vec3& shared, const Vec3& end, const std::array<Vec3, 2>& others,
                        std::size_t count) noexcept {
  const Vector along = from_to(shared, end);
  std::array<Vector, 2> to{};
  for (std::size_t i = 0; i < count; ++i) to[i] = from_to(shared, others[i]);
  if (count == 2 && certainly_not_coplanar(along, to[0], to[1])) return true;
  const Vector d = unit(along);
  Vector nearest = unit(to[0]);
  if (count == 2) {
    const Vector other = unit(to[1]);
    if (geometry::dot(d, other) > geometry::dot(d, nearest)) nearest = other;
  }
  const Vector n{{d[0] - nearest[0], d[1] - nearest[1], d[2] - nearest[2]}};
  if (!certainly_above(n, along)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!certainly_above({{-n[0], -n[1], -n[2]}}, to[i])) return false;
  }
  return true;
}

}  // namespace touchstone::mesh
