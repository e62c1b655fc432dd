// The elements of a mesh as its file counts and names them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/mesh.hpp>

#include "frames/frame.hpp"
#include "sequence/results.hpp"

namespace touchstone::sequence {

/// The name of a part as results have it: one line, and cut, because a report with many pairs repeats it many times.
std::string shown_part(const std::string& name);

/// The vertex that a result names, perhaps one of an earlier run; nothing where the mesh has no such vertex.
/// @param topology  that of a file, or of a scene: each part's vertices follow one another, and so do their numbers
std::optional<MeshIndex> vertex_named(const frames::Topology& topology, const NamedElement& element,
                                      std::size_t corner);

class ElementNames {
 public:
  /// @param mesh      the mesh of this topology; both must outlive the object
  /// @param topology  how the file counts and names
  ElementNames(const Mesh& mesh, const frames::Topology& topology) : mesh_(mesh), topology_(topology) {}

  NamedElement vertex(MeshIndex v);
  NamedElement edge(MeshIndex e);
  NamedElement face(MeshIndex f);
  NamedElement element(MeshElement sort, MeshIndex number);

  /// Both elements of a pair.
  NamedElement first_of(const MeshPair& pair);
  NamedElement second_of(const MeshPair& pair);

 private:
  std::string part_of_face(MeshIndex f) const;
  /// The part of the first face that has all these corners.
  std::string part_with(const MeshIndex* corners, std::size_t count);
  void find_faces_of_vertices();

  const Mesh& mesh_;
  const frames::Topology& topology_;
  // The faces of vertex v are face_[first_face_[v]] to face_[first_face_[v + 1] - 1], in ascending order. Both are made
  // when a name is first asked for: most steps are free, and name nothing.
  std::vector<std::size_t> first_face_;
  std::vector<MeshIndex> face_;
};

/// The digest of what a mesh is made of, without numbers and names in a file.
MeshFacts facts_of(const Mesh& mesh, const frames::Topology& topology);

}  // namespace touchstone::sequence
