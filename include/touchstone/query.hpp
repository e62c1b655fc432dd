// Touchstone: the questions. Corners of two elements at both ends of a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace touchstone {

/// A position: three coordinates in any unit of length, finite.
struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// Which two elements a query is about.
enum class Kind : std::uint8_t { edge_edge, vertex_face, point_edge, point_point };

/// The name used in files and on the command line: "edge-edge", "vertex-face", "point-edge", "point-point".
std::string_view kind_name(Kind kind) noexcept;

/// How many corners a query of this kind has at each end of the step: 4, 4, 3 or 2.
constexpr std::size_t corner_count(Kind kind) noexcept {
  return kind == Kind::point_edge ? 3 : kind == Kind::point_point ? 2 : 4;
}

/// Edge a0 a1 against edge b0 b1; `start` is at t = 0 and `end` at t = 1, both in the order a0 a1 b0 b1.
/// Each corner moves on a straight line: x(t) = start + t (end - start), with the exact values of the doubles.
struct EdgeEdge {
  std::array<Vec3, 4> start;
  std::array<Vec3, 4> end;
};

/// Vertex v against triangle f0 f1 f2, in this order.
struct VertexFace {
  std::array<Vec3, 4> start;
  std::array<Vec3, 4> end;
};

/// Point p against edge e0 e1, in this order.
struct PointEdge {
  std::array<Vec3, 3> start;
  std::array<Vec3, 3> end;
};

/// Point p against point q, in this order.
struct PointPoint {
  std::array<Vec3, 2> start;
  std::array<Vec3, 2> end;
};

/// A query of any kind. Corners past `corner_count(kind)` are never read.
struct Query {
  Kind kind = Kind::edge_edge;
  std::array<Vec3, 4> start{};
  std::array<Vec3, 4> end{};

  Query() = default;
  Query(const EdgeEdge& q) : kind(Kind::edge_edge), start(q.start), end(q.end) {}
  Query(const VertexFace& q) : kind(Kind::vertex_face), start(q.start), end(q.end) {}
  Query(const PointEdge& q)
      : kind(Kind::point_edge), start{q.start[0], q.start[1], q.start[2]}, end{q.end[0], q.end[1], q.end[2]} {}
  Query(const PointPoint& q) : kind(Kind::point_point), start{q.start[0], q.start[1]}, end{q.end[0], q.end[1]} {}
};

/// A rational coordinate, as two decimal integers of any length: an optional '-' and digits; the denominator is not zero.
struct Fraction {
  std::string numerator = "0";
  std::string denominator = "1";
};

/// A query whose coordinates are rationals that doubles may not hold. Each corner is {x, y, z}.
struct RationalQuery {
  Kind kind = Kind::edge_edge;
  std::array<std::array<Fraction, 3>, 4> start;
  std::array<std::array<Fraction, 3>, 4> end;
};

/// The name of corner `index` of a query of this kind: "a0", "b1", "v", "f2", "p", "e0", "q".
std::string_view corner_name(Kind kind, std::size_t index) noexcept;

}  // namespace touchstone
