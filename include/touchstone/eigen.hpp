// Touchstone: queries and meshes from Eigen vectors and matrices. Include it beside touchstone.hpp; it needs Eigen 3.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/query.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

namespace detail {

/// The expression itself when its values are in memory; otherwise its values, evaluated once.
template <typename Derived>
decltype(auto) eigen_values(const Eigen::DenseBase<Derived>& expression) {
  if constexpr ((Derived::Flags & Eigen::DirectAccessBit) != 0) {
    return (expression.derived());
  } else {
    return expression.eval();
  }
}

}  // namespace detail

/// A corner from an Eigen vector of doubles: of fixed or dynamic size, a row or a column, a Map, a block or an
/// expression. A vector of two coordinates is a position in the plane z = 0. An expression is evaluated once, in the
/// caller's floating-point environment; its values are then copied unchanged.
/// @param position  two or three coordinates
/// @return the corner
/// @throws InvalidQuery  for a vector of dynamic size that has neither two nor three coordinates
template <typename Derived>
Vec3 to_vec3(const Eigen::DenseBase<Derived>& position) {
  static_assert(std::is_same_v<typename Derived::Scalar, double>, "a corner is made of doubles: cast it to double");
  static_assert(Derived::IsVectorAtCompileTime, "a corner is a row or column vector");
  constexpr int size = Derived::SizeAtCompileTime;
  static_assert(size == Eigen::Dynamic || size == 2 || size == 3, "a corner has two or three coordinates");
  const auto& values = detail::eigen_values(position);
  if (values.size() != 2 && values.size() != 3) {
    throw InvalidQuery("a corner has " + std::to_string(values.size()) + " coordinates, not two or three");
  }
  Vec3 corner;
  corner.x = values.coeff(0);
  corner.y = values.coeff(1);
  if constexpr (size != 2) {
    if (values.size() == 3) corner.z = values.coeff(2);
  }
  return corner;
}

/// A position as an Eigen vector.
inline Eigen::Vector3d to_eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The weights of an answer as an Eigen vector.
inline Eigen::Vector3d to_eigen(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// Corners from the rows of a matrix of doubles, N x 3, or N x 2 for corners in the plane z = 0.
/// @param rows  the matrix, one corner a row
/// @return the corners, in the order of the rows
/// @throws InvalidQuery  for a matrix of dynamic size with another number of rows or columns
template <std::size_t N, typename Derived>
std::array<Vec3, N> to_corners(const Eigen::DenseBase<Derived>& rows) {
  static_assert(std::is_same_v<typename Derived::Scalar, double>, "corners are made of doubles: cast them to double");
  constexpr int row_count = Derived::RowsAtCompileTime;
  constexpr int column_count = Derived::ColsAtCompileTime;
  static_assert(row_count == Eigen::Dynamic || row_count == static_cast<int>(N), "one row for each corner");
  static_assert(column_count == Eigen::Dynamic || column_count == 2 || column_count == 3,
                "two or three columns: the coordinates of a corner");
  const auto& values = detail::eigen_values(rows);
  if (values.rows() != static_cast<Eigen::Index>(N) || (values.cols() != 2 && values.cols() != 3)) {
    throw InvalidQuery("the corners are " + std::to_string(values.rows()) + " x " + std::to_string(values.cols()) +
                       ", not " + std::to_string(N) + " rows of two or three coordinates");
  }
  std::array<Vec3, N> corners;
  for (std::size_t i = 0; i < N; ++i) corners[i] = to_vec3(values.row(static_cast<Eigen::Index>(i)));
  return corners;
}

/// Edge a0 a1 against edge b0 b1. `start` (t = 0) and `end` (t = 1) have one corner a row, in this order: 4 x 3 or
/// 4 x 2. Like the other functions of this header, it throws InvalidQuery for a dynamic size that does not fit.
template <typename Start, typename End>
EdgeEdge edge_edge(const Eigen::DenseBase<Start>& start, const Eigen::DenseBase<End>& end) {
  return {to_corners<4>(start), to_corners<4>(end)};
}

/// The same from one vector for each corner: all positions at t = 0, then all positions at t = 1.
template <typename A0, typename A1, typename B0, typename B1, typename A0End, typename A1End, typename B0End,
          typename B1End>
EdgeEdge edge_edge(const Eigen::DenseBase<A0>& a0, const Eigen::DenseBase<A1>& a1, const Eigen::DenseBase<B0>& b0,
                   const Eigen::DenseBase<B1>& b1, const Eigen::DenseBase<A0End>& a0_end,
                   const Eigen::DenseBase<A1End>& a1_end, const Eigen::DenseBase<B0End>& b0_end,
                   const Eigen::DenseBase<B1End>& b1_end) {
  return {{to_vec3(a0), to_vec3(a1), to_vec3(b0), to_vec3(b1)},
          {to_vec3(a0_end), to_vec3(a1_end), to_vec3(b0_end), to_vec3(b1_end)}};
}

/// Vertex v against triangle f0 f1 f2. `start` and `end` have one corner a row, in this order: 4 x 3 or 4 x 2.
template <typename Start, typename End>
VertexFace vertex_face(const Eigen::DenseBase<Start>& start, const Eigen::DenseBase<End>& end) {
  return {to_corners<4>(start), to_corners<4>(end)};
}

/// The same from one vector for each corner: all positions at t = 0, then all positions at t = 1.
template <typename V, typename F0, typename F1, typename F2, typename VEnd, typename F0End, typename F1End,
          typename F2End>
VertexFace vertex_face(const Eigen::DenseBase<V>& v, const Eigen::DenseBase<F0>& f0, const Eigen::DenseBase<F1>& f1,
                       const Eigen::DenseBase<F2>& f2, const Eigen::DenseBase<VEnd>& v_end,
                       const Eigen::DenseBase<F0End>& f0_end, const Eigen::DenseBase<F1End>& f1_end,
                       const Eigen::DenseBase<F2End>& f2_end) {
  return {{to_vec3(v), to_vec3(f0), to_vec3(f1), to_vec3(f2)},
          {to_vec3(v_end), to_vec3(f0_end), to_vec3(f1_end), to_vec3(f2_end)}};
}

/// Point p against edge e0 e1. `start` and `end` have one corner a row, in this order: 3 x 3 or 3 x 2.
template <typename Start, typename End>
PointEdge point_edge(const Eigen::DenseBase<Start>& start, const Eigen::DenseBase<End>& end) {
  return {to_corners<3>(start), to_corners<3>(end)};
}

/// The same from one vector for each corner: all positions at t = 0, then all positions at t = 1.
template <typename P, typename E0, typename E1, typename PEnd, typename E0End, typename E1End>
PointEdge point_edge(const Eigen::DenseBase<P>& p, const Eigen::DenseBase<E0>& e0, const Eigen::DenseBase<E1>& e1,
                     const Eigen::DenseBase<PEnd>& p_end, const Eigen::DenseBase<E0End>& e0_end,
                     const Eigen::DenseBase<E1End>& e1_end) {
  return {{to_vec3(p), to_vec3(e0), to_vec3(e1)}, {to_vec3(p_end), to_vec3(e0_end), to_vec3(e1_end)}};
}

/// Point p against point q. `start` and `end` have one corner a row, in this order: 2 x 3 or 2 x 2.
template <typename Start, typename End>
PointPoint point_point(const Eigen::DenseBase<Start>& start, const Eigen::DenseBase<End>& end) {
  return {to_corners<2>(start), to_corners<2>(end)};
}

/// The same from one vector for each point: both positions at t = 0, then both positions at t = 1.
template <typename P, typename Q, typename PEnd, typename QEnd>
PointPoint point_point(const Eigen::DenseBase<P>& p, const Eigen::DenseBase<Q>& q, const Eigen::DenseBase<PEnd>& p_end,
                       const Eigen::DenseBase<QEnd>& q_end) {
  return {{to_vec3(p), to_vec3(q)}, {to_vec3(p_end), to_vec3(q_end)}};
}

/// A view of the rows of a matrix of doubles or floats, one vertex a row: N x 3, or N x 2 for a mesh in the plane. The
/// matrix may be row-major or column-major, a Map or a block. The view is valid as long as the matrix's memory.
/// @param rows  the matrix; not an expression, whose values are not in memory
/// @return the view
/// @throws InvalidQuery  for a matrix that has neither two nor three columns
template <typename Derived>
Positions to_positions(const Eigen::DenseBase<Derived>& rows) {
  using Scalar = typename Derived::Scalar;
  static_assert(std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>,
                "positions are doubles or floats: cast them");
  static_assert((Derived::Flags & Eigen::DirectAccessBit) != 0, "store the expression in a matrix first");
  constexpr int column_count = Derived::ColsAtCompileTime;
  static_assert(column_count == Eigen::Dynamic || column_count == 2 || column_count == 3,
                "two or three columns: the coordinates of a vertex");
  const Derived& matrix = rows.derived();
  if (matrix.cols() != 2 && matrix.cols() != 3) {
    throw InvalidQuery("the positions are " + std::to_string(matrix.rows()) + " x " + std::to_string(matrix.cols()) +
                       ", not rows of two or three coordinates");
  }
  Positions view(matrix.data(), static_cast<std::size_t>(matrix.rows()), static_cast<int>(matrix.cols()));
  view.vertex_stride = static_cast<std::ptrdiff_t>(matrix.rowStride());
  view.coordinate_stride = static_cast<std::ptrdiff_t>(matrix.colStride());
  return view;
}

/// Faces (N = 3) or edges (N = 2) from the rows of a matrix of integers.
/// @param rows  the matrix, one element a row
/// @return the elements, in the order of the rows
/// @throws InvalidMesh  for a matrix that has not N columns, or naming the first row with an index that is negative or
///                      not below 2^32
template <std::size_t N, typename Derived>
std::vector<std::array<MeshIndex, N>> to_elements(const Eigen::DenseBase<Derived>& rows) {
  static_assert(std::is_integral_v<typename Derived::Scalar>, "indices are integers");
  const auto& values = detail::eigen_values(rows);
  if (values.cols() != static_cast<Eigen::Index>(N)) {
    throw InvalidMesh("the elements are " + std::to_string(values.rows()) + " x " + std::to_string(values.cols()) +
                      ", not rows of " + std::to_string(N) + " indices");
  }
  std::vector<std::array<MeshIndex, N>> elements(static_cast<std::size_t>(values.rows()));
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
      const auto index = values.coeff(i, k);
      const auto narrow = static_cast<MeshIndex>(index);
      bool negative = false;
      if constexpr (std::is_signed_v<typename Derived::Scalar>) negative = index < 0;
      if (negative || static_cast<typename Derived::Scalar>(narrow) != index) {
        throw InvalidMesh("row " + std::to_string(i) + " of the elements has the index " + std::to_string(index) +
                          "; it must be in [0, " + std::to_string(std::numeric_limits<MeshIndex>::max()) + "]");
      }
      elements[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = narrow;
    }
  }
  return elements;
}

/// What a mesh of matrices is made of: to it separations and rules can be added.
/// @param vertices  one vertex a row, N x 3, or N x 2 for a mesh in the plane: their number and dimension alone count
/// @param elements  a face (three columns) or an edge (two columns) a row, as indices of vertices; without rows it may
///                  have any number of columns
/// @param edges     further edges, a row each; those of the faces need not be given
/// @throws InvalidQuery  for vertices that have neither two nor three coordinates
/// @throws InvalidMesh  as to_elements
template <typename Vertices, typename Elements, typename Edges = Eigen::Matrix<int, 0, 2>>
MeshElements mesh_elements(const Eigen::DenseBase<Vertices>& vertices, const Eigen::DenseBase<Elements>& elements,
                           const Eigen::DenseBase<Edges>& edges = Edges()) {
  if (vertices.cols() != 2 && vertices.cols() != 3) {
    throw InvalidQuery("the vertices are " + std::to_string(vertices.rows()) + " x " + std::to_string(vertices.cols()) +
                       ", not rows of two or three coordinates");
  }
  MeshElements made;
  made.vertex_count = static_cast<std::size_t>(vertices.rows());
  made.dimension = static_cast<int>(vertices.cols());
  if (elements.rows() > 0 && elements.cols() == 2) made.edges = to_elements<2>(elements);
  if (elements.rows() > 0 && elements.cols() != 2) made.faces = to_elements<3>(elements);
  if (edges.rows() == 0) return made;
  const auto more = to_elements<2>(edges);
  made.edges.insert(made.edges.end(), more.begin(), more.end());
  return made;
}

/// The mesh of matrices, as libigl and others name them: V, F, and E for further edges.
/// @param vertices, elements, edges  as for mesh_elements
/// @throws InvalidQuery, InvalidMesh  as mesh_elements and Mesh
template <typename Vertices, typename Elements, typename Edges = Eigen::Matrix<int, 0, 2>>
Mesh make_mesh(const Eigen::DenseBase<Vertices>& vertices, const Eigen::DenseBase<Elements>& elements,
               const Eigen::DenseBase<Edges>& edges = Edges()) {
  return Mesh(mesh_elements(vertices, elements, edges));
}

/// The functions of mesh.hpp for matrices or expressions of doubles or floats, one vertex a row. An expression is
/// evaluated once, in the caller's floating-point environment. They throw what those functions and to_positions do.
template <typename X0, typename X1>
FirstContact first_contact(const Mesh& mesh, const Eigen::DenseBase<X0>& x0, const Eigen::DenseBase<X1>& x1,
                           const FirstContactOptions& options = {}) {
  const auto& start = detail::eigen_values(x0);
  const auto& end = detail::eigen_values(x1);
  return first_contact(mesh, to_positions(start), to_positions(end), options);
}
/// As above. to_matrix makes a matrix of the positions.
template <typename X0, typename X1>
FreeStep free_step(const Mesh& mesh, const Eigen::DenseBase<X0>& x0, const Eigen::DenseBase<X1>& x1,
                   const FreeStepOptions& options = {}) {
  const auto& start = detail::eigen_values(x0);
  const auto& end = detail::eigen_values(x1);
  return free_step(mesh, to_positions(start), to_positions(end), options);
}
/// As above.
template <typename X>
std::vector<Intersection> intersections(const Mesh& mesh, const Eigen::DenseBase<X>& x,
                                        const MeshOptions& options = {}) {
  const auto& positions = detail::eigen_values(x);
  return intersections(mesh, to_positions(positions), options);
}

/// The positions of a FreeStep as a matrix, one vertex a row.
/// @param positions  the coordinates of the vertices
/// @param dimension  2 or 3, that of the mesh
inline Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> to_matrix(
    const std::vector<double>& positions, int dimension = 3) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Matrix>(positions.data(), static_cast<Eigen::Index>(positions.size()) / dimension, dimension);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
