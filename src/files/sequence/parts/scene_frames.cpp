// SPDX-License-Identifier: MIT
#include "sequence/parts/scene_frames.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "io/fail.hpp"
#include "io/sha256.hpp"
#include "sequence/checks.hpp"

namespace touchstone::sequence {

SceneFrames::SceneFrames(std::vector<ScenePart> parts, const frames::ReadOptions& reading, const RepairOptions& repairs)
    : reading_(reading) {
  RepairOptions of_part = repairs;
  of_part.is_one_part = true;
  for (ScenePart& part : parts) sources_.push_back({std::move(part), {of_part, false}, {}, {}});
}

frames::Frame SceneFrames::read(std::size_t index) {
  frames::Frame scene;
  std::string digests;
  for (Source& source : sources_) {
    if (source.frame.topology == nullptr || !source.part.is_at_rest()) read_part(source, source.part.at(index));
    const std::vector<double>& positions = source.frame.positions;
    scene.positions.insert(scene.positions.end(), positions.begin(), positions.end());
    digests += source.frame.digest + " " + source.part.name + "\n";
  }
  if (topology_ == nullptr) topology_ = topology();
  scene.topology = topology_;
  scene.digest = io::sha256(digests);
  return scene;
}

void SceneFrames::read_part(Source& source, const FrameName& name) {
  const auto earlier = source.frame.topology;
  frames::Frame frame = frames::read_frame(name.file, name.index, reading_, earlier);
  if (frame.topology->dimension != 3) io::fail(name.file, "is a mesh in the plane; the parts of a scene are in space");
  source.repairs.mend(frame, name);
  check_positions(frame, name);
  if (earlier == nullptr) {
    mesh_of(*frame.topology, {}, name.file);  // its faults are those of this file
    source.first = name;
  } else {
    check_same_elements(*earlier, source.first, *frame.topology, name);
    frame.topology = earlier;
  }
  source.frame = std::move(frame);
}

std::shared_ptr<const frames::Topology> SceneFrames::topology() const {
  auto scene = std::make_shared<frames::Topology>();
  for (const Source& source : sources_) {
    const frames::Topology& mesh = *source.frame.topology;
    constexpr std::size_t kMost = std::numeric_limits<MeshIndex>::max();
    if (mesh.vertex_count > kMost - scene->vertex_count || mesh.faces.size() > kMost - scene->faces.size()) {
      io::fail(source.first.file, "makes 2^32 vertices or faces, or more, with the files before it");
    }
    const auto first = static_cast<MeshIndex>(scene->vertex_count);
    const auto part = static_cast<std::uint32_t>(scene->parts.size());
    scene->parts.push_back(source.part.name);
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) scene->vertex_numbers.push_back(mesh.number_of_vertex(v));
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      scene->faces.push_back({a + first, b + first, c + first});
      scene->face_numbers.push_back(mesh.number_of_face(f));
    }
    for (const auto& [a, b] : mesh.edges) scene->edges.push_back({a + first, b + first});
    for (const MeshIndex point : loose_points(mesh)) scene->points.push_back(point + first);
    scene->vertex_count += mesh.vertex_count;
    scene->vertex_parts.resize(scene->vertex_count, part);
    scene->face_parts.resize(scene->faces.size(), part);
    scene->joined_vertices += mesh.joined_vertices;
    scene->welded_vertices += mesh.welded_vertices;
    scene->dropped_elements += mesh.dropped_elements;
    scene->animations += mesh.animations;
    scene->unshown_meshes += mesh.unshown_meshes;
    scene->moved_vertices += mesh.moved_vertices;
  }
  return scene;
}

}  // namespace touchstone::sequence
