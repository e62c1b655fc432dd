// SPDX-License-Identifier: MIT
#include "sequence/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <touchstone/closest_approach.hpp>
#include <touchstone/error.hpp>

#include "io/fail.hpp"
#include "mesh/coinciding.hpp"
#include "mesh/inside_surfaces/inside.hpp"
#include "sequence/element_faults.hpp"
#include "sequence/element_names.hpp"
#include "sequence/parts/own_neighbours.hpp"

namespace touchstone::sequence {
namespace {

using frames::Frame;
using frames::Topology;

Positions positions_of(const Frame& frame) { return {frame.positions, frame.topology->dimension}; }

[[noreturn]] void refuse_change(const FrameName& before, const FrameName& after, const std::string& what) {
  io::fail(after.file,
           fmt::format("{} differs from {}: {}; all frames of a sequence must have the same vertices and "
                       "elements. --parts asks about the parts of one scene, and --check --in-order about each "
                       "file by itself",
                       after.label(), before.label(), what));
}

void check_same_count(std::size_t before, std::size_t after, const char* things, const FrameName& name_before,
                      const FrameName& name_after) {
  if (before == after) return;
  refuse_change(name_before, name_after, fmt::format("{} {}, not {}", after, things, before));
}

template <std::size_t N>
void check_same(const Topology& before, const std::vector<std::array<MeshIndex, N>>& old_elements,
                const Topology& after, const std::vector<std::array<MeshIndex, N>>& new_elements, const char* sort,
                const FrameName& name_before, const FrameName& name_after) {
  for (std::size_t i = 0; i < old_elements.size(); ++i) {
    if (old_elements[i] == new_elements[i]) continue;
    const std::uint64_t number = N == 3 ? after.number_of_face(i) : after.number_of_vertex(i);
    refuse_change(name_before, name_after,
                  fmt::format("{} {} has the vertices {}, not {}", sort, number, corners_text(after, new_elements[i]),
                              corners_text(before, old_elements[i])));
  }
}

PairContact named(const MeshContact& contact, ElementNames& names) {
  const Answer& answer = contact.answer;
  return {contact.pair.kind,
          names.first_of(contact.pair),
          names.second_of(contact.pair),
          answer.nature,
          answer.feature_a,
          answer.feature_b,
          answer.trend};
}

std::vector<RestContact> named(const std::vector<Intersection>& found, ElementNames& names) {
  std::vector<RestContact> contacts;
  contacts.reserve(found.size());
  for (const Intersection& one : found) {
    contacts.push_back(
        {names.element(one.first_element, one.first), names.element(one.second_element, one.second), one.sort});
  }
  return contacts;
}

Clearance clearance_of(const ClosestApproach& approach, ElementNames& names) {
  Clearance clearance;
  clearance.distance = approach.distance;
  const FirstContact& near = approach.first_contact;
  if (near.free() || !near.start_intersections.empty()) return clearance;
  if (near.at_start.empty()) clearance.toi = near.toi, clearance.toi_upper = near.toi_upper;
  const std::vector<MeshContact>& pairs = near.at_start.empty() ? near.earliest : near.at_start;
  clearance.pairs = pairs.size();
  clearance.pair = named(pairs.front(), names);
  return clearance;
}

EnclosedCounts counts_of(const std::vector<EnclosedPart>& enclosed, ElementNames& names) {
  EnclosedCounts counts;
  if (enclosed.empty()) return counts;
  counts.vertex = names.element(MeshElement::vertex, enclosed.front().vertex);
  counts.face = names.element(MeshElement::face, enclosed.front().faces.front());
  for (const EnclosedPart& piece : enclosed) {
    ++(piece.element == MeshElement::face   ? counts.surfaces
       : piece.element == MeshElement::edge ? counts.wires
                                            : counts.points);
  }
  return counts;
}

void set_classes(Result& result, const Mesh& mesh, const Frame& frame, const MeshOptions& options) {
  const Topology& topology = *frame.topology;
  const auto count = static_cast<std::uint32_t>(topology.parts.size());
  const mesh::GroupRelations found =
      mesh::group_relations(mesh, positions_of(frame), parts_of_vertices(topology, {}), count, options);
  result.without_inside = found.without_inside;
  std::vector<PartRelation>& relations = result.classes.emplace();
  for (const auto& [a, b, sort] : found.pairs) {
    const bool swapped = sort == mesh::Relation::around;
    relations.push_back({shown_part(topology.parts[swapped ? b : a]), shown_part(topology.parts[swapped ? a : b]),
                         swapped ? mesh::Relation::inside : sort});
  }
}

}  // namespace

std::vector<MeshIndex> loose_points(const Topology& topology) {
  if (topology.faces.empty() && topology.edges.empty() && topology.points.empty()) {
    std::vector<MeshIndex> all(topology.vertex_count);
    for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<MeshIndex>(v);
    return all;
  }
  if (topology.points.empty()) return {};
  std::vector<char> taken(topology.vertex_count, 0);
  const auto take = [&](const auto& elements) {
    for (const auto& corners : elements) {
      for (const MeshIndex corner : corners) {
        if (corner < taken.size()) taken[corner] = 1;
      }
    }
  };
  take(topology.faces);
  take(topology.edges);
  std::vector<MeshIndex> points;
  for (const MeshIndex point : topology.points) {
    if (point < taken.size() && std::exchange(taken[point], char{1}) != 0) continue;
    points.push_back(point);
  }
  return points;
}

Mesh mesh_of(const Topology& topology, const Separation& separation, const std::string& file, const PartRules& parts) {
  MeshElements elements;
  elements.vertex_count = topology.vertex_count;
  elements.dimension = topology.dimension;
  elements.faces = topology.faces;
  elements.edges = topology.edges;
  elements.points = loose_points(topology);
  elements.separation = separation;
  elements.rules = collision_rules(topology, parts, file);
  try {
    Mesh mesh(std::move(elements));
    if (!parts.empty() && !mesh.has_pairs()) io::fail(file, "has no two parts that are left to ask about");
    return mesh;
  } catch (const InvalidMesh& error) {
    check_elements(topology, file);
    io::fail(file, error.what());
  }
}

void check_has_classes(const Topology& topology, const std::string& file) {
  if (topology.dimension != 3) io::fail(file, "is a mesh in the plane, and --classes is about parts in space");
  if (topology.parts.size() < 2) {
    io::fail(file, "has no two parts for --classes: they are objects or groups of the file, or files with --parts");
  }
  static_cast<void>(parts_of_vertices(topology, file));
}

void check_positions(const Frame& frame, const FrameName& name) {
  const auto dimension = static_cast<std::size_t>(frame.topology->dimension);
  const auto found =
      std::find_if_not(frame.positions.begin(), frame.positions.end(), [](double x) { return std::isfinite(x); });
  if (found == frame.positions.end()) return;
  const auto at = static_cast<std::size_t>(found - frame.positions.begin());
  io::fail(name.file, fmt::format("{}vertex {} has {} = {}; coordinates must be finite",
                                  name.several ? fmt::format("in frame {}, ", name.index) : std::string(),
                                  frame.topology->number_of_vertex(at / dimension), "xyz"[at % dimension], *found));
}

void check_same_elements(const Topology& before, const FrameName& name_before, const Topology& after,
                         const FrameName& name_after) {
  if (&before == &after) return;
  check_same_count(static_cast<std::size_t>(before.dimension), static_cast<std::size_t>(after.dimension),
                   "coordinates a vertex", name_before, name_after);
  check_same_count(before.vertex_count, after.vertex_count, "vertices", name_before, name_after);
  check_same_count(before.faces.size(), after.faces.size(), "faces", name_before, name_after);
  check_same_count(before.edges.size(), after.edges.size(), "edges", name_before, name_after);
  check_same(before, before.faces, after, after.faces, "face", name_before, name_after);
  check_same(before, before.edges, after, after.edges, "edge", name_before, name_after);
  if (before.points != after.points) {
    check_same_count(before.points.size(), after.points.size(), "points", name_before, name_after);
    refuse_change(name_before, name_after, "other vertices are points");
  }
}

void check_same_parts(const Topology& before, const FrameName& name_before, const Topology& after,
                      const FrameName& name_after) {
  if (before.parts != after.parts) refuse_change(name_before, name_after, "the parts have other names");
  if (before.face_parts != after.face_parts) refuse_change(name_before, name_after, "faces are in other parts");
}

Result check_frame(const Mesh& mesh, const Frame& frame, std::size_t index, const CheckOptions& how) {
  Result result;
  result.frame = index;
  ElementNames names(mesh, *frame.topology);
  const MeshOptions options{how.threads, how.stop};
  const std::vector<Intersection> found = intersections(mesh, positions_of(frame), options);
  result.intersections = named(found, names);
  const Insides inside = insides(mesh, positions_of(frame), options, found, ClosedParts::unasked);
  result.enclosed = counts_of(inside.enclosed, names);
  result.in_open = inside.in_open;
  result.flat = flat_faces(mesh, positions_of(frame));
  if (!result.free()) result.coinciding = coinciding_vertices(mesh, positions_of(frame));
  if (how.classes) set_classes(result, mesh, frame, options);
  if (how.clearance) result.clearance = clearance_of(distance(mesh, positions_of(frame), options), names);
  return result;
}

Result check_step(const Mesh& mesh, const Frame& before, const Frame& after, std::size_t index,
                  const CheckOptions& how) {
  const StepOptions options{{how.threads, how.stop}};
  const FirstContact contact = first_contact(mesh, positions_of(before), positions_of(after), {options});
  Result result;
  result.step = true;
  result.frame = index;
  result.toi = contact.toi;
  result.toi_upper = contact.toi_upper;
  result.turning = turning_faces(mesh, positions_of(before), positions_of(after));
  ElementNames names(mesh, *before.topology);
  if (how.clearance) {
    const ClosestApproach approach = closest_approach(mesh, positions_of(before), positions_of(after), options);
    result.clearance = clearance_of(approach, names);
  }
  if (contact.free()) return result;
  for (const MeshContact& one : contact.earliest) result.first.push_back(named(one, names));
  for (const MeshContact& one : contact.at_start) result.at_start.push_back(named(one, names));
  result.intersections = named(intersections(mesh, positions_of(after), options), names);
  if (!contact.at_start.empty()) result.coinciding = coinciding_vertices(mesh, positions_of(before));
  result.own_neighbours = own_neighbours_among(mesh, contact.at_start);
  return result;
}

Query query_of(const PairContact& pair, const Frame& before, const Frame& after) {
  const Topology& topology = *before.topology;
  const auto at = [&](const Frame& frame, MeshIndex vertex) {
    const auto dimension = static_cast<std::size_t>(topology.dimension);
    const double* const x = &frame.positions[vertex * dimension];
    return Vec3{x[0], x[1], dimension == 3 ? x[2] : 0.0};
  };
  Query query;
  query.kind = pair.kind;
  std::size_t corner = 0;
  for (const NamedElement* element : {&pair.first, &pair.second}) {
    for (std::size_t i = 0; i < element->corner_count(); ++i, ++corner) {
      const std::optional<MeshIndex> vertex = vertex_named(topology, *element, i);
      if (!vertex) {
        throw Error(fmt::format("a pair of an earlier run names vertex {}, which the mesh does not have",
                                element->vertices[i]));
      }
      query.start[corner] = at(before, *vertex);
      query.end[corner] = at(after, *vertex);
    }
  }
  return query;
}

}  // namespace touchstone::sequence
