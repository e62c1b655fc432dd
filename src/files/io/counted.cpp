// SPDX-License-Identifier: MIT
#include "io/counted.hpp"

#include <cstddef>

namespace touchstone::io {

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, 1, ',');
  return text;
}

std::string counted(std::uint64_t number, std::string_view thing) {
  std::string text = grouped(number) + " ";
  if (number == 1) return text.append(thing);
  if (thing.ends_with('y')) return text.append(thing.substr(0, thing.size() - 1)).append("ies");    // queries
  if (thing.ends_with("ex")) return text.append(thing.substr(0, thing.size() - 2)).append("ices");  // vertices
  if (thing.ends_with("sh")) return text.append(thing).append("es");                                // meshes
  return text.append(thing).append("s");
}

}  // namespace touchstone::io
