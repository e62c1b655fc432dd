// The formats of mesh files, one function each. Each reads content that is in memory and understands it completely, or
// throws a FileError that names the place and what would be right.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "frames/arrays/array.hpp"
#include "frames/content.hpp"
#include "frames/mesh_builder.hpp"

namespace touchstone::frames {

/// @param file         the name of the file, for messages
/// @param content      the bytes of the file
/// @param triangulate  whether polygons of more than three corners are cut into triangles
MeshFile read_obj(std::string_view file, std::string_view content, bool triangulate);
MeshFile read_ply(std::string_view file, std::string_view content, bool triangulate);
MeshFile read_stl(std::string_view file, std::string_view content);
MeshFile read_vtk(std::string_view file, std::string_view content, bool triangulate);
MeshFile read_vtk_xml(std::string_view file, std::string_view content, bool triangulate);
MeshFile read_off(std::string_view file, std::string_view content, bool triangulate);
MeshFile read_msh(std::string_view file, std::string_view content, bool triangulate);
MeshFile read_gltf(std::string_view file, std::string_view content);

/// Calls the function of the format, which is no array.
MeshFile read_mesh(Format format, std::string_view file, std::string_view content, bool triangulate);

/// The topology for an array of positions, from a mesh file or an .npy file of integers.
Topology topology_from(const std::string& file, std::string_view content, const ArrayShape& shape, bool triangulate);

/// The topology for an array of positions without a topology file: loose points.
Topology loose_points(const ArrayShape& shape);

}  // namespace touchstone::frames
