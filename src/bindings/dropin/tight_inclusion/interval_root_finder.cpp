// SPDX-License-Identifier: MIT
#include <tight_inclusion/interval_root_finder.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <touchstone/error.hpp>

#include "dropin/tight_inclusion/exact_impact.hpp"

namespace ticcd {

using touchstone::dropin::Corners;
using touchstone::dropin::Impact;

template <bool is_vertex_face>
bool interval_root_finder_DFS(const Vector3& a_t0, const Vector3& b_t0, const Vector3& c_t0, const Vector3& d_t0,
                              const Vector3& a_t1, const Vector3& b_t1, const Vector3& c_t1, const Vector3& d_t1,
                              const Array3& /*tol*/, const Array3& /*err*/, const Scalar ms, Scalar& toi) {
  const auto query =
      touchstone::dropin::query_of(is_vertex_face, Corners{a_t0, b_t0, c_t0, d_t0}, Corners{a_t1, b_t1, c_t1, d_t1});
  const Impact impact = touchstone::dropin::first_impact(query, ms, 1);
  toi = impact.toi;
  return impact.exists;
}

template <bool is_vertex_face>
bool interval_root_finder_BFS(const Vector3& a_t0, const Vector3& b_t0, const Vector3& c_t0, const Vector3& d_t0,
                              const Vector3& a_t1, const Vector3& b_t1, const Vector3& c_t1, const Vector3& d_t1,
                              const Array3& /*tol*/, const Scalar co_domain_tolerance, const Array3& /*err*/,
                              const Scalar ms, const Scalar max_time, const long /*max_itr*/, Scalar& toi,
                              Scalar& output_tolerance) {
  const auto query =
      touchstone::dropin::query_of(is_vertex_face, Corners{a_t0, b_t0, c_t0, d_t0}, Corners{a_t1, b_t1, c_t1, d_t1});
  const Impact impact = touchstone::dropin::first_impact(query, ms, max_time);
  toi = impact.toi;
  output_tolerance = co_domain_tolerance;
  return impact.exists;
}

template bool interval_root_finder_DFS<false>(const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                              const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                              const Array3&, const Array3&, const Scalar, Scalar&);
template bool interval_root_finder_DFS<true>(const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                             const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                             const Array3&, const Array3&, const Scalar, Scalar&);
template bool interval_root_finder_BFS<false>(const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                              const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                              const Array3&, const Scalar, const Array3&, const Scalar, const Scalar,
                                              const long, Scalar&, Scalar&);
template bool interval_root_finder_BFS<true>(const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                             const Vector3&, const Vector3&, const Vector3&, const Vector3&,
                                             const Array3&, const Scalar, const Array3&, const Scalar, const Scalar,
                                             const long, Scalar&, Scalar&);

bool edge_edge_interval_root_finder_DFS(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0,
                                        const Vector3& eb1_t0, const Vector3& ea0_t1, const Vector3& ea1_t1,
                                        const Vector3& eb0_t1, const Vector3& eb1_t1, const Array3& tol,
                                        const Array3& err, const Scalar ms, Scalar& toi) {
  return interval_root_finder_DFS<false>(ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1, tol, err, ms,
                                         toi);
}

bool vertex_face_interval_root_finder_DFS(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0,
                                          const Vector3& f2_t0, const Vector3& v_t1, const Vector3& f0_t1,
                                          const Vector3& f1_t1, const Vector3& f2_t1, const Array3& tol,
                                          const Array3& err, const Scalar ms, Scalar& toi) {
  return interval_root_finder_DFS<true>(v_t0, f0_t0, f1_t0, f2_t0, v_t1, f0_t1, f1_t1, f2_t1, tol, err, ms, toi);
}

bool edge_edge_interval_root_finder_BFS(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0,
                                        const Vector3& eb1_t0, const Vector3& ea0_t1, const Vector3& ea1_t1,
                                        const Vector3& eb0_t1, const Vector3& eb1_t1, const Array3& tol,
                                        const Scalar co_domain_tolerance, const Array3& err, const Scalar ms,
                                        const Scalar max_time, const long max_itr, Scalar& toi,
                                        Scalar& output_tolerance) {
  return interval_root_finder_BFS<false>(ea0_t0, ea1_t0, eb0_t0, eb1_t0, ea0_t1, ea1_t1, eb0_t1, eb1_t1, tol,
                                         co_domain_tolerance, err, ms, max_time, max_itr, toi, output_tolerance);
}

bool vertex_face_interval_root_finder_BFS(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0,
                                          const Vector3& f2_t0, const Vector3& v_t1, const Vector3& f0_t1,
                                          const Vector3& f1_t1, const Vector3& f2_t1, const Array3& tol,
                                          const Scalar co_domain_tolerance, const Array3& err, const Scalar ms,
                                          const Scalar max_time, const long max_itr, Scalar& toi,
                                          Scalar& output_tolerance) {
  return interval_root_finder_BFS<true>(v_t0, f0_t0, f1_t0, f2_t0, v_t1, f0_t1, f1_t1, f2_t1, tol, co_domain_tolerance,
                                        err, ms, max_time, max_itr, toi, output_tolerance);
}

void print_times() {}

namespace {

// The published constants, in units of e = 2^-53. All coordinates on the axis are at most g in magnitude, and t, u and
// v lie in [0, 1]. Each line is the rounding error of one intermediate result of function_f_ee and function_f_vf, in
// units of e g, the errors of its operands included. The room below the constants is enough for the terms in e^2.
//
//   (x1 - x0) t + x0, a corner on its path: 2 + 2 + 1                              5
//   (a1 - a0) u, for two corners: 5 + 5 + 2 for the difference, 2 for the product  14
//   (a1 - a0) u + a0: 14 + 5 + 1                                                   20
//   edges: 20 + 20 + 2 for the difference                                          42
//   face: 20 + 14 + 3 for the sum of both products                                 37
//   vertex-face: 5 + 37 + 4 for the difference                                     46
//
// To add a separation of at most g and to compare costs less than 2 more. The cube g^3 is not less than g, as g >= 1.
constexpr Scalar kUnit = std::numeric_limits<Scalar>::epsilon() / 2;
constexpr Scalar kEdgeEdge = 56 * kUnit;
constexpr Scalar kVertexFace = 60 * kUnit;
constexpr Scalar kForSeparation = 8 * kUnit;

}  // namespace

Array3 get_numerical_error(const std::vector<Vector3>& vertices, const bool is_vertex_face,
                           const bool using_minimum_separation) {
  if (vertices.empty()) throw touchstone::InvalidQuery("an error bound needs one vertex or more");
  Array3 largest = Array3::Ones();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(vertices[i][k])) {
        throw touchstone::InvalidQuery("vertex " + std::to_string(i) + " has the coordinate " +
                                       std::to_string(vertices[i][k]) + ", which is not finite");
      }
      largest[k] = std::max(largest[k], std::abs(vertices[i][k]));
    }
  }
  const Scalar constant = (is_vertex_face ? kVertexFace : kEdgeEdge) + (using_minimum_separation ? kForSeparation : 0);
  return constant * largest * largest * largest;
}

}  // namespace ticcd
