// Faults of a file's faces and edges, in the file's own numbers, with what mends them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "frames/frame.hpp"

namespace touchstone::sequence {

/// "1 2 3": vertices as the file counts them.
template <std::size_t N>
std::string corners_text(const frames::Topology& topology, const std::array<MeshIndex, N>& corners) {
  std::string text;
  for (const MeshIndex corner : corners) {
    if (!text.empty()) text += ' ';
    text += std::to_string(topology.number_of_vertex(corner));
  }
  return text;
}

/// @throws FileError  for the first fault of the faces and edges that Mesh would find
void check_elements(const frames::Topology& topology, const std::string& file);

}  // namespace touchstone::sequence
