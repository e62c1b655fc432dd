// The pieces of a mesh: its surfaces, wires and loose points, each by itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/box.hpp"
#include "geometry/union_find.hpp"
#include "mesh/mesh_elements.hpp"
#include "mesh/moving_vertices.hpp"

namespace touchstone::mesh {

enum class PieceSort : std::uint8_t {
  oriented,  ///< a closed surface: its faces pass each of their edges as often in one direction as in the other
  even,      ///< a closed surface without that: each of its edges is in an even number of its faces
  open,      ///< any other surface
  wire,      ///< edges that are in no face
  point      ///< a loose point
};

struct Piece {
  PieceSort sort = PieceSort::point;
  Index least = 0;                ///< its least element: a face, a wire's edge or a vertex
  Index vertex = 0;               ///< its least vertex that is in no other piece; without such, its least one
  std::array<Index, 2> middle{};  ///< the ends of one of its edges; in no other piece and at two places, if it has one
  bool branches = false;  ///< edges with three faces or more connect it, or all of its edges are in other pieces, too
  broad_phase::Box box = broad_phase::empty_box();  ///< at the start of the motion

  bool is_closed() const noexcept { return sort <= PieceSort::even; }
};

/// A surface is a set of faces that are connected by edges with two faces. Such sets that are not closed are connected
/// by edges with more faces, too, where no closed set has a face, or where they are closed together. A wire is a set of
/// edges in no face that are connected by vertices in no face: one that grows from a surface ends there. So pieces
/// share vertices, and edges with three faces or more. Without those, a piece that does not branch is still connected.
/// Surfaces come first, then wires, then points, each by their least elements.
class Pieces {
 public:
  Pieces(const Mesh::Impl& mesh, const Motion& motion);

  Index size() const noexcept { return static_cast<Index>(all_.size()); }
  const Piece& operator[](Index piece) const noexcept { return all_[piece]; }

  Index of_face(Index face) const noexcept { return of_[face]; }

  /// The pieces of a face, an edge or a loose point: of an edge there may be several, in ascending order.
  std::vector<Index> of(MeshElement element, Index number) const;

  /// How many surfaces branch: what they enclose, and what encloses them, is not known.
  std::size_t branching() const noexcept;

 private:
  struct Side {  // of a face
    std::uint64_t edge;
    Index face;
    std::int32_t direction;  // 1 from the lesser vertex to the greater one, or -1
    bool operator<(const Side& other) const noexcept { return edge < other.edge; }
  };

  void find_sides();
  std::vector<char> open_sets(geometry::UnionFind& sets);
  std::vector<char> connect_faces(geometry::UnionFind& sets);
  void find_pieces(geometry::UnionFind& sets, const Motion& motion);
  void find_sorts(const std::vector<char>& is_open);
  void find_vertices();

  const Mesh::Impl& mesh_;
  std::vector<Side> sides_;  // by edge, then by piece
  std::vector<Index> of_;    // by element: the faces, the wires, the loose points
  std::vector<Piece> all_;
};

}  // namespace touchstone::mesh
