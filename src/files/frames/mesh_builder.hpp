// Collects the mesh of a file: polygons become triangles, and names become numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "frames/frame.hpp"

namespace touchstone::frames {

/// The mesh of a file.
struct MeshFile {
  Topology topology;
  std::vector<double> positions;
  std::string beside = {};  ///< the digests of other files that it is made of
};

/// Where a fault is.
struct FilePosition {
  std::string_view file;
  std::uint64_t line = 0;  ///< 0 in a binary file

  /// @throws FileError "FILE: reason" or "FILE:LINE: reason"
  [[noreturn]] void fail(std::string_view reason) const;
};

class MeshBuilder {
 public:
  /// @param first_number  the number of the file's first polygon
  MeshBuilder(bool triangulate, MeshIndex first_number) : triangulate_(triangulate) {
    mesh_.topology.first_number = first_number;
  }

  /// Before the first face.
  void set_first_number(MeshIndex first_number) noexcept { mesh_.topology.first_number = first_number; }

  std::vector<double>& positions() noexcept { return mesh_.positions; }
  std::size_t vertex_count() const noexcept { return mesh_.positions.size() / 3; }
  void add_vertex(double x, double y, double z) { mesh_.positions.insert(mesh_.positions.end(), {x, y, z}); }

  /// Adds a polygon. The caller has checked that its corners exist.
  /// @param number  its number in the file
  /// @throws FileError  for fewer than three corners, and for more than three unless they are triangulated
  void add_polygon(std::span<const MeshIndex> corners, std::uint64_t number, const FilePosition& position) {
    if (corners.size() != 3) {
      add_unusual_polygon(corners, number, position);
    } else {
      add_face({corners[0], corners[1], corners[2]}, number);
    }
  }
  /// Adds the triangles of a strip, all with its number.
  void add_strip(std::span<const MeshIndex> corners, std::uint64_t number, const FilePosition& position);
  void add_edge(MeshIndex a, MeshIndex b) { mesh_.topology.edges.push_back({a, b}); }
  void add_polyline(std::span<const MeshIndex> vertices, const FilePosition& position);
  /// Of all tetrahedra the faces that are in one of them are kept, unless the file has them as triangles. Seen
  /// from the fourth corner, the first three turn to the left.
  void add_tetrahedron(const std::array<MeshIndex, 4>& corners, std::uint64_t number) {
    tetrahedra_.push_back({corners, number});
  }
  void add_point(MeshIndex vertex) { mesh_.topology.points.push_back(vertex); }
  void reserve_faces(std::size_t count) { mesh_.topology.faces.reserve(count); }

  /// The faces that follow are a part of this name. Before the first call they have none.
  void set_part(std::string name) {
    part_name_ = std::move(name);
    part_is_new_ = true;
  }

  /// @throws FileError  without a vertex, for 2^32 vertices or polygons and more, and for a face of three tetrahedra
  MeshFile finish(const FilePosition& position);

 private:
  void add_face(const std::array<MeshIndex, 3>& corners, std::uint64_t number) {
    Topology& topology = mesh_.topology;
    if (part_is_new_) find_part();
    if (has_numbers_ || number != topology.first_number + topology.faces.size()) add_number(number);
    topology.faces.push_back(corners);
    if (!topology.parts.empty()) topology.face_parts.push_back(part_);
  }
  void add_unusual_polygon(std::span<const MeshIndex> corners, std::uint64_t number, const FilePosition& position);
  void add_number(std::uint64_t number);
  void find_part();
  void add_surface_of_tetrahedra(const FilePosition& position);
  std::uint32_t index_of_part(const std::string& name);

  struct Tetrahedron {
    std::array<MeshIndex, 4> corners;
    std::uint64_t number;
  };

  MeshFile mesh_;
  std::vector<Tetrahedron> tetrahedra_;
  bool triangulate_;
  bool has_numbers_ = false;
  std::uint64_t greatest_number_ = 0;
  std::string part_name_;
  bool part_is_new_ = false;
  std::uint32_t part_ = 0;
  std::unordered_map<std::string, std::uint32_t> part_numbers_;
};

/// Calls `add(a, b, c)` for the triangles of a strip: every second one is turned, so that all have one orientation.
template <class Add>
void for_each_of_strip(std::span<const MeshIndex> corners, Add add) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    add(corners[i - 2], corners[i - 1 + i % 2], corners[i - i % 2]);
  }
}

/// "vertex 7 does not exist: the file has the vertices 0 to 4", with numbers as the file has them.
std::string fault_of_index(std::int64_t index, std::size_t vertex_count, std::int64_t first_number);

/// The vertex of this number, counted from 0. @throws FileError  if there is none
inline MeshIndex checked_vertex(std::int64_t index, std::size_t vertex_count, const FilePosition& position) {
  if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count) {
    position.fail(fault_of_index(index, vertex_count, 0));
  }
  return static_cast<MeshIndex>(index);
}

}  // namespace touchstone::frames
