// The bytes of a file, and what its name says about them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/whole_file.hpp"

namespace touchstone::frames {

/// Of a mesh file or a topology file. An OBJ file of 64 GiB has about a billion faces; a line of 64 MiB would be a
/// polygon of millions of corners.
inline constexpr io::FileLimits kMeshLimits{std::uint64_t{1} << 36, std::uint64_t{1} << 30, std::uint64_t{1} << 26};

/// Where nodes show one mesh, or values are compressed, a short file may stand for any number of vertices and corners.
/// It may have so many if it has so many bytes.
constexpr std::size_t most_items(std::size_t bytes) noexcept { return (std::size_t{1} << 22) + 16 * bytes; }

/// Reads a file, pipe or device whose name tells its format until its end.
/// @throws FileError  where it cannot be read, and where it exceeds kMeshLimits; other formats than OBJ have no limit
///                    of the length of a line
io::WholeFile read_content(const std::string& file, io::InputFile::Checkpoint checkpoint);

/// The files that a mesh file names and is made of: the buffers of glTF. Empty where the file cannot be read.
std::vector<std::string> files_beside(const std::string& file);

enum class Format : std::uint8_t { obj, ply, stl, vtk, vtk_xml, off, msh, gltf, npy, hdf5, pc2, mdd };

/// The format that the ending of the name says, in upper or lower case; nothing for other endings.
std::optional<Format> known_format_of(const std::string& file);

/// Whether the name says that the file is text with a row for each vertex: .csv and .txt. Other files beside frames
/// have such names, too, so that these are no endings of frames.
bool has_text_rows(const std::string& file);

/// What is wrong with a mesh file of another format that people have, .fbx or .step, say, and how it becomes one that
/// is read; empty for every other ending.
std::string fault_of_unread_format(const std::string& file);

/// The same as known_format_of(). @throws FileError  for other endings, and where there is no file
Format format_of(const std::string& file);

}  // namespace touchstone::frames
