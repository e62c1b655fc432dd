// One frame of an animation: the mesh of a file and the positions of its vertices.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <touchstone/mesh.hpp>

#include "io/input_file.hpp"

namespace touchstone::frames {

/// The elements of a mesh, and how the file counts and names them.
struct Topology {
  std::size_t vertex_count = 0;  ///< the number of vertices
  int dimension = 3;             ///< 2 or 3 coordinates a vertex

  std::vector<std::array<MeshIndex, 3>> faces;  ///< triangles, by the numbers of their corners from 0
  std::vector<std::array<MeshIndex, 2>> edges;  ///< the edges that the file gives; those of the faces need not be here
  /// The points that the file gives. In a file without faces, edges and points, they are all vertices.
  std::vector<MeshIndex> points;

  MeshIndex first_number = 0;  ///< the number of the file's first vertex and first face: 1 in OBJ, else 0

  /// The number in the file of the polygon that each face is a part of; empty when face i has the number
  /// first_number + i.
  std::vector<MeshIndex> face_numbers;

  /// The number in its file of each vertex; empty when vertex i has the number first_number + i. Then vertex_parts says
  /// which file that is.
  std::vector<MeshIndex> vertex_numbers;
  std::vector<std::uint32_t> vertex_parts;  ///< for each vertex, an index into parts; empty without such numbers

  MeshIndex number_of_vertex(std::size_t v) const noexcept {
    return vertex_numbers.empty() ? first_number + static_cast<MeshIndex>(v) : vertex_numbers[v];
  }
  MeshIndex number_of_face(std::size_t f) const noexcept {
    return face_numbers.empty() ? first_number + static_cast<MeshIndex>(f) : face_numbers[f];
  }

  std::vector<std::string> parts;         ///< the names of objects and groups, each once
  std::vector<std::uint32_t> face_parts;  ///< for each face, an index into parts; empty without names

  std::size_t joined_vertices = 0;  ///< the vertices that the reader, and not the file, gives to several parts

  std::size_t welded_vertices = 0;   ///< those that elements of the file name, and others stand for (sequence::Repairs)
  std::size_t dropped_elements = 0;  ///< the faces and edges of the file that were left out

  // Of glTF files:
  std::size_t animations = 0;      ///< those of the file, which are not read
  std::size_t unshown_meshes = 0;  ///< nodes with meshes that are not in the scene, and not read
  std::size_t moved_vertices = 0;  ///< those that nodes move from where the file has them, and that are rounded

  bool operator==(const Topology& other) const = default;
};

/// One frame.
struct Frame {
  std::shared_ptr<const Topology> topology;  ///< never null
  std::vector<double> positions;             ///< topology->dimension coordinates a vertex: x y z x y z ...
  /// 64 hexadecimal digits: the SHA-256 digest of the bytes that the frame was read from. For a frame of an array it is
  /// that of its dimension, its coordinates as doubles and the topology file's digest: the same in .npy and HDF5.
  std::string digest;
};

/// How files are read.
struct ReadOptions {
  std::string
      topology_file;    ///< for files that hold positions only: a mesh file, or an .npy of integers (n, 3) or (n, 2)
  std::string dataset;  ///< the name of the data set in an HDF5 file; empty: the only one that fits
  bool triangulate = false;  ///< cut polygons of more than three corners into triangles that share the first corner
  io::InputFile::Checkpoint checkpoint = nullptr;  ///< called before every read; throws to give up
};

/// The number of frames in a file: 1, or n for an array of shape (n, vertices, 2 or 3).
/// @throws FileError  "FILE: reason" or "FILE:LINE: reason"
std::size_t frame_count(const std::string& file, const ReadOptions& options);

/// Reads a text file with a row x,y,z for each vertex, whatever its name is: decimals, rounded to the nearest
/// doubles, or hexfloats, with separators as in io/separators.hpp. A first line may name the columns.
/// @throws FileError
Frame read_text_frame(const std::string& file, const ReadOptions& options);

/// Reads a frame. Several threads may read at the same time. The name's ending says the format: .obj, .ply, .stl, .vtk,
/// .vtu, .vtp, .off, .msh, .gltf, .glb, .npy, .h5, .hdf5, .pc2 and .mdd.
/// @param file     the file
/// @param index    which frame of it, below frame_count
/// @param options  how it is read
/// @param earlier  the topology of an earlier frame, or null; the result shares it if it is equal
/// @throws FileError  for anything that the reader does not understand completely; the message says what would be right
Frame read_frame(const std::string& file, std::size_t index, const ReadOptions& options,
                 const std::shared_ptr<const Topology>& earlier = nullptr);

}  // namespace touchstone::frames
