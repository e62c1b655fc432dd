// SPDX-License-Identifier: MIT
#include <tight_inclusion/ccd.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dropin/tight_inclusion/exact_impact.hpp"

namespace ticcd {

namespace {

using touchstone::dropin::Corners;
using touchstone::dropin::Impact;

/// What both functions do with their arguments. The output arguments are set last, so that an exception leaves them.
bool answer(const touchstone::Query& query, Scalar ms, Scalar& toi, Scalar tolerance, Scalar t_max,
            Scalar& output_tolerance, bool no_zero_toi) {
  const Impact impact = no_zero_toi ? touchstone::dropin::first_impact_after_start(query, ms, t_max)
                                    : touchstone::dropin::first_impact(query, ms, t_max);
  toi = impact.toi;
  output_tolerance = tolerance;
  return impact.exists;
}

/// The largest absolute coordinate.
Scalar length(const Vector3& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// The width of a parameter over whose whole range no coordinate changes by more than `change`.
Scalar width_for(Scalar distance_tolerance, Scalar change) {
  return change > 0 ? distance_tolerance / (3 * change) : std::numeric_limits<Scalar>::infinity();
}

}  // namespace

bool edgeEdgeCCD(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0, const Vector3& eb1_t0,
                 const Vector3& ea0_t1, const Vector3& ea1_t1, const Vector3& eb0_t1, const Vector3& eb1_t1,
                 const Array3& /*err*/, const Scalar ms, Scalar& toi, const Scalar tolerance, const Scalar t_max,
                 const long /*max_itr*/, Scalar& output_tolerance, bool no_zero_toi,
                 const CCDRootFindingMethod /*ccd_method*/) {
  const auto query = touchstone::dropin::query_of(false, Corners{ea0_t0, ea1_t0, eb0_t0, eb1_t0},
                                                  Corners{ea0_t1, ea1_t1, eb0_t1, eb1_t1});
  return answer(query, ms, toi, tolerance, t_max, output_tolerance, no_zero_toi);
}

bool vertexFaceCCD(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0, const Vector3& f2_t0,
                   const Vector3& v_t1, const Vector3& f0_t1, const Vector3& f1_t1, const Vector3& f2_t1,
                   const Array3& /*err*/, const Scalar ms, Scalar& toi, const Scalar tolerance, const Scalar t_max,
                   const long /*max_itr*/, Scalar& output_tolerance, bool no_zero_toi,
                   const CCDRootFindingMethod /*ccd_method*/) {
  const auto query = touchstone::dropin::query_of(true, Corners{v_t0, f0_t0, f1_t0, f2_t0},  //
                                                  Corners{v_t1, f0_t1, f1_t1, f2_t1});
  return answer(query, ms, toi, tolerance, t_max, output_tolerance, no_zero_toi);
}

// The difference of two points is affine in each of t, u and v, so a coordinate of it changes most between the corners
// of the parameters' cube. On the face the cube's corner u = v = 1 is f1 + f2 - f0.
Array3 compute_vertex_face_tolerances(const Vector3& v_t0, const Vector3& f0_t0, const Vector3& f1_t0,
                                      const Vector3& f2_t0, const Vector3& v_t1, const Vector3& f0_t1,
                                      const Vector3& f1_t1, const Vector3& f2_t1, const Scalar distance_tolerance) {
  const Vector3 v = v_t1 - v_t0, f0 = f0_t1 - f0_t0, f1 = f1_t1 - f1_t0, f2 = f2_t1 - f2_t0;
  const Scalar by_t = std::max({length(v - f0), length(v - f1), length(v - f2), length(v - (f1 + f2 - f0))});
  const Scalar by_u = std::max(length(f1_t0 - f0_t0), length(f1_t1 - f0_t1));
  const Scalar by_v = std::max(length(f2_t0 - f0_t0), length(f2_t1 - f0_t1));
  return {width_for(distance_tolerance, by_t), width_for(distance_tolerance, by_u),
          width_for(distance_tolerance, by_v)};
}

Array3 compute_edge_edge_tolerances(const Vector3& ea0_t0, const Vector3& ea1_t0, const Vector3& eb0_t0,
                                    const Vector3& eb1_t0, const Vector3& ea0_t1, const Vector3& ea1_t1,
                                    const Vector3& eb0_t1, const Vector3& eb1_t1, const Scalar distance_tolerance) {
  const Vector3 a0 = ea0_t1 - ea0_t0, a1 = ea1_t1 - ea1_t0, b0 = eb0_t1 - eb0_t0, b1 = eb1_t1 - eb1_t0;
  const Scalar by_t = std::max({length(a0 - b0), length(a0 - b1), length(a1 - b0), length(a1 - b1)});
  const Scalar by_u = std::max(length(ea1_t0 - ea0_t0), length(ea1_t1 - ea0_t1));
  const Scalar by_v = std::max(length(eb1_t0 - eb0_t0), length(eb1_t1 - eb0_t1));
  return {width_for(distance_tolerance, by_t), width_for(distance_tolerance, by_u),
          width_for(distance_tolerance, by_v)};
}

long return_queue_size() { return 0; }

}  // namespace ticcd
