// SPDX-License-Identifier: MIT
#include "sequence/repairs.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "io/fail.hpp"

namespace touchstone::sequence {
namespace {

using frames::Frame;
using frames::Topology;

const double* position_of(const Frame& frame, MeshIndex vertex) {
  return &frame.positions[static_cast<std::size_t>(frame.topology->dimension) * vertex];
}

bool same_position(const Frame& frame, MeshIndex a, MeshIndex b) {
  const double* const x = position_of(frame, a);
  return std::equal(x, x + frame.topology->dimension, position_of(frame, b));
}

/// For each vertex 1 + the number of its part, or 0 for a vertex in no face, which has none.
std::vector<std::uint32_t> parts_of(const Topology& topology) {
  std::vector<std::uint32_t> parts(topology.vertex_count, 0);
  for (std::size_t f = topology.face_parts.size(); f-- > 0;) {
    for (const MeshIndex v : topology.faces[f]) {
      if (v < parts.size()) parts[v] = topology.face_parts[f] + 1;
    }
  }
  return parts;
}

/// For each vertex the first one at the same position in the same part: two bodies that touch stay two.
std::vector<MeshIndex> first_at_position(const Frame& frame, const std::vector<std::uint32_t>& parts) {
  std::vector<MeshIndex> order(frame.topology->vertex_count), first(order.size());
  std::iota(order.begin(), order.end(), MeshIndex{0});
  std::sort(order.begin(), order.end(), [&](MeshIndex a, MeshIndex b) {
    const double *const x = position_of(frame, a), *const y = position_of(frame, b);
    for (int k = 0; k < frame.topology->dimension; ++k) {
      if (x[k] != y[k]) return x[k] < y[k];
    }
    return std::pair(parts[a], a) < std::pair(parts[b], b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && parts[order[i - 1]] == parts[order[i]] && same_position(frame, order[i - 1], order[i]);
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Names the vertices that stand for others. @return how many of the others no element names any more
std::size_t weld(Topology& topology, const std::vector<MeshIndex>& first) {
  std::vector<char> replaced(topology.vertex_count, 0);
  const auto replace = [&](MeshIndex& vertex) {
    if (vertex >= first.size() || first[vertex] == vertex) return;  // a vertex that is not there is refused later
    replaced[vertex] = 1;
    vertex = first[vertex];
  };
  for (auto& corners : topology.faces) std::for_each(corners.begin(), corners.end(), replace);
  for (auto& corners : topology.edges) std::for_each(corners.begin(), corners.end(), replace);
  std::for_each(topology.points.begin(), topology.points.end(), replace);
  return static_cast<std::size_t>(std::count(replaced.begin(), replaced.end(), 1));
}

/// Which elements have corners of their own: no corner twice, and not those of an element before them.
template <std::size_t N>
std::vector<char> sound_elements(const std::vector<std::array<MeshIndex, N>>& elements) {
  std::vector<char> sound(elements.size(), 1);
  std::vector<std::pair<std::array<MeshIndex, N>, std::size_t>> sorted;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    auto corners = elements[i];
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) sound[i] = 0;
    sorted.push_back({corners, i});
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) sound[sorted[i].second] = 0;
  }
  return sound;
}

template <class Item>
void keep(std::vector<Item>& items, const std::vector<char>& kept) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (kept[i] != 0) items[size++] = items[i];
  }
  items.resize(size);
}

/// @return how many faces and edges were left out
std::size_t drop_degenerate(Topology& topology) {
  const auto faces = sound_elements(topology.faces);
  const auto edges = sound_elements(topology.edges);
  const auto dropped =
      static_cast<std::size_t>(std::count(faces.begin(), faces.end(), 0) + std::count(edges.begin(), edges.end(), 0));
  if (std::count(faces.begin(), faces.end(), 0) > 0) {
    if (topology.face_numbers.empty()) {
      topology.face_numbers.resize(topology.faces.size());
      std::iota(topology.face_numbers.begin(), topology.face_numbers.end(), topology.first_number);
    }
    keep(topology.face_numbers, faces);
    if (!topology.face_parts.empty()) keep(topology.face_parts, faces);
    keep(topology.faces, faces);
  }
  keep(topology.edges, edges);
  return dropped;
}

}  // namespace

void Repairs::mend(Frame& frame, const FrameName& name) {
  if (options_.empty()) return;
  const bool is_known = before_ != nullptr && (frame.topology == before_ || *frame.topology == *before_);
  if (each_by_itself_ || !is_known) begin_with(frame, name);
  check_welds(frame, name);
  frame.topology = after_;
}

void Repairs::begin_with(const Frame& frame, const FrameName& name) {
  before_ = frame.topology;
  first_ = name.label();
  Topology topology = *frame.topology;
  if (options_.weld) {
    const std::vector<std::uint32_t> one_part(topology.vertex_count, 0);
    standing_for_ = first_at_position(frame, options_.is_one_part ? one_part : parts_of(topology));
    topology.welded_vertices = weld(topology, standing_for_);
  }
  if (options_.drop_degenerate) topology.dropped_elements = drop_degenerate(topology);
  after_ = std::make_shared<const Topology>(std::move(topology));
}

void Repairs::check_welds(const Frame& frame, const FrameName& name) const {
  for (std::size_t v = 0; v < standing_for_.size(); ++v) {
    const auto vertex = static_cast<MeshIndex>(v);
    if (standing_for_[v] == vertex || same_position(frame, standing_for_[v], vertex)) continue;
    const std::uint64_t number = frame.topology->first_number;
    io::fail(name.file, "vertices " + std::to_string(standing_for_[v] + number) + " and " + std::to_string(v + number) +
                            " are apart in " + name.label() + ", and at one position in " + first_ +
                            ", where they were welded; without --weld they stay two");
  }
}

}  // namespace touchstone::sequence
