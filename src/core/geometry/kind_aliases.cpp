// SPDX-License-Identifier: MIT
#include "geometry/kind_aliases.hpp"

#include <string>

#include <touchstone/error.hpp>

namespace touchstone::geometry {
namespace {

/// @param name  in lower case, with '-' between words
std::optional<Kind> kind_of_alias(std::string_view name) {
  struct Alias {
    std::string_view name;
    Kind kind;
  };
  static constexpr Alias kAliases[] = {{"ee", Kind::edge_edge},
                                       {"segment-segment", Kind::edge_edge},
                                       {"vf", Kind::vertex_face},
                                       {"vt", Kind::vertex_face},
                                       {"pt", Kind::vertex_face},
                                       {"pf", Kind::vertex_face},
                                       {"vertex-triangle", Kind::vertex_face},
                                       {"point-triangle", Kind::vertex_face},
                                       {"point-face", Kind::vertex_face},
                                       {"pe", Kind::point_edge},
                                       {"ve", Kind::point_edge},
                                       {"vertex-edge", Kind::point_edge},
                                       {"vertex-segment", Kind::point_edge},
                                       {"point-segment", Kind::point_edge},
                                       {"pp", Kind::point_point},
                                       {"vv", Kind::point_point},
                                       {"vertex-vertex", Kind::point_point}};
  if (const auto kind = from_name<Kind>(name)) return kind;
  for (const Alias& alias : kAliases) {
    if (alias.name == name) return alias.kind;
  }
  return std::nullopt;
}

/// "vertex-face" of "face-vertex", and "vf" of "fv".
std::string with_swapped_elements(const std::string& name) {
  const std::size_t dash = name.find('-');
  if (dash != std::string::npos) return name.substr(dash + 1) + '-' + name.substr(0, dash);
  return std::string(name.rbegin(), name.rend());
}

}  // namespace

std::optional<Kind> kind_named(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c == '_' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (const auto kind = kind_of_alias(lower)) return kind;
  const auto swapped = kind_of_alias(with_swapped_elements(lower));
  if (!swapped) return std::nullopt;
  const std::string right(name_of(*swapped));
  std::string corners;
  for (std::size_t i = 0; i < corner_count(*swapped); ++i) corners.append(" ").append(corner_name(*swapped, i));
  throw InvalidQuery("the kind " + lower + " is called " + right + ", and its corners come in the order" + corners +
                     "; with the corners so, say " + right);
}

}  // namespace touchstone::geometry
