// SPDX-License-Identifier: MIT
#include "sequence/element_names.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/kind_traits.hpp"
#include "geometry/union_find.hpp"
#include "io/fail.hpp"
#include "io/sha256.hpp"
#include "mesh/inside_surfaces/pieces.hpp"

namespace touchstone::sequence {
namespace {

void append_number(std::string& bytes, std::uint64_t number) {
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(number >> shift & 0xFF);
}

template <class Elements>
void append_elements(std::string& bytes, const Elements& elements) {
  append_number(bytes, elements.size());
  for (const auto& corners : elements) {
    for (const MeshIndex corner : corners) {
      for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(corner >> shift & 0xFF);
    }
  }
}

/// How many edges each vertex is in.
std::vector<std::size_t> degrees_of(const Mesh& mesh) {
  std::vector<std::size_t> degrees(mesh.vertex_count(), 0);
  for (const auto& edge : mesh.edges()) {
    for (const MeshIndex corner : edge) ++degrees[corner];
  }
  return degrees;
}

/// The connected sets of edges with a closed polygon; 0 where there is nothing beside one such set.
std::size_t closed_polygons(const Mesh& mesh, const std::vector<std::size_t>& degrees) {
  geometry::UnionFind sets(degrees.size());
  std::vector<MeshIndex> closing;  // an end of each edge whose ends others connect
  for (const auto& [a, b] : mesh.edges()) {
    if (!sets.join(a, b)) closing.push_back(a);
  }
  std::vector<char> is_closed(degrees.size(), 0);
  for (const MeshIndex a : closing) is_closed[sets.root(a)] = 1;
  std::size_t closed = 0, all = mesh.points().size();
  for (MeshIndex v = 0; v < degrees.size(); ++v) {
    if (degrees[v] == 0 || sets.root(v) != v) continue;
    ++all;
    closed += is_closed[v] != 0 ? 1 : 0;
  }
  return all > 1 ? closed : 0;
}

}  // namespace

std::string shown_part(const std::string& name) {
  constexpr std::size_t kLongest = 100;
  return io::printable(name.size() > kLongest ? name.substr(0, kLongest) + "..." : name);
}

std::optional<MeshIndex> vertex_named(const frames::Topology& topology, const NamedElement& element,
                                      std::size_t corner) {
  const std::uint64_t number = element.vertices[corner];
  std::uint64_t first = 0, last = topology.vertex_count, first_number = topology.first_number;
  if (!topology.vertex_parts.empty()) {
    const auto found = std::find_if(topology.parts.begin(), topology.parts.end(),
                                    [&](const std::string& name) { return shown_part(name) == element.part; });
    const auto [begin, end] = std::equal_range(topology.vertex_parts.begin(), topology.vertex_parts.end(),
                                               static_cast<std::uint32_t>(found - topology.parts.begin()));
    first = static_cast<std::uint64_t>(begin - topology.vertex_parts.begin());
    last = static_cast<std::uint64_t>(end - topology.vertex_parts.begin());
    if (first < last) first_number = topology.vertex_numbers[first];
  }
  if (number < first_number || number - first_number >= last - first) return std::nullopt;
  return static_cast<MeshIndex>(first + number - first_number);
}

NamedElement ElementNames::vertex(MeshIndex v) {
  NamedElement named;
  named.element = MeshElement::vertex;
  named.vertices[0] = topology_.number_of_vertex(v);
  named.part = part_with(&v, 1);
  return named;
}

NamedElement ElementNames::edge(MeshIndex e) {
  NamedElement named;
  named.element = MeshElement::edge;
  const auto& corners = mesh_.edges()[e];
  for (std::size_t i = 0; i < 2; ++i) named.vertices[i] = topology_.number_of_vertex(corners[i]);
  named.part = part_with(corners.data(), corners.size());
  return named;
}

NamedElement ElementNames::face(MeshIndex f) {
  NamedElement named;
  named.element = MeshElement::face;
  const auto& corners = mesh_.faces()[f];
  for (std::size_t i = 0; i < 3; ++i) named.vertices[i] = topology_.number_of_vertex(corners[i]);
  named.face = topology_.number_of_face(f);
  named.part = part_of_face(f);
  return named;
}

NamedElement ElementNames::element(MeshElement sort, MeshIndex number) {
  switch (sort) {
    case MeshElement::vertex: return vertex(number);
    case MeshElement::edge: return edge(number);
    case MeshElement::face: return face(number);
  }
  return {};
}

NamedElement ElementNames::first_of(const MeshPair& pair) {
  return element(geometry::traits_of(pair.kind).first.sort, pair.first);
}

NamedElement ElementNames::second_of(const MeshPair& pair) {
  return element(geometry::traits_of(pair.kind).second.sort, pair.second);
}

std::string ElementNames::part_of_face(MeshIndex f) const {
  return topology_.face_parts.empty() ? std::string() : shown_part(topology_.parts[topology_.face_parts[f]]);
}

std::string ElementNames::part_with(const MeshIndex* corners, std::size_t count) {
  if (!topology_.vertex_parts.empty()) return shown_part(topology_.parts[topology_.vertex_parts[corners[0]]]);
  if (topology_.face_parts.empty()) return {};
  find_faces_of_vertices();
  for (std::size_t i = first_face_[corners[0]]; i < first_face_[corners[0] + std::size_t{1}]; ++i) {
    const auto& face = mesh_.faces()[face_[i]];
    const bool has_all = std::all_of(corners, corners + count, [&](MeshIndex corner) {
      return std::find(face.begin(), face.end(), corner) != face.end();
    });
    if (has_all) return part_of_face(face_[i]);
  }
  return {};
}

void ElementNames::find_faces_of_vertices() {
  if (!first_face_.empty()) return;
  first_face_.assign(mesh_.vertex_count() + 1, 0);
  for (const auto& face : mesh_.faces()) {
    for (const MeshIndex corner : face) ++first_face_[corner + std::size_t{1}];
  }
  for (std::size_t v = 1; v < first_face_.size(); ++v) first_face_[v] += first_face_[v - 1];
  face_.resize(first_face_.back());
  std::vector<std::size_t> next = first_face_;
  for (std::size_t f = 0; f < mesh_.faces().size(); ++f) {
    for (const MeshIndex corner : mesh_.faces()[f]) face_[next[corner]++] = static_cast<MeshIndex>(f);
  }
}

MeshFacts facts_of(const Mesh& mesh, const frames::Topology& topology) {
  std::string bytes;
  bytes.reserve(12 * topology.faces.size() + 8 * topology.edges.size() + 64);
  append_number(bytes, static_cast<std::uint64_t>(topology.dimension));
  append_number(bytes, topology.vertex_count);
  append_elements(bytes, topology.faces);
  append_elements(bytes, topology.edges);
  append_number(bytes, mesh.points().size());
  for (const MeshIndex point : mesh.points()) append_number(bytes, point);
  MeshFacts facts{io::sha256(bytes),   mesh.dimension(),    mesh.vertex_count(),
                  mesh.faces().size(), mesh.edges().size(), mesh.points().size()};
  // A vertex and a face or, in the plane, a vertex and an edge; in space two edges, which share one vertex at most.
  facts.neighbours = mesh.dimension() == 2 ? 2 * facts.edges : 3 * facts.faces;
  std::size_t in_edges = 0;
  const std::vector<std::size_t> degrees = degrees_of(mesh);
  for (const std::size_t degree : degrees) {
    in_edges += degree > 0 ? 1 : 0;
    if (mesh.dimension() == 3 && degree > 1) facts.neighbours += degree * (degree - 1) / 2;
  }
  facts.welded = topology.welded_vertices;
  facts.dropped = topology.dropped_elements;
  facts.animations = topology.animations;
  facts.unshown = topology.unshown_meshes;
  facts.moved = topology.moved_vertices;
  facts.idle = facts.vertices - in_edges - facts.points - facts.welded;
  if (mesh.dimension() == 2) facts.polygons = closed_polygons(mesh, degrees);
  facts.branching = mesh::Pieces(mesh.impl(), mesh::Motion(facts.vertices)).branching();
  facts.joined = topology.joined_vertices;
  return facts;
}

}  // namespace touchstone::sequence
