// SPDX-License-Identifier: MIT
#include "mesh/pieces.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>

#include "geometry/union_find.hpp"
#include "mesh/folds.hpp"

namespace touchstone::mesh {
namespace {

constexpr Index kNone = std::numeric_limits<Index>::max(), kSeveral = kNone - 1;

/// The vertices of element n, of the faces, the wires and the loose points in this order.
std::span<const Index> corners_of(const Mesh::Impl& mesh, std::size_t n) noexcept {
  if (n < mesh.faces.size()) return mesh.faces[n];
  n -= mesh.faces.size();
  if (n < mesh.wires.size()) return mesh.edges[mesh.wires[n]];
  return {&mesh.points[n - mesh.wires.size()], 1};
}

Index place_in(const std::vector<Index>& sorted, Index number) noexcept {
  return static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
}

}  // namespace

Pieces::Pieces(const Mesh::Impl& mesh, const Motion& motion)
    : mesh_(mesh), of_(mesh.faces.size() + mesh.wires.size() + mesh.points.size()) {
  find_sides();
  find_pieces(motion);
  find_sorts();
  find_vertices();
}

void Pieces::find_sides() {
  sides_.reserve(3 * mesh_.faces.size());
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = mesh_.faces[f][i], to = mesh_.faces[f][(i + 1) % 3];
      sides_.push_back({unordered(from, to), static_cast<Index>(f), from < to ? 1 : -1});
    }
  }
  std::sort(sides_.begin(), sides_.end());
}

void Pieces::find_pieces(const Motion& motion) {
  const std::size_t faces = mesh_.faces.size(), connected = faces + mesh_.wires.size();
  geometry::UnionFind sets(connected);
  for (std::size_t i = 1; i < sides_.size(); ++i) {
    if (sides_[i].edge == sides_[i - 1].edge) sets.join(sides_[i].face, sides_[i - 1].face);
  }
  std::vector<Index> element_at(mesh_.vertex_count, kNone);  // a face, or else a wire
  for (std::size_t n = 0; n < connected; ++n) {
    for (const Index corner : corners_of(mesh_, n)) {
      Index& at = element_at[corner];
      if (n >= faces && at != kNone && at >= faces) sets.join(static_cast<Index>(n), at);
      if (at == kNone) at = static_cast<Index>(n);
    }
  }
  for (std::size_t n = 0; n < of_.size(); ++n) {
    const Index least = n < connected ? sets.root(static_cast<Index>(n)) : static_cast<Index>(n);
    const auto corners = corners_of(mesh_, n);
    if (least == n) {
      of_[n] = size();
      Piece& piece = all_.emplace_back();
      piece.sort = n < faces ? PieceSort::oriented : n < connected ? PieceSort::wire : PieceSort::point;
      piece.first = n < faces ? least : n < connected ? mesh_.wires[n - faces] : corners[0];
      piece.middle = {corners[0], corners[0]};
    }
    of_[n] = of_[least];
    Piece& piece = all_[of_[n]];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& [a, b] = piece.middle;
      if (same_place(motion[a].start, motion[b].start)) piece.middle = {corners[i], corners[(i + 1) % corners.size()]};
      broad_phase::extend(piece.box, motion[corners[i]].start);
    }
  }
}

void Pieces::find_sorts() {
  for (auto side = sides_.begin(); side != sides_.end();) {
    const auto first = side;
    int sum = 0;
    for (; side != sides_.end() && side->edge == first->edge; ++side) sum += side->direction;
    PieceSort& sort = all_[of_[first->face]].sort;
    sort = std::max(sort, sum % 2 != 0 ? PieceSort::open : sum != 0 ? PieceSort::even : PieceSort::oriented);
  }
}

void Pieces::find_vertices() {
  std::vector<Index> piece_at(mesh_.vertex_count, kNone);
  for (std::size_t n = 0; n < of_.size(); ++n) {
    for (const Index corner : corners_of(mesh_, n)) {
      Index& at = piece_at[corner];
      at = at == kNone || at == of_[n] ? of_[n] : kSeveral;
    }
  }
  for (Piece& piece : all_) piece.vertex = piece.middle[0];
  const auto order = [&](Index vertex) { return std::tuple(piece_at[vertex] == kSeveral, vertex); };
  for (std::size_t n = 0; n < of_.size(); ++n) {
    Index& best = all_[of_[n]].vertex;
    for (const Index corner : corners_of(mesh_, n)) best = order(corner) < order(best) ? corner : best;
  }
}

Index Pieces::of(MeshElement element, Index number) const noexcept {
  const auto faces = static_cast<Index>(mesh_.faces.size()), wires = static_cast<Index>(mesh_.wires.size());
  if (element == MeshElement::face) return of_[number];
  if (element == MeshElement::vertex) return of_[faces + wires + place_in(mesh_.points, number)];
  const Side edge{unordered(mesh_.edges[number][0], mesh_.edges[number][1]), 0, 0};
  const auto side = std::lower_bound(sides_.begin(), sides_.end(), edge);
  if (side != sides_.end() && side->edge == edge.edge) return of_[side->face];
  return of_[faces + place_in(mesh_.wires, number)];
}

}  // namespace touchstone::mesh
