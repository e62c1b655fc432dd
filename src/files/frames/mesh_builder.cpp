// SPDX-License-Identifier: MIT
#include "frames/mesh_builder.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

#include "io/fail.hpp"

namespace touchstone::frames {

void FilePosition::fail(std::string_view reason) const {
  if (line == 0) io::fail(file, reason);
  io::fail(file, line, reason);
}

void MeshBuilder::add_unusual_polygon(std::span<const MeshIndex> corners, std::uint64_t number,
                                      const FilePosition& position) {
  const std::string count = "face " + std::to_string(number) + " has " + std::to_string(corners.size()) +
                            (corners.size() == 1 ? " corner" : " corners");
  if (corners.size() < 3) position.fail(count + "; a face has three");
  if (!triangulate_) position.fail(count + "; a face has three, and --triangulate cuts larger ones into triangles");
  for (std::size_t i = 2; i < corners.size(); ++i) add_face({corners[0], corners[i - 1], corners[i]}, number);
}

void MeshBuilder::add_strip(std::span<const MeshIndex> corners, std::uint64_t number, const FilePosition& position) {
  if (corners.size() < 3) {
    position.fail("strip " + std::to_string(number) + " has " + std::to_string(corners.size()) +
                  " corners; a strip of triangles has three or more");
  }
  for_each_of_strip(corners, [&](MeshIndex a, MeshIndex b, MeshIndex c) { add_face({a, b, c}, number); });
}

void MeshBuilder::add_polyline(std::span<const MeshIndex> vertices, const FilePosition& position) {
  if (vertices.size() < 2) position.fail("a line has two vertices or more");
  for (std::size_t i = 1; i < vertices.size(); ++i) add_edge(vertices[i - 1], vertices[i]);
}

void MeshBuilder::add_number(std::uint64_t number) {
  Topology& topology = mesh_.topology;
  if (!has_numbers_) {
    topology.face_numbers.resize(topology.faces.size());
    std::iota(topology.face_numbers.begin(), topology.face_numbers.end(), topology.first_number);
    has_numbers_ = true;
  }
  topology.face_numbers.push_back(static_cast<MeshIndex>(number));
  greatest_number_ = std::max(greatest_number_, number);
}

void MeshBuilder::find_part() {
  Topology& topology = mesh_.topology;
  part_is_new_ = false;
  if (topology.parts.empty()) {
    if (part_name_.empty()) return;
    if (!topology.faces.empty()) {
      index_of_part({});
      topology.face_parts.resize(topology.faces.size());
    }
  }
  part_ = index_of_part(part_name_);
}

std::uint32_t MeshBuilder::index_of_part(const std::string& name) {
  Topology& topology = mesh_.topology;
  const auto [found, is_new] = part_numbers_.try_emplace(name, static_cast<std::uint32_t>(topology.parts.size()));
  if (is_new) topology.parts.push_back(name);
  return found->second;
}

void MeshBuilder::add_surface_of_tetrahedra(const FilePosition& position) {
  struct Side {
    std::array<MeshIndex, 3> sorted, corners;
    std::uint64_t number;
    bool operator<(const Side& other) const { return std::tie(sorted, number) < std::tie(other.sorted, other.number); }
  };
  const auto sorted = [](std::array<MeshIndex, 3> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<Side> sides;
  sides.reserve(4 * tetrahedra_.size());
  for (const auto& [c, number] : tetrahedra_) {
    for (const std::array<MeshIndex, 3>& side :
         {std::array{c[0], c[2], c[1]}, {c[0], c[1], c[3]}, {c[1], c[2], c[3]}, {c[2], c[0], c[3]}}) {
      sides.push_back({sorted(side), side, number});
    }
  }
  std::vector<std::array<MeshIndex, 3>> given;
  for (const auto& face : mesh_.topology.faces) given.push_back(sorted(face));
  std::sort(given.begin(), given.end());
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next].sorted == sides[i].sorted) ++next;
    if (next - i > 2) {
      const auto& [a, b, c] = sides[i].sorted;
      position.fail("tetrahedra " + std::to_string(sides[i].number) + ", " + std::to_string(sides[i + 1].number) +
                    " and " + std::to_string(sides[i + 2].number) + " share the face of the vertices " +
                    std::to_string(a + mesh_.topology.first_number) + ", " +
                    std::to_string(b + mesh_.topology.first_number) + " and " +
                    std::to_string(c + mesh_.topology.first_number) + "; at most two can");
    }
    const bool is_given = std::binary_search(given.begin(), given.end(), sides[i].sorted);
    if (next - i == 1 && !is_given) add_face(sides[i].corners, sides[i].number);
  }
}

MeshFile MeshBuilder::finish(const FilePosition& position) {
  if (!tetrahedra_.empty()) add_surface_of_tetrahedra(position);
  Topology& topology = mesh_.topology;
  topology.vertex_count = vertex_count();
  if (topology.vertex_count == 0) position.fail("has no vertex");
  constexpr std::uint64_t kMost = std::numeric_limits<MeshIndex>::max();
  if (topology.vertex_count > kMost || topology.faces.size() > kMost || greatest_number_ > kMost) {
    position.fail("has 2^32 vertices or faces, or more");
  }
  if (topology.faces.empty() && topology.edges.empty() && topology.points.empty()) {
    topology.points.resize(topology.vertex_count);
    std::iota(topology.points.begin(), topology.points.end(), MeshIndex{0});
  }
  return std::move(mesh_);
}

std::string fault_of_index(std::int64_t index, std::size_t vertex_count, std::int64_t first_number) {
  std::string fault = "vertex " + std::to_string(index) + " does not exist: ";
  if (vertex_count == 0) return fault + "the file has no vertex";
  return fault + "the vertices have the numbers " + std::to_string(first_number) + " to " +
         std::to_string(first_number + static_cast<std::int64_t>(vertex_count) - 1);
}

}  // namespace touchstone::frames
