// SPDX-License-Identifier: MIT
#include "geometry/kind_aliases.hpp"

#include <string>

namespace touchstone::geometry {

std::optional<Kind> kind_named(std::string_view name) {
  struct Alias {
    std::string_view name;
    Kind kind;
  };
  static constexpr Alias kAliases[] = {{"ee", Kind::edge_edge},
                                       {"segment-segment", Kind::edge_edge},
                                       {"vf", Kind::vertex_face},
                                       {"fv", Kind::vertex_face},
                                       {"vt", Kind::vertex_face},
                                       {"pt", Kind::vertex_face},
                                       {"face-vertex", Kind::vertex_face},
                                       {"vertex-triangle", Kind::vertex_face},
                                       {"point-triangle", Kind::vertex_face},
                                       {"point-face", Kind::vertex_face},
                                       {"pe", Kind::point_edge},
                                       {"ve", Kind::point_edge},
                                       {"ev", Kind::point_edge},
                                       {"edge-vertex", Kind::point_edge},
                                       {"vertex-edge", Kind::point_edge},
                                       {"point-segment", Kind::point_edge},
                                       {"pp", Kind::point_point},
                                       {"vv", Kind::point_point},
                                       {"vertex-vertex", Kind::point_point}};
  std::string lower(name);
  for (char& c : lower) c = c == '_' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (const auto kind = from_name<Kind>(lower)) return kind;
  for (const Alias& alias : kAliases) {
    if (alias.name == lower) return alias.kind;
  }
  return std::nullopt;
}

}  // namespace touchstone::geometry
