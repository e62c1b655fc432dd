// Touchstone's drop-in for Tight-Inclusion: vertex-face and edge-edge queries, answered exactly.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <tight_inclusion/config.hpp>
#include <tight_inclusion/interval.hpp>
#include <tight_inclusion/types.hpp>

namespace ticcd {

static constexpr bool DEFAULT_NO_ZERO_TOI = false;        ///< see `no_zero_toi` of edgeEdgeCCD
static constexpr Scalar DEFAULT_CCD_DISTANCE_TOL = 1e-6;  ///< a length, in the unit of the coordinates

/// How Tight-Inclusion searches. The drop-in gives the same answer for both.
enum class CCDRootFindingMethod {
  DEPTH_FIRST_SEARCH,
  BREADTH_FIRST_SEARCH,
};

/// Whether two moving edges are ever within `ms` of each other in [0, t_max], and since when: decided exactly. Each
/// corner moves on a straight line from its position at t = 0 to its position at t = 1. The distance is measured by the
/// largest absolute coordinate (the L-infinity metric), as Tight-Inclusion does; with ms = 0 the edges touch.
///
/// @param[in] ea0_t0  first corner of the first edge at t = 0; all coordinates are finite, in one unit of length
/// @param[in] ea1_t0  second corner of the first edge at t = 0
/// @param[in] eb0_t0  first corner of the second edge at t = 0
/// @param[in] eb1_t0  second corner of the second edge at t = 0
/// @param[in] ea0_t1  first corner of the first edge at t = 1
/// @param[in] ea1_t1  second corner of the first edge at t = 1
/// @param[in] eb0_t1  first corner of the second edge at t = 1
/// @param[in] eb1_t1  second corner of the second edge at t = 1
/// @param[in] err  not needed, not read: no answer depends on a rounding error
/// @param[in] ms  the minimum separation, finite and not negative, compared exactly; a distance equal to it is a
/// contact
/// @param[out] toi  the greatest double that is not after the exact first time; infinity without contact. It is 0 for
///                  elements that are within `ms` of each other at t = 0. It is 0 for no others, except where the exact
///                  first time is less than the least positive double, 2^-1074.
/// @param[in] tolerance  not needed: the answer is exact
/// @param[in] t_max  the end of the time range, 0 <= t_max <= 1
/// @param[in] max_itr  not needed: no answer is given up
/// @param[out] output_tolerance  becomes `tolerance`, which says that the answer is as precise as was asked for
/// @param[in] no_zero_toi  true: elements that are within `ms` of each other at t = 0 without touching are asked about
///                  a smaller separation, so that `toi` is greater than 0. It is the first of ms/2, ms/4, ms/8, ...
///                  that is at most half of their distance at t = 0. The return value is then about this separation.
/// @param[in] ccd_method  both methods give the same answer
/// @return whether there is a contact; `toi` is finite exactly when there is
/// @throws touchstone::InvalidQuery  for a NaN or infinite coordinate, an `ms` that is negative or not finite, or a
///                  t_max outside [0, 1]; `toi` and `output_tolerance` are then unchanged
bool edgeEdgeCCD(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0, const Vector3& eb1_t0,
                 const Vector3& ea0_t1, const Vector3& ea1_t1, const Vector3& eb0_t1, const Vector3& eb1_t1,
                 const Array3& err, const Scalar ms, Scalar& toi, const Scalar tolerance, const Scalar t_max,
                 const long max_itr, Scalar& output_tolerance, bool no_zero_toi = DEFAULT_NO_ZERO_TOI,
                 const CCDRootFindingMethod ccd_method = CCDRootFindingMethod::BREADTH_FIRST_SEARCH);

/// The same for a moving vertex and a moving triangle. All arguments after the corners are as in edgeEdgeCCD.
///
/// @param[in] v_t0  the vertex at t = 0
/// @param[in] f0_t0  first corner of the triangle at t = 0
/// @param[in] f1_t0  second corner of the triangle at t = 0
/// @param[in] f2_t0  third corner of the triangle at t = 0
/// @param[in] v_t1  the vertex at t = 1
/// @param[in] f0_t1  first corner of the triangle at t = 1
/// @param[in] f1_t1  second corner of the triangle at t = 1
/// @param[in] f2_t1  third corner of the triangle at t = 1
/// @param[in] err  not needed, not read
/// @param[in] ms  the minimum separation
/// @param[out] toi  the greatest double that is not after the exact first time; infinity without contact
/// @param[in] tolerance  not needed
/// @param[in] t_max  the end of the time range, 0 <= t_max <= 1
/// @param[in] max_itr  not needed
/// @param[out] output_tolerance  becomes `tolerance`
/// @param[in] no_zero_toi  whether `toi` is to be greater than 0 for elements that do not touch at t = 0
/// @param[in] ccd_method  both methods give the same answer
/// @return whether there is a contact
/// @throws touchstone::InvalidQuery  as edgeEdgeCCD
bool vertexFaceCCD(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0, const Vector3& f2_t0,
                   const Vector3& v_t1, const Vector3& f0_t1, const Vector3& f1_t1, const Vector3& f2_t1,
                   const Array3& err, const Scalar ms, Scalar& toi, const Scalar tolerance, const Scalar t_max,
                   const long max_itr, Scalar& output_tolerance, bool no_zero_toi = DEFAULT_NO_ZERO_TOI,
                   const CCDRootFindingMethod ccd_method = CCDRootFindingMethod::BREADTH_FIRST_SEARCH);

/// The widths of t, u and v at which a box of parameters moves the difference of two points, v - f(u, v), by at most
/// distance_tolerance along each axis: distance_tolerance / (3 L), where L is the greatest change of a coordinate of
/// the difference over the whole range of the parameter. (Wang, Ferguson, Schneider, Jiang, Attene and Panozzo 2021, "A
/// large scale benchmark and an inclusion-based algorithm for continuous collision detection".) A width is infinite
/// where nothing changes. The answers of the drop-in do not need them.
///
/// @param[in] v_t0  the vertex at t = 0
/// @param[in] f0_t0  first corner of the triangle at t = 0
/// @param[in] f1_t0  second corner of the triangle at t = 0, where u = 1
/// @param[in] f2_t0  third corner of the triangle at t = 0, where v = 1
/// @param[in] v_t1  the vertex at t = 1
/// @param[in] f0_t1  first corner of the triangle at t = 1
/// @param[in] f1_t1  second corner of the triangle at t = 1
/// @param[in] f2_t1  third corner of the triangle at t = 1
/// @param[in] distance_tolerance  a length greater than 0
/// @return the widths of t, u and v
Array3 compute_vertex_face_tolerances(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0,
                                      const Vector3& f2_t0, const Vector3& v_t1, const Vector3& f0_t1,
                                      const Vector3& f1_t1, const Vector3& f2_t1,
                                      const Scalar distance_tolerance = DEFAULT_CCD_DISTANCE_TOL);

/// The same for two edges: u runs along the first and v along the second.
///
/// @param[in] ea0_t0  first corner of the first edge at t = 0
/// @param[in] ea1_t0  second corner of the first edge at t = 0
/// @param[in] eb0_t0  first corner of the second edge at t = 0
/// @param[in] eb1_t0  second corner of the second edge at t = 0
/// @param[in] ea0_t1  first corner of the first edge at t = 1
/// @param[in] ea1_t1  second corner of the first edge at t = 1
/// @param[in] eb0_t1  first corner of the second edge at t = 1
/// @param[in] eb1_t1  second corner of the second edge at t = 1
/// @param[in] distance_tolerance  a length greater than 0
/// @return the widths of t, u and v
Array3 compute_edge_edge_tolerances(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0,
                                    const Vector3& eb1_t0, const Vector3& ea0_t1, const Vector3& ea1_t1,
                                    const Vector3& eb0_t1, const Vector3& eb1_t1,
                                    const Scalar distance_tolerance = DEFAULT_CCD_DISTANCE_TOL);

/// The length of the longest queue of boxes. The drop-in has no queue: always 0.
long return_queue_size();

}  // namespace ticcd
