// SPDX-License-Identifier: MIT
#include "sequence/parts/part_rules.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>

#include "io/counted.hpp"
#include "io/fail.hpp"

namespace touchstone::sequence {
namespace {

constexpr std::size_t kShown = 10;                  // of the parts in a message, and of the pairs in a verdict
constexpr std::size_t kMostNamedPairs = 1'000'000;  // that a text may name

/// The part with exactly this name, or those that the pattern fits.
std::vector<std::size_t> parts_like(const std::vector<std::string>& parts, const std::string& pattern) {
  const auto same = std::find(parts.begin(), parts.end(), pattern);
  if (same != parts.end()) return {static_cast<std::size_t>(same - parts.begin())};
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (fnmatch(pattern.c_str(), parts[i].c_str(), 0) == 0) found.push_back(i);
  }
  return found;
}

std::string parts_for_person(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, parts.size()); ++i) {
    text += (i == 0 ? "" : ", ") + io::shortened(io::printable(parts[i]));
  }
  return parts.size() > kShown ? text + fmt::format(" and {} more", parts.size() - kShown) : text;
}

/// The pairs that "A,B" names. A name may have commas itself. Two different texts name no part with itself.
std::vector<std::array<std::size_t, 2>> pairs_like(const std::vector<std::string>& parts, const std::string& text,
                                                   const std::string& file, std::string_view things) {
  std::vector<std::array<std::size_t, 2>> pairs;
  std::size_t ways = 0;
  for (std::size_t comma = text.find(','); comma != std::string::npos; comma = text.find(',', comma + 1)) {
    const std::string a_text = text.substr(0, comma), b_text = text.substr(comma + 1);
    const auto first = parts_like(parts, a_text), second = parts_like(parts, b_text);
    if (!second.empty() && first.size() > kMostNamedPairs / second.size()) {
      io::fail(file, fmt::format("'{}' names {} pairs of {}; at most {} may be named: name fewer",
                                 io::shortened(io::printable(text)), io::grouped(first.size() * second.size()), things,
                                 io::grouped(kMostNamedPairs)));
    }
    const std::size_t before = pairs.size();
    for (const std::size_t a : first) {
      for (const std::size_t b : second) {
        if (a != b || a_text == b_text) pairs.push_back({std::min(a, b), std::max(a, b)});
      }
    }
    ways += pairs.size() > before ? 1 : 0;
  }
  if (ways == 1) return pairs;
  const std::string found = ways == 0 ? fmt::format("no two {}", things) : fmt::format("{} in several ways", things);
  io::fail(file, fmt::format("'{}' names {}: it must be two names of {}, such as A,B, or patterns; the {} are {}",
                             io::shortened(io::printable(text)), found, things, things, parts_for_person(parts)));
}

}  // namespace

PartRules part_rules_of(const frames::Topology& topology, const PartOptions& options, const std::string& file,
                        std::string_view things) {
  PartRules rules;
  if (options.empty()) return rules;
  if (topology.parts.empty())
    io::fail(
        file,
        "names no parts: objects or groups (`o` or `g` lines of an OBJ file); where each part has files of its own, "
        "--parts takes the name of each from them");
  rules.within = !options.between_parts;
  if (!options.only_between.empty()) rules.rule = GroupRule::only_listed;
  std::vector<std::array<std::size_t, 2>> pairs;
  for (const auto& text : options.only_between.empty() ? options.ignored : options.only_between) {
    for (const auto& pair : pairs_like(topology.parts, text, file, things)) pairs.push_back(pair);
  }
  for (const auto& [a, b] : pairs) {
    rules.pairs.push_back({io::printable(topology.parts[a]), io::printable(topology.parts[b])});
  }
  std::sort(rules.pairs.begin(), rules.pairs.end());
  rules.pairs.erase(std::unique(rules.pairs.begin(), rules.pairs.end()), rules.pairs.end());
  return rules;
}

std::vector<MeshIndex> parts_of_vertices(const frames::Topology& topology, const std::string& file) {
  const auto none = static_cast<MeshIndex>(topology.parts.size());
  std::vector<MeshIndex> parts(topology.vertex_count, none);
  if (!topology.vertex_parts.empty()) parts.assign(topology.vertex_parts.begin(), topology.vertex_parts.end());
  for (std::size_t f = 0; f < topology.face_parts.size(); ++f) {
    for (const MeshIndex corner : topology.faces[f]) {
      MeshIndex& part = parts[corner];
      if (part != none && part != topology.face_parts[f]) {
        io::fail(file, fmt::format("vertex {} is in the parts {} and {}: elements there are of both. Parts that are "
                                   "asked about one by one must not share vertices",
                                   topology.number_of_vertex(corner), io::printable(topology.parts[part]),
                                   io::printable(topology.parts[topology.face_parts[f]])));
      }
      part = topology.face_parts[f];
    }
  }
  return parts;
}

CollisionRules collision_rules(const frames::Topology& topology, const PartRules& rules, const std::string& file) {
  CollisionRules collision;
  if (rules.empty()) return collision;
  const auto none = static_cast<MeshIndex>(topology.parts.size());
  collision.groups = parts_of_vertices(topology, file);
  collision.group_rule = rules.rule;
  std::unordered_multimap<std::string, MeshIndex> numbers;  // of the names as they are shown
  for (MeshIndex part = 0; part < none; ++part) numbers.emplace(io::printable(topology.parts[part]), part);
  for (const auto& [a, b] : rules.pairs) {
    const auto [first_a, last_a] = numbers.equal_range(a);
    const auto [first_b, last_b] = numbers.equal_range(b);
    for (auto one = first_a; one != last_a; ++one) {
      for (auto two = first_b; two != last_b; ++two) collision.group_pairs.push_back({one->second, two->second});
    }
  }
  if (rules.within) return collision;
  for (MeshIndex group = 0; group < none; ++group) collision.group_pairs.push_back({group, group});
  return collision;
}

std::vector<std::string> left_out_by(const PartRules& rules, std::string_view things) {
  std::vector<std::string> texts;
  if (!rules.within) texts.push_back("pairs within one part were left out");
  if (rules.rule == GroupRule::all_but_listed && rules.pairs.empty()) return texts;
  std::string names;
  for (std::size_t i = 0; i < std::min(kShown, rules.pairs.size()); ++i) {
    names += fmt::format("{}{} and {}", i == 0 ? "" : ", ", rules.pairs[i][0], rules.pairs[i][1]);
  }
  if (rules.pairs.size() > kShown)
    names += fmt::format(" and {} more", io::counted(rules.pairs.size() - kShown, "pair"));
  texts.push_back(rules.rule == GroupRule::only_listed
                      ? fmt::format("nothing but these {} was asked about: {}", things, names)
                      : fmt::format("these {} were not asked about: {}", things, names));
  return texts;
}

}  // namespace touchstone::sequence
