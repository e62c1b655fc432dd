// Touchstone: queries. A query is two elements with their corners at both ends of a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/names.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// A position: three finite coordinates, all in one unit of length of your choice. Give a 2-D query z = 0.
struct Vec3 {
  double x = 0;  ///< the first coordinate
  double y = 0;  ///< the second coordinate
  double z = 0;  ///< the third coordinate
};

/// A sort of element.
enum class MeshElement : std::uint8_t {
  vertex,  ///< a vertex
  edge,    ///< an edge
  face     ///< a face
};

/// "vertex", "edge", "face".
template <>
Names names_of<MeshElement>() noexcept;

/// The two elements that a query is about.
enum class Kind : std::uint8_t {
  edge_edge,    ///< a segment against a segment
  vertex_face,  ///< a point against a triangle
  point_edge,   ///< a point against a segment
  point_point   ///< a point against a point
};

/// All kinds.
inline constexpr std::array<Kind, 4> kKinds{Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point};

/// "edge-edge", "vertex-face", "point-edge", "point-point".
template <>
Names names_of<Kind>() noexcept;

/// The number of corners that a query of this kind has at each end of the step: 4, 4, 3 or 2.
constexpr std::size_t corner_count(Kind kind) noexcept {
  return kind == Kind::point_edge ? 3 : kind == Kind::point_point ? 2 : 4;
}

/// Edge a0 a1 against edge b0 b1. Corners are in the order a0 a1 b0 b1. In every kind of query each corner moves on a
/// straight line: x(t) = start + t (end - start) for t in [0, 1], with the exact values of the doubles.
struct EdgeEdge {
  std::array<Vec3, 4> start;  ///< the corners at t = 0
  std::array<Vec3, 4> end;    ///< the corners at t = 1
};

/// Vertex v against triangle f0 f1 f2. Corners are in the order v f0 f1 f2.
struct VertexFace {
  std::array<Vec3, 4> start;  ///< the corners at t = 0
  std::array<Vec3, 4> end;    ///< the corners at t = 1
};

/// Point p against edge e0 e1. Corners are in the order p e0 e1.
struct PointEdge {
  std::array<Vec3, 3> start;  ///< the corners at t = 0
  std::array<Vec3, 3> end;    ///< the corners at t = 1
};

/// Point p against point q. Corners are in the order p q.
struct PointPoint {
  std::array<Vec3, 2> start;  ///< the corners at t = 0
  std::array<Vec3, 2> end;    ///< the corners at t = 1
};

/// A query of any kind. Every query of the four types above converts to it.
struct Query {
  Kind kind = Kind::edge_edge;  ///< which elements
  std::array<Vec3, 4> start{};  ///< the corners at t = 0; those past corner_count(kind) are never read
  std::array<Vec3, 4> end{};    ///< the corners at t = 1; those past corner_count(kind) are never read

  /// An edge-edge query with all corners at the origin.
  Query() = default;
  /// The same query, as one of any kind.
  Query(const EdgeEdge& q) : kind(Kind::edge_edge), start(q.start), end(q.end) {}
  /// The same query, as one of any kind.
  Query(const VertexFace& q) : kind(Kind::vertex_face), start(q.start), end(q.end) {}
  /// The same query, as one of any kind.
  Query(const PointEdge& q)
      : kind(Kind::point_edge), start{q.start[0], q.start[1], q.start[2]}, end{q.end[0], q.end[1], q.end[2]} {}
  /// The same query, as one of any kind.
  Query(const PointPoint& q) : kind(Kind::point_point), start{q.start[0], q.start[1]}, end{q.end[0], q.end[1]} {}
};

/// A rational coordinate: numerator / denominator, not necessarily in lowest terms.
struct Fraction {
  std::string numerator = "0";    ///< a decimal integer of any length: an optional '-' and one or more digits
  std::string denominator = "1";  ///< the same; not zero
};

/// A query whose coordinates are rationals, which need not be doubles. Each corner is {x, y, z}.
struct RationalQuery {
  Kind kind = Kind::edge_edge;                   ///< which elements
  std::array<std::array<Fraction, 3>, 4> start;  ///< the corners at t = 0; those past corner_count(kind) are never read
  std::array<std::array<Fraction, 3>, 4> end;    ///< the corners at t = 1; those past corner_count(kind) are never read
};

/// The name of corner `index` of a query of this kind: "a0", "b1", "v", "f2", "p", "e0", "q". Empty for an index that
/// is not below corner_count(kind).
std::string_view corner_name(Kind kind, std::size_t index) noexcept;

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
