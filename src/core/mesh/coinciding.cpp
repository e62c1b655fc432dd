// SPDX-License-Identifier: MIT
#include "mesh/coinciding.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "mesh/inside_surfaces/ray_passes.hpp"
#include "mesh/moving_vertices.hpp"
#include "mesh/rounded_vectors.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"

namespace touchstone {
namespace {

// Behind the guard: where subnormal numbers count as zero, different positions would be equal.
TOUCHSTONE_BEHIND_GUARD std::size_t count_coinciding(const Mesh::Impl& mesh, const Positions& x) {
  const mesh::Motion motion = mesh::motion_of(mesh, x, x, 1);
  const auto position = [&](MeshIndex v) {
    const Vec3& at = motion[v].start;
    return std::tie(at.x, at.y, at.z);
  };
  std::vector<MeshIndex> sorted = mesh.vertices;
  std::sort(sorted.begin(), sorted.end(), [&](MeshIndex a, MeshIndex b) { return position(a) < position(b); });
  std::size_t count = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool as_before = i > 0 && position(sorted[i]) == position(sorted[i - 1]);
    const bool as_after = i + 1 < sorted.size() && position(sorted[i]) == position(sorted[i + 1]);
    count += as_before || as_after ? 1 : 0;
  }
  return count;
}

/// Whether a b - c d is certainly not 0, of differences of coordinates. Each product has three roundings, of 2^-53
/// times itself, and the difference one more: less than 2^-50 of both products, where none is subnormal. Where they
/// overflow, nothing is certain.
bool differ(double a, double b, double c, double d) noexcept {
  const double p = a * b, q = c * d, size = std::fabs(p) + std::fabs(q);
  return size > 0x1p-900 && std::fabs(p - q) > 0x1p-49 * size;
}

bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  if (differ(u.x, v.y, u.y, v.x) || differ(u.y, v.z, u.z, v.y) || differ(u.z, v.x, u.x, v.z)) return false;
  const auto origin = mesh::exact(a);
  const auto normal = geometry::cross(mesh::exact(b) - origin, mesh::exact(c) - origin);
  return std::all_of(&normal[0], &normal[0] + 3, [](const numbers::Exact& x) { return numbers::sign_of(x) == 0; });
}

TOUCHSTONE_BEHIND_GUARD std::size_t count_flat(const Mesh::Impl& mesh, const Positions& x) {
  if (mesh.faces.empty()) return 0;
  const mesh::Motion motion = mesh::motion_of(mesh, x, x, 1);
  return static_cast<std::size_t>(std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const auto& face) {
    return is_flat(motion[face[0]].start, motion[face[1]].start, motion[face[2]].start);
  }));
}

using Vector = geometry::Vector<double>;

/// A lower bound of m . (u x v), or NaN. u and v are rounded differences, and m is as it is. A monomial passes two
/// differences, two products and three sums: its error is at most 7 e, e = 2^-53, and terms of second order, relative
/// to it. The bound has twice that of the sum of their sizes, and 2^-1000 for underflow, as |m| is at most 4.
double least_product(const Vector& m, const Vector& u, const Vector& v) noexcept {
  double sum = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const double one = u[j] * v[k], other = u[k] * v[j];
    sum += m[i] * (one - other);
    size += std::fabs(m[i]) * (std::fabs(one) + std::fabs(other));
  }
  return sum - 14 * 0x1p-53 * size - 0x1p-1000;
}

/// Whether a face is certainly not flat in the step. Its normal is quadratic in t: by Bernstein's basis
/// (1 - t)^2 u0 x v0 + t (1 - t) (u0 x v1 + u1 x v0) + t^2 u1 x v1. So it is not zero if each of these three has a
/// positive product with one vector m. Any m will do.
bool never_flat(const mesh::MovingVertex& a, const mesh::MovingVertex& b, const mesh::MovingVertex& c) noexcept {
  using mesh::from_to, mesh::unit;
  const Vector u0 = from_to(a.start, b.start), v0 = from_to(a.start, c.start);
  const Vector u1 = from_to(a.end, b.end), v1 = from_to(a.end, c.end);
  const Vector n0 = unit(geometry::cross(u0, v0)), n1 = unit(geometry::cross(u1, v1));
  const Vector m{{n0[0] + n1[0], n0[1] + n1[1], n0[2] + n1[2]}};
  return least_product(m, u0, v0) > 0 && least_product(m, u1, v1) > 0 &&
         least_product(m, u0, v1) + least_product(m, u1, v0) > 0;
}

TOUCHSTONE_BEHIND_GUARD std::size_t count_turning(const Mesh::Impl& mesh, const Positions& x0, const Positions& x1) {
  if (mesh.faces.empty()) return 0;
  const mesh::Motion motion = mesh::motion_of(mesh, x0, x1, 1);
  return static_cast<std::size_t>(std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const auto& face) {
    return !never_flat(motion[face[0]], motion[face[1]], motion[face[2]]);
  }));
}

}  // namespace

std::size_t coinciding_vertices(const Mesh& mesh, const Positions& x) {
  const numbers::DefaultFloatEnvironment environment;
  return count_coinciding(mesh.impl(), x);
}

std::size_t flat_faces(const Mesh& mesh, const Positions& x) {
  const numbers::DefaultFloatEnvironment environment;
  return count_flat(mesh.impl(), x);
}

std::size_t turning_faces(const Mesh& mesh, const Positions& x0, const Positions& x1) {
  const numbers::DefaultFloatEnvironment environment;
  return count_turning(mesh.impl(), x0, x1);
}

}  // namespace touchstone
