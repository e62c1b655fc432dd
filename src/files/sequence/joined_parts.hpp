// One scene of several files.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "frames/frame.hpp"

namespace touchstone::sequence {

/// The meshes side by side. Each is a part, with the name of its file; vertices and faces keep the numbers of theirs.
/// @param files   their names: at least one. Those that end alike are shown with folders
/// @param frames  of each file, in space
/// @throws FileError  for a mesh in the plane, and more than 2^32 vertices or faces
frames::Frame joined_parts(const std::vector<std::string>& files, const std::vector<frames::Frame>& frames);

}  // namespace touchstone::sequence
