// SPDX-License-Identifier: MIT
#include "mesh/coinciding.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "mesh/motion.hpp"
#include "numbers/float_environment.hpp"
#include "solver/cascade.hpp"

namespace touchstone {
namespace {

// Behind the guard: where subnormal numbers count as zero, different positions would be equal.
TOUCHSTONE_BEHIND_GUARD std::size_t count_coinciding(const Mesh::Impl& mesh, const Positions& x) {
  const mesh::Motion motion = mesh::motion_of(mesh, x, x, 1);
  const auto place = [&](MeshIndex v) {
    const Vec3& at = motion[v].start;
    return std::tie(at.x, at.y, at.z);
  };
  std::vector<MeshIndex> sorted = mesh.vertices;
  std::sort(sorted.begin(), sorted.end(), [&](MeshIndex a, MeshIndex b) { return place(a) < place(b); });
  std::size_t count = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool as_before = i > 0 && place(sorted[i]) == place(sorted[i - 1]);
    const bool as_after = i + 1 < sorted.size() && place(sorted[i]) == place(sorted[i + 1]);
    count += as_before || as_after ? 1 : 0;
  }
  return count;
}

}  // namespace

std::size_t coinciding_vertices(const Mesh& mesh, const Positions& x) {
  const numbers::DefaultFloatEnvironment environment;
  return count_coinciding(mesh.impl(), x);
}

}  // namespace touchstone
