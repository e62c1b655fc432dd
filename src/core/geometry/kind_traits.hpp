// The kinds of query in one table: both elements of each, their features, and where their corners are.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::geometry {

/// An element of a query.
struct Element {
  MeshElement sort;
  std::array<Feature, 8> features;  ///< by the set of corners that bound the feature: bit i is the element's corner i

  constexpr std::size_t corners() const noexcept { return static_cast<std::size_t>(sort) + 1; }
  /// The edges between its corners: an edge is its own.
  constexpr std::size_t edges() const noexcept { return sort == MeshElement::face ? 3 : corners() - 1; }
  /// Edge i leads from corner i to this one.
  constexpr std::size_t end_of_edge(std::size_t i) const noexcept { return (i + 1) % corners(); }
  constexpr Feature corner(std::size_t i) const noexcept { return features[std::size_t{1} << i]; }
  constexpr Feature edge(std::size_t i) const noexcept {
    return features[std::size_t{1} << i | std::size_t{1} << end_of_edge(i)];
  }
};

constexpr Element vertex_of(Feature corner) noexcept { return {MeshElement::vertex, {Feature::none, corner}}; }
constexpr Element edge_of(Feature start, Feature end, Feature interior) noexcept {
  return {MeshElement::edge, {Feature::none, start, end, interior}};
}
inline constexpr Element kFace{
    MeshElement::face,
    {Feature::none, Feature::f0, Feature::f1, Feature::f01, Feature::f2, Feature::f20, Feature::f12, Feature::f}};

/// The corners of the first element come first in a query.
struct KindTraits {
  Element first, second;
};

/// By the numbers of the kinds.
inline constexpr std::array<KindTraits, kKinds.size()> kKindTraits{
    {{edge_of(Feature::a0, Feature::a1, Feature::a), edge_of(Feature::b0, Feature::b1, Feature::b)},
     {vertex_of(Feature::v), kFace},
     {vertex_of(Feature::p), edge_of(Feature::e0, Feature::e1, Feature::e)},
     {vertex_of(Feature::p), vertex_of(Feature::q)}}};

constexpr const KindTraits& traits_of(Kind kind) noexcept { return kKindTraits[static_cast<std::size_t>(kind)]; }

/// The number of the first element's corners. Inner loops ask for it, so it is no look-up.
constexpr std::size_t corners_of_first(Kind kind) noexcept { return kind == Kind::edge_edge ? 2 : 1; }

static_assert(std::all_of(kKinds.begin(), kKinds.end(), [](Kind kind) {
  const std::size_t first = traits_of(kind).first.corners();
  return first == corners_of_first(kind) && first + traits_of(kind).second.corners() == corner_count(kind);
}));

/// The corners of an element of a mesh: those of the edge or face with this number, or the number of the vertex itself.
inline const std::uint32_t* corners_of(MeshElement sort, const std::uint32_t& number,
                                       const std::vector<std::array<std::uint32_t, 2>>& edges,
                                       const std::vector<std::array<std::uint32_t, 3>>& faces) noexcept {
  return sort == MeshElement::edge ? edges[number].data() : sort == MeshElement::face ? faces[number].data() : &number;
}

/// The corners of two elements of a mesh in the order of a query's; those past corner_count(kind) are 0.
inline std::array<std::uint32_t, 4> pair_corners(Kind kind, std::uint32_t first, std::uint32_t second,
                                                 const std::vector<std::array<std::uint32_t, 2>>& edges,
                                                 const std::vector<std::array<std::uint32_t, 3>>& faces) noexcept {
  const std::uint32_t* const a = corners_of(traits_of(kind).first.sort, first, edges, faces);
  const std::uint32_t* const b = corners_of(traits_of(kind).second.sort, second, edges, faces);
  const std::size_t of_first = corners_of_first(kind);
  std::array<std::uint32_t, 4> corners{};
  for (std::size_t c = 0; c < corner_count(kind); ++c) corners[c] = c < of_first ? a[c] : b[c - of_first];
  return corners;
}

}  // namespace touchstone::geometry
