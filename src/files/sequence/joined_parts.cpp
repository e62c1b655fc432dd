// SPDX-License-Identifier: MIT
#include "sequence/joined_parts.hpp"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "io/fail.hpp"
#include "io/sha256.hpp"

namespace touchstone::sequence {
namespace {

/// "wheel" of "car/wheel.stl", or that whole name where two files have one such name.
std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::set<std::string> known;
  bool repeated = false;
  for (const std::string& file : files) {
    names.push_back(std::filesystem::path(file).stem().string());
    repeated = repeated || !known.insert(names.back()).second;
  }
  return repeated ? files : names;
}

}  // namespace

frames::Frame joined_parts(const std::vector<std::string>& files, const std::vector<frames::Frame>& frames) {
  auto scene = std::make_shared<frames::Topology>();
  frames::Frame joined;
  std::string digests;
  scene->parts = names_of(files);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const frames::Topology& mesh = *frames[i].topology;
    if (mesh.dimension != 3) io::fail(files[i], "is a mesh in the plane; the parts of a scene are in space");
    constexpr std::size_t kMost = std::numeric_limits<MeshIndex>::max();
    if (mesh.vertex_count > kMost - scene->vertex_count || mesh.faces.size() > kMost - scene->faces.size()) {
      io::fail(files[i], "makes 2^32 vertices or faces, or more, with the files before it");
    }
    const auto first = static_cast<MeshIndex>(scene->vertex_count);
    const auto part = static_cast<std::uint32_t>(i);
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) scene->vertex_numbers.push_back(mesh.number_of_vertex(v));
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      scene->faces.push_back({a + first, b + first, c + first});
      scene->face_numbers.push_back(mesh.number_of_face(f));
    }
    for (const auto& [a, b] : mesh.edges) scene->edges.push_back({a + first, b + first});
    for (const MeshIndex point : mesh.points) scene->points.push_back(point + first);
    scene->vertex_count += mesh.vertex_count;
    scene->vertex_parts.resize(scene->vertex_count, part);
    scene->face_parts.resize(scene->faces.size(), part);
    scene->joined_vertices += mesh.joined_vertices;
    scene->welded_vertices += mesh.welded_vertices;
    scene->dropped_elements += mesh.dropped_elements;
    scene->animations += mesh.animations;
    scene->unshown_meshes += mesh.unshown_meshes;
    scene->moved_vertices += mesh.moved_vertices;
    joined.positions.insert(joined.positions.end(), frames[i].positions.begin(), frames[i].positions.end());
    digests += frames[i].digest;
  }
  joined.topology = std::move(scene);
  joined.digest = io::sha256(digests);
  return joined;
}

}  // namespace touchstone::sequence
