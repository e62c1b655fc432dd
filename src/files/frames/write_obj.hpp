// Writes a frame as an OBJ file.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "frames/frame.hpp"

namespace touchstone::frames {

/// Appends the mesh as the text of an OBJ file, the same on every machine. Every coordinate is the shortest decimal
/// that reads back as the same double; a mesh in the plane gets z = 0. The parts of the faces become groups (`g`), the
/// edges lines (`l`) and the loose points points (`p`). Control characters and backslashes in names become '_'.
/// @param to         the text to append to
/// @param topology   the elements; its first_number and face_numbers do not matter
/// @param positions  topology.dimension finite coordinates for each vertex
void append_obj(std::string& to, const Topology& topology, const double* positions);

}  // namespace touchstone::frames
