// A query asked through the interface of Tight-Inclusion, with its many arguments by name.
// SPDX-License-Identifier: MIT
#pragma once

#include <tight_inclusion/ccd.hpp>
#include <tight_inclusion/interval_root_finder.hpp>

#include <array>

#include <touchstone/query.hpp>

namespace touchstone::tests {

/// The arguments after the corners, as most programs give them.
struct Call {
  ticcd::Array3 err = ticcd::Array3(-1, -1, -1);
  double ms = 0;
  double tolerance = 1e-6;
  double t_max = 1;
  long max_itr = 1000000;
  bool no_zero_toi = false;
  ticcd::CCDRootFindingMethod method = ticcd::CCDRootFindingMethod::BREADTH_FIRST_SEARCH;
};

/// What comes back.
struct Impact {
  bool exists = false;
  double toi = -1;
  double output_tolerance = -1;
};

using EigenCorners = std::array<ticcd::Vector3, 8>;

/// The corners at t = 0, then those at t = 1.
inline EigenCorners eigen_corners(const Query& query) {
  EigenCorners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = {query.start[i].x, query.start[i].y, query.start[i].z};
    corners[i + 4] = {query.end[i].x, query.end[i].y, query.end[i].z};
  }
  return corners;
}

inline bool ask(const Query& query, const Call& call, double& toi, double& output_tolerance) {
  const EigenCorners x = eigen_corners(query);
  const auto function = query.kind == Kind::edge_edge ? ticcd::edgeEdgeCCD : ticcd::vertexFaceCCD;
  return function(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], call.err, call.ms, toi, call.tolerance, call.t_max,
                  call.max_itr, output_tolerance, call.no_zero_toi, call.method);
}

inline Impact ask(const Query& query, const Call& call) {
  Impact impact;
  impact.exists = ask(query, call, impact.toi, impact.output_tolerance);
  return impact;
}

inline Impact ask_depth_first(const Query& query, double ms) {
  const EigenCorners x = eigen_corners(query);
  const ticcd::Array3 none = ticcd::Array3::Zero();
  const auto function = query.kind == Kind::edge_edge ? ticcd::edge_edge_interval_root_finder_DFS
                                                      : ticcd::vertex_face_interval_root_finder_DFS;
  Impact impact;
  impact.exists = function(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], none, none, ms, impact.toi);
  return impact;
}

inline Impact ask_breadth_first(const Query& query, double ms, double max_time) {
  const EigenCorners x = eigen_corners(query);
  const ticcd::Array3 none = ticcd::Array3::Zero();
  const auto function = query.kind == Kind::edge_edge ? ticcd::edge_edge_interval_root_finder_BFS
                                                      : ticcd::vertex_face_interval_root_finder_BFS;
  Impact impact;
  impact.exists = function(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], none, 1e-6, none, ms, max_time, 1000000,
                           impact.toi, impact.output_tolerance);
  return impact;
}

/// A vertex above the middle of a face at rest, at these heights.
inline VertexFace falling_vertex(double start, double end) {
  const Vec3 f0{-1, -1, 0}, f1{1, -1, 0}, f2{0, 1, 0};
  return {{Vec3{0.25, 0, start}, f0, f1, f2}, {Vec3{0.25, 0, end}, f0, f1, f2}};
}

}  // namespace touchstone::tests
