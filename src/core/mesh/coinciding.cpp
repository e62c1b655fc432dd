// SPDX-License-Identifier: MIT
#include "mesh/coinciding.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "mesh/moving_vertices.hpp"
#include "mesh/ray_passes.hpp"
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

}  // namespace

std::size_t coinciding_vertices(const Mesh& mesh, const Positions& x) {
  const numbers::DefaultFloatEnvironment environment;
  return count_coinciding(mesh.impl(), x);
}

std::size_t flat_faces(const Mesh& mesh, const Positions& x) {
  const numbers::DefaultFloatEnvironment environment;
  return count_flat(mesh.impl(), x);
}

}  // namespace touchstone
