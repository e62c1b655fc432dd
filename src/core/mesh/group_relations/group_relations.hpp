// How the groups of a mesh lie to each other at rest, exactly: apart, touching, overlapping, one inside the other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::mesh {

/// The inside of a group is the set of points about which its faces have a winding number above 0. A group is solid if
/// it has faces and nothing else, they pass each of their edges as often in one direction as in the other, and they
/// enclose a volume above 0. Any other group has no inside.
enum class Relation : std::uint8_t {
  clear,        ///< they have no common point, and neither is inside the other
  touching,     ///< their surfaces have common points, and their insides have none
  overlapping,  ///< the insides of two solids have common points, and neither inside is all in the other
  inside,       ///< no point of the first is outside of the second, which is solid; it may touch it from within
  around,       ///< the same the other way round
  same,         ///< the insides of two solids are the same, however their surfaces are cut into faces
  crossing  ///< one has no inside, and is partly inside of the solid and partly outside; or neither has, and an edge
            ///< of one pierces a face of the other
};

inline constexpr std::size_t kRelations = 7;

/// "clear", "touching", "overlapping", "inside", "around", "same", "crossing".
std::string_view name_of(Relation sort) noexcept;

struct GroupPair {
  std::uint32_t a = 0, b = 0;  ///< a < b
  Relation sort = Relation::clear;

  bool operator==(const GroupPair& other) const = default;
};

struct GroupRelations {
  std::vector<GroupPair> pairs;    ///< those that are not clear of each other, in ascending order
  std::size_t without_inside = 0;  ///< groups that have elements and are not solid
};

/// How all pairs of groups lie to each other.
/// @param mesh     its rules say which pairs of groups are asked about: those of which two vertices may collide
/// @param groups   the group of each vertex; elements do not share vertices of two groups
/// @param count    the number of groups; vertices with this or a greater number are in none
/// @throws InvalidQuery  for a mesh in the plane, and as `intersections`
GroupRelations group_relations(const Mesh& mesh, const Positions& x, const std::vector<std::uint32_t>& groups,
                               std::uint32_t count, const MeshOptions& options = {});

}  // namespace touchstone::mesh
