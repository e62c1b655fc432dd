// SPDX-License-Identifier: MIT
#include "mesh/inside_surfaces/pieces.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

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

/// Calls block(first, last) for the longest runs of neighbours of which is_same(before, after) holds.
template <typename T, typename IsSame, typename Block>
void for_each_run(std::span<T> all, const IsSame& is_same, const Block& block) {
  for (auto first = all.begin(); first != all.end();) {
    auto last = first + 1;
    while (last != all.end() && is_same(*(last - 1), *last)) ++last;
    block(first, last);
    first = last;
  }
}

constexpr auto at_one_edge = [](const auto& a, const auto& b) { return a.edge == b.edge; };

/// Sorts the sides at one edge by a number of their faces.
template <typename Side>
void sort_by(const std::vector<Index>& number, Side first, Side last) {
  if (last - first <= 2) return;  // of one set, or in it alone
  std::sort(first, last, [&](const auto& a, const auto& b) { return number[a.face] < number[b.face]; });
}

std::array<Index, 2> ends_of(std::uint64_t edge) noexcept {
  return {static_cast<Index>(edge >> 32), static_cast<Index>(edge)};
}

/// Makes the piece's middle that of an edge, unless it has one that is at two positions.
void take_as_middle(Piece& piece, const std::array<Index, 2>& edge, const Motion& motion) noexcept {
  const auto& [a, b] = piece.middle;
  if (same_position(motion[a].start, motion[b].start)) piece.middle = edge;
}

Index index_in(const std::vector<Index>& sorted, Index number) noexcept {
  return static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
}

}  // namespace

Pieces::Pieces(const Mesh::Impl& mesh, const Motion& motion)
    : mesh_(mesh), of_(mesh.faces.size() + mesh.wires.size() + mesh.points.size()) {
  geometry::UnionFind sets(mesh.faces.size() + mesh.wires.size());
  find_sides();
  const std::vector<char> is_open = connect_faces(sets);
  find_pieces(sets, motion);
  find_sorts(is_open);
  find_vertices();
}

/// A counting sort by the lesser vertex; then the few sides at each are sorted by the greater one.
void Pieces::find_sides() {
  std::vector<std::size_t> begin(mesh_.vertex_count + 1, 0);
  const auto for_each_side = [&](const auto& call) {
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Index from = mesh_.faces[f][i], to = mesh_.faces[f][(i + 1) % 3];
        call(std::min(from, to), Side{unordered(from, to), static_cast<Index>(f), from < to ? 1 : -1});
      }
    }
  };
  for_each_side([&](Index lesser, const Side&) { ++begin[lesser + std::size_t{1}]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  sides_.resize(3 * mesh_.faces.size());
  std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
  for_each_side([&](Index lesser, const Side& side) { sides_[end[lesser]++] = side; });
  for (std::size_t v = 0; v < end.size(); ++v) std::sort(sides_.data() + begin[v], sides_.data() + end[v]);
}

/// For each face whether its set is open: an edge is in an odd number of the set's faces.
std::vector<char> Pieces::open_sets(geometry::UnionFind& sets) {
  std::vector<Index> set(mesh_.faces.size());
  for (Index f = 0; f < set.size(); ++f) set[f] = sets.root(f);
  std::vector<char> is_open(set.size(), 0);
  const auto in_one_set = [&](const Side& a, const Side& b) { return set[a.face] == set[b.face]; };
  for_each_run(std::span(sides_), at_one_edge, [&](auto first, auto last) {
    sort_by(set, first, last);
    for_each_run(std::span(first, last), in_one_set, [&](auto side, auto end) {
      if ((end - side) % 2 != 0) is_open[set[side->face]] = 1;
    });
  });
  for (std::size_t f = 0; f < set.size(); ++f) is_open[f] = is_open[set[f]];
  return is_open;
}

/// @returns for each face whether the set that edges with two faces connect is open
std::vector<char> Pieces::connect_faces(geometry::UnionFind& sets) {
  for_each_run(std::span(sides_), at_one_edge, [&](auto side, auto end) {
    if (end - side == 2) sets.join(side[0].face, side[1].face);
  });
  std::vector<char> is_open = open_sets(sets);
  geometry::UnionFind all = sets;  // with what meets at edges of closed sets, too
  for_each_run(std::span(sides_), at_one_edge, [&](auto first, auto last) {
    const auto open = [&](const Side& side) { return is_open[side.face] != 0; };
    const bool all_open = std::all_of(first, last, open);
    const auto one = std::find_if(first, last, open);
    for (auto side = one; side != last; ++side) {
      if (!open(*side)) continue;
      all.join(one->face, side->face);
      if (all_open) sets.join(one->face, side->face);
    }
  });
  const std::vector<char> still_open = open_sets(all);
  for (Index f = 0; f < is_open.size(); ++f) {
    if (still_open[f] == 0) sets.join(f, all.root(f));
  }
  return is_open;
}

void Pieces::find_pieces(geometry::UnionFind& sets, const Motion& motion) {
  const std::size_t faces = mesh_.faces.size(), connected = sets.size();
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
      piece.least = n < faces ? least : n < connected ? mesh_.wires[n - faces] : corners[0];
      piece.middle = {corners[0], corners[0]};
      piece.branches = n < faces;
    }
    of_[n] = of_[least];
    Piece& piece = all_[of_[n]];
    for (const Index corner : corners) broad_phase::extend(piece.box, motion[corner].start);
    if (n >= faces) take_as_middle(piece, {corners.front(), corners.back()}, motion);
  }
  for_each_run(std::span(sides_), at_one_edge, [&](auto side, auto end) {
    if (end - side > 2) return;
    Piece& piece = all_[of_[side->face]];
    piece.branches = false;
    take_as_middle(piece, ends_of(side->edge), motion);
  });
}

void Pieces::find_sorts(const std::vector<char>& is_open) {
  const auto in_one_piece = [&](const Side& a, const Side& b) { return of_[a.face] == of_[b.face]; };
  for_each_run(std::span(sides_), at_one_edge, [&](auto first, auto last) {
    const bool has_more = last - first > 2;
    sort_by(of_, first, last);
    for_each_run(std::span(first, last), in_one_piece, [&](auto side, auto end) {
      Piece& piece = all_[of_[side->face]];
      piece.branches = piece.branches || (has_more && end - side > 1 && is_open[side->face] != 0);
      int sum = 0;
      for (; side != end; ++side) sum += side->direction;
      piece.sort = std::max(piece.sort, sum % 2 != 0 ? PieceSort::open
                                        : sum != 0   ? PieceSort::even
                                                     : PieceSort::oriented);
    });
  });
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

std::vector<Index> Pieces::of(MeshElement element, Index number) const {
  const auto faces = static_cast<Index>(mesh_.faces.size()), wires = static_cast<Index>(mesh_.wires.size());
  if (element == MeshElement::face) return {of_[number]};
  if (element == MeshElement::vertex) return {of_[faces + wires + index_in(mesh_.points, number)]};
  const Side edge{unordered(mesh_.edges[number][0], mesh_.edges[number][1]), 0, 0};
  std::vector<Index> pieces;
  const auto [first, last] = std::equal_range(sides_.begin(), sides_.end(), edge);
  for (auto side = first; side != last; ++side) {
    if (pieces.empty() || pieces.back() != of_[side->face]) pieces.push_back(of_[side->face]);
  }
  if (pieces.empty()) pieces.push_back(of_[faces + index_in(mesh_.wires, number)]);
  return pieces;
}

std::size_t Pieces::branching() const noexcept {
  return static_cast<std::size_t>(std::count_if(all_.begin(), all_.end(), [](const Piece& p) { return p.branches; }));
}

}  // namespace touchstone::mesh
