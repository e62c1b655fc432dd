// SPDX-License-Identifier: MIT
#include "frames/mesh_builder.hpp"

#include <limits>
#include <numeric>

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
  greatest_number_ = number;
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

MeshFile MeshBuilder::finish(const FilePosition& position) {
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
