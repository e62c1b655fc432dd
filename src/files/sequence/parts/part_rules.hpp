// Which parts of a mesh are asked about: its objects and groups, by their names.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/mesh.hpp>

#include "frames/frame.hpp"

namespace touchstone::sequence {

/// As a user gives it. A text that is no part's name is a pattern with * ? [. Two different texts name no part with
/// itself.
struct PartOptions {
  std::vector<std::string> ignored = {};       ///< "A,B": A and B are not asked about
  std::vector<std::string> only_between = {};  ///< "A,B": nothing but A and B is asked about
  bool between_parts = false;                  ///< whether pairs within one part are left out

  bool empty() const noexcept { return ignored.empty() && only_between.empty() && !between_parts; }
};

/// The same for one mesh: names that it has, as they are shown.
struct PartRules {
  GroupRule rule = GroupRule::all_but_listed;
  bool within = true;                             ///< whether pairs within one part are asked about, beside the list
  std::vector<std::array<std::string, 2>> pairs;  ///< of parts, in ascending order

  bool empty() const noexcept { return rule == GroupRule::all_but_listed && within && pairs.empty(); }
  bool operator==(const PartRules& other) const = default;
};

/// @param file  the name for messages
/// @param things  what parts are called in messages
/// @throws FileError  for a mesh without parts, or a name or pattern that none of its parts has
PartRules part_rules_of(const frames::Topology& topology, const PartOptions& options, const std::string& file,
                        std::string_view things = "parts");

/// The part of each vertex; the number of parts for vertices in none.
/// @throws FileError  for a vertex that two parts share: they cannot be told apart there
std::vector<MeshIndex> parts_of_vertices(const frames::Topology& topology, const std::string& file);

/// The rules as vertices have them. Vertices in no face are in no part: only a list of pairs to ask about leaves them
/// out.
/// @param topology  with the names that the rules were made for
/// @throws FileError  as parts_of_vertices
CollisionRules collision_rules(const frames::Topology& topology, const PartRules& rules, const std::string& file);

/// What the rules leave out, for a verdict: "pairs within one part were left out". Empty if that is nothing.
/// @param things  what parts are called
std::vector<std::string> left_out_by(const PartRules& rules, std::string_view things = "parts");

}  // namespace touchstone::sequence
