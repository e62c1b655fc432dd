// Groups of vertices in a motion, and which of them are not asked about.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::proofs {

/// Two elements are no pair if all groups of one are ignored with all groups of the other.
struct MotionGroups {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};  ///< a group that is ignored with none
  std::vector<std::uint32_t> of_vertices;                    ///< by vertex; empty when nothing is ignored
  std::vector<std::array<std::uint32_t, 2>> ignored;         ///< the lesser group first, in ascending order

  /// Of two groups.
  bool are_asked(std::uint32_t g, std::uint32_t h) const noexcept {
    return !std::binary_search(ignored.begin(), ignored.end(), std::array{std::min(g, h), std::max(g, h)});
  }

  /// Of elements with these corners.
  template <std::size_t N, std::size_t M>
  bool are_asked(const std::array<std::uint32_t, N>& a, const std::array<std::uint32_t, M>& b) const noexcept {
    return ignored.empty() || std::any_of(a.begin(), a.end(), [&](std::uint32_t v) {
             return std::any_of(b.begin(), b.end(),
                                [&](std::uint32_t w) { return are_asked(of_vertices[v], of_vertices[w]); });
           });
  }
};

/// The groups by which the same elements are no pairs as by the rules of a mesh. Groups with the same list of groups
/// are one here: many objects of which nothing is asked, say.
inline MotionGroups motion_groups(const CollisionRules& rules) {
  const bool only_listed = rules.group_rule == GroupRule::only_listed;
  if (rules.groups.empty() || (!only_listed && rules.group_pairs.empty())) return {};
  std::map<std::uint32_t, std::vector<std::uint32_t>> listed;  // with each group, in ascending order
  for (const std::uint32_t group : rules.groups) listed[group];
  for (const auto& [g, h] : rules.group_pairs) {
    listed[g].push_back(h);
    listed[h].push_back(g);
  }
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;  // of the new groups, by their lists
  std::map<std::uint32_t, std::uint32_t> number_of;             // and by the groups
  if (!only_listed) numbers.emplace(std::vector<std::uint32_t>{}, MotionGroups::kNone);
  const auto first = static_cast<std::uint32_t>(numbers.size());
  for (auto& [group, list] : listed) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    number_of[group] = numbers.emplace(list, static_cast<std::uint32_t>(numbers.size()) - first).first->second;
  }
  MotionGroups groups;
  for (const std::uint32_t group : rules.groups) groups.of_vertices.push_back(number_of.at(group));
  if (!only_listed) {
    for (const auto& [g, h] : rules.group_pairs) {
      groups.ignored.push_back(
          {std::min(number_of.at(g), number_of.at(h)), std::max(number_of.at(g), number_of.at(h))});
    }
  } else {
    for (const auto& [list, number] : numbers) {
      std::vector<char> asked(numbers.size(), 0);
      for (const std::uint32_t group : list) asked[number_of.at(group)] = 1;
      for (std::uint32_t other = number; other < asked.size(); ++other) {
        if (asked[other] == 0) groups.ignored.push_back({number, other});
      }
    }
  }
  std::sort(groups.ignored.begin(), groups.ignored.end());
  groups.ignored.erase(std::unique(groups.ignored.begin(), groups.ignored.end()), groups.ignored.end());
  return groups;
}

}  // namespace touchstone::proofs
