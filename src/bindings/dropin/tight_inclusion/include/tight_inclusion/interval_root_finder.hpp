// Touchstone's drop-in for Tight-Inclusion: its root finders, which answer exactly too, and its error bound.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <tight_inclusion/config.hpp>
#include <tight_inclusion/interval.hpp>
#include <tight_inclusion/types.hpp>

namespace ticcd {

/// Whether two moving elements are ever within `ms` of each other in [0, 1], and since when, decided exactly: the
/// answer of edgeEdgeCCD or vertexFaceCCD (tight_inclusion/ccd.hpp) with t_max = 1. A contact at t = 1 is a contact.
///
/// @param[in] a_t0  first corner at t = 0: of the first edge, or the vertex
/// @param[in] b_t0  second corner at t = 0: of the first edge, or the first of the triangle
/// @param[in] c_t0  third corner at t = 0: the first of the second edge, or the second of the triangle
/// @param[in] d_t0  fourth corner at t = 0
/// @param[in] a_t1  first corner at t = 1
/// @param[in] b_t1  second corner at t = 1
/// @param[in] c_t1  third corner at t = 1
/// @param[in] d_t1  fourth corner at t = 1
/// @param[in] tol  not needed, not read
/// @param[in] err  not needed, not read
/// @param[in] ms  the minimum separation, finite and not negative
/// @param[out] toi  the greatest double that is not after the exact first time; infinity without contact
/// @tparam is_vertex_face  whether the elements are a vertex and a triangle, not two edges
/// @return whether there is a contact
/// @throws touchstone::InvalidQuery  for a NaN or infinite coordinate, or an `ms` that is negative or not finite
template <bool is_vertex_face>
bool interval_root_finder_DFS(const Vector3& a_t0, const Vector3& b_t0, const Vector3& c_t0, const Vector3& d_t0,
                              const Vector3& a_t1, const Vector3& b_t1, const Vector3& c_t1, const Vector3& d_t1,
                              const Array3& tol, const Array3& err, const Scalar ms, Scalar& toi);

/// interval_root_finder_DFS<false>: two edges.
bool edge_edge_interval_root_finder_DFS(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0,
                                        const Vector3& eb1_t0, const Vector3& ea0_t1, const Vector3& ea1_t1,
                                        const Vector3& eb0_t1, const Vector3& eb1_t1, const Array3& tol,
                                        const Array3& err, const Scalar ms, Scalar& toi);

/// interval_root_finder_DFS<true>: a vertex and a triangle.
bool vertex_face_interval_root_finder_DFS(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0,
                                          const Vector3& f2_t0, const Vector3& v_t1, const Vector3& f0_t1,
                                          const Vector3& f1_t1, const Vector3& f2_t1, const Array3& tol,
                                          const Array3& err, const Scalar ms, Scalar& toi);

/// The same for the times in [0, max_time].
///
/// @param[in] a_t0  first corner at t = 0: of the first edge, or the vertex
/// @param[in] b_t0  second corner at t = 0: of the first edge, or the first of the triangle
/// @param[in] c_t0  third corner at t = 0: the first of the second edge, or the second of the triangle
/// @param[in] d_t0  fourth corner at t = 0
/// @param[in] a_t1  first corner at t = 1
/// @param[in] b_t1  second corner at t = 1
/// @param[in] c_t1  third corner at t = 1
/// @param[in] d_t1  fourth corner at t = 1
/// @param[in] tol  not needed, not read
/// @param[in] co_domain_tolerance  not needed
/// @param[in] err  not needed, not read
/// @param[in] ms  the minimum separation, finite and not negative
/// @param[in] max_time  the end of the time range, 0 <= max_time <= 1
/// @param[in] max_itr  not needed
/// @param[out] toi  the greatest double that is not after the exact first time; infinity without contact
/// @param[out] output_tolerance  becomes `co_domain_tolerance`
/// @tparam is_vertex_face  whether the elements are a vertex and a triangle, not two edges
/// @return whether there is a contact
/// @throws touchstone::InvalidQuery  for a NaN or infinite coordinate, an `ms` that is negative or not finite, or a
///                                   max_time outside [0, 1]
template <bool is_vertex_face>
bool interval_root_finder_BFS(const Vector3& a_t0, const Vector3& b_t0, const Vector3& c_t0, const Vector3& d_t0,
                              const Vector3& a_t1, const Vector3& b_t1, const Vector3& c_t1, const Vector3& d_t1,
                              const Array3& tol, const Scalar co_domain_tolerance, const Array3& err, const Scalar ms,
                              const Scalar max_time, const long max_itr, Scalar& toi, Scalar& output_tolerance);

/// interval_root_finder_BFS<false>: two edges.
bool edge_edge_interval_root_finder_BFS(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0,
                                        const Vector3& eb1_t0, const Vector3& ea0_t1, const Vector3& ea1_t1,
                                        const Vector3& eb0_t1, const Vector3& eb1_t1, const Array3& tol,
                                        const Scalar co_domain_tolerance, const Array3& err, const Scalar ms,
                                        const Scalar max_time, const long max_itr, Scalar& toi,
                                        Scalar& output_tolerance);

/// interval_root_finder_BFS<true>: a vertex and a triangle.
bool vertex_face_interval_root_finder_BFS(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0,
                                          const Vector3& f2_t0, const Vector3& v_t1, const Vector3& f0_t1,
                                          const Vector3& f1_t1, const Vector3& f2_t1, const Array3& tol,
                                          const Scalar co_domain_tolerance, const Array3& err, const Scalar ms,
                                          const Scalar max_time, const long max_itr, Scalar& toi,
                                          Scalar& output_tolerance);

namespace detail {

/// A coordinate of a corner at the fraction t of its path.
template <typename T>
T on_path(T t, Scalar from, Scalar to) {
  return (static_cast<T>(to) - static_cast<T>(from)) * t + static_cast<T>(from);
}

}  // namespace detail

/// A coordinate of the difference of two points, one of each edge, in T's arithmetic: A(t, u) - B(t, v).
/// @param tpara  the time t
/// @param upara  the fraction u of the first edge
/// @param vpara  the fraction v of the second edge
/// @param dim  the coordinate: 0, 1 or 2
/// @param ea0_t0  first corner of the first edge at t = 0
/// @param ea1_t0  second corner of the first edge at t = 0
/// @param eb0_t0  first corner of the second edge at t = 0
/// @param eb1_t0  second corner of the second edge at t = 0
/// @param ea0_t1  first corner of the first edge at t = 1
/// @param ea1_t1  second corner of the first edge at t = 1
/// @param eb0_t1  first corner of the second edge at t = 1
/// @param eb1_t1  second corner of the second edge at t = 1
template <typename T>
T function_f_ee(const NumCCD& tpara, const NumCCD& upara, const NumCCD& vpara, const int dim, const Vector3& ea0_t0,
                const Vector3& ea1_t0, const Vector3& eb0_t0, const Vector3& eb1_t0, const Vector3& ea0_t1,
                const Vector3& ea1_t1, const Vector3& eb0_t1, const Vector3& eb1_t1) {
  const T t = static_cast<T>(tpara.value()), u = static_cast<T>(upara.value()), v = static_cast<T>(vpara.value());
  const T a0 = detail::on_path(t, ea0_t0[dim], ea0_t1[dim]), a1 = detail::on_path(t, ea1_t0[dim], ea1_t1[dim]);
  const T b0 = detail::on_path(t, eb0_t0[dim], eb0_t1[dim]), b1 = detail::on_path(t, eb1_t0[dim], eb1_t1[dim]);
  return ((a1 - a0) * u + a0) - ((b1 - b0) * v + b0);
}

/// A coordinate of the difference of the vertex and a point of the triangle, in T's arithmetic: v(t) - F(t, u, v).
/// @param tpara  the time t
/// @param upara  the weight u of the triangle's second corner
/// @param vpara  the weight v of the triangle's third corner
/// @param dim  the coordinate: 0, 1 or 2
/// @param v_t0  the vertex at t = 0
/// @param f0_t0  first corner of the triangle at t = 0
/// @param f1_t0  second corner of the triangle at t = 0
/// @param f2_t0  third corner of the triangle at t = 0
/// @param v_t1  the vertex at t = 1
/// @param f0_t1  first corner of the triangle at t = 1
/// @param f1_t1  second corner of the triangle at t = 1
/// @param f2_t1  third corner of the triangle at t = 1
template <typename T>
T function_f_vf(const NumCCD& tpara, const NumCCD& upara, const NumCCD& vpara, const int dim, const Vector3& v_t0,
                const Vector3& f0_t0, const Vector3& f1_t0, const Vector3& f2_t0, const Vector3& v_t1,
                const Vector3& f0_t1, const Vector3& f1_t1, const Vector3& f2_t1) {
  const T t = static_cast<T>(tpara.value()), u = static_cast<T>(upara.value()), v = static_cast<T>(vpara.value());
  const T p = detail::on_path(t, v_t0[dim], v_t1[dim]), f0 = detail::on_path(t, f0_t0[dim], f0_t1[dim]);
  const T f1 = detail::on_path(t, f1_t0[dim], f1_t1[dim]), f2 = detail::on_path(t, f2_t0[dim], f2_t1[dim]);
  return p - (((f1 - f0) * u + f0) + (f2 - f0) * v);
}

/// Prints the times that the parts of Tight-Inclusion took. The drop-in measures none, and prints nothing.
void print_times();

/// A bound on the rounding error of function_f_ee<double> or function_f_vf<double>, for each axis: the filter of Wang
/// et al. 2021, c g^3 with g = max(1, the largest absolute coordinate on the axis). It holds at every scale.
/// (Tight-Inclusion 1.0.1 and later take the minimum in place of the maximum. Their bound is too small for coordinates
/// that are not near 1, because the error is in proportion to the coordinates.) The answers of the drop-in do not need
/// the bound.
/// @param vertices  corners of a box that contains the whole scene at all times, or the corners of one query at both
///                  ends of the step; at least one
/// @param is_vertex_face  whether the bound is for a vertex and a triangle, not two edges
/// @param using_minimum_separation  whether a separation is added to the bound afterwards, in doubles; the separation
///                                  is then at most g on each axis
/// @return the bound for each axis
/// @throws touchstone::InvalidQuery  without vertices, or for a NaN or infinite coordinate
Array3 get_numerical_error(const std::vector<Vector3>& vertices, const bool is_vertex_face,
                           const bool using_minimum_separation);

}  // namespace ticcd
