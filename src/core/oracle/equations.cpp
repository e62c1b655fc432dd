// Orientation determinants of moving corners.
// SPDX-License-Identifier: MIT
#include "oracle/equations.hpp"

#include <CGAL/determinant.h>

namespace touchstone::oracle {
namespace {

Polynomial orientation_in_space(const Corners& c) {
  const Polynomial one(Integer(1));
  return CGAL::determinant(one, c[0][0], c[0][1], c[0][2],  //
                           one, c[1][0], c[1][1], c[1][2],  //
                           one, c[2][0], c[2][1], c[2][2],  //
                           one, c[3][0], c[3][1], c[3][2]);
}

void add_orientations(std::vector<Polynomial>& to, const Corner& P, const Corner& Q, const Corner& R) {
  for (std::size_t axis = 0; axis < 3; ++axis) to.push_back(orientation(axis, P, Q, R));
}

void add_differences(std::vector<Polynomial>& to, const Corner& P, const Corner& Q) {
  for (std::size_t axis = 0; axis < 3; ++axis) to.push_back(P[axis] - Q[axis]);
}

}  // namespace

Polynomial orientation(std::size_t axis, const Corner& P, const Corner& Q, const Corner& R) {
  const Polynomial one(Integer(1));
  const std::size_t i = (axis + 1) % 3;
  const std::size_t j = (axis + 2) % 3;
  return CGAL::determinant(one, P[i], P[j], one, Q[i], Q[j], one, R[i], R[j]);
}

std::vector<Polynomial> contact_equations(Kind kind, const Corners& c) {
  std::vector<Polynomial> equations;
  switch (kind) {
    case Kind::edge_edge:
    case Kind::vertex_face: equations.push_back(orientation_in_space(c)); break;
    case Kind::point_edge: add_orientations(equations, c[0], c[1], c[2]); break;
    case Kind::point_point: add_differences(equations, c[0], c[1]); break;
  }
  return equations;
}

std::vector<Polynomial> deciding_polynomials(Kind kind, const Corners& c) {
  std::vector<Polynomial> deciding;
  switch (kind) {
    case Kind::edge_edge:
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Polynomial abc = orientation(axis, c[0], c[1], c[2]);
        const Polynomial abd = orientation(axis, c[0], c[1], c[3]);
        deciding.insert(deciding.end(), {abc, abd, abd - abc});
      }
      add_orientations(deciding, c[2], c[3], c[0]);
      add_orientations(deciding, c[2], c[3], c[1]);
      for (const std::size_t a : {0U, 1U}) {
        for (const std::size_t b : {2U, 3U}) add_differences(deciding, c[a], c[b]);
      }
      break;
    case Kind::vertex_face:
      add_orientations(deciding, c[1], c[2], c[3]);
      add_orientations(deciding, c[0], c[2], c[3]);
      add_orientations(deciding, c[1], c[0], c[3]);
      add_orientations(deciding, c[1], c[2], c[0]);
      for (const std::size_t f : {1U, 2U, 3U}) add_differences(deciding, c[0], c[f]);
      break;
    case Kind::point_edge:
      add_differences(deciding, c[0], c[1]);
      add_differences(deciding, c[0], c[2]);
      break;
    case Kind::point_point: break;
  }
  return deciding;
}

}  // namespace touchstone::oracle
