// Points on segments, coordinate by coordinate.
// SPDX-License-Identifier: MIT
#include "oracle/feature_point.hpp"

#include "oracle/equations.hpp"

namespace touchstone::oracle {

bool coincide(const Moment& at, const Corner& P, const Corner& Q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.sign(P[axis] - Q[axis]) != CGAL::ZERO) return false;
  }
  return true;
}

bool is_on_segment(const Moment& at, const Corner& P, const Corner& X, const Corner& Y) {
  // On the line, P = X + s (Y - X) and (P - X)_k (P - Y)_k = s (s - 1) (Y - X)_k^2: not positive for all k exactly
  // when s is in [0, 1]. Where X = Y it is (P - X)_k^2, and P must be there too.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.sign(P[axis] - X[axis]) * at.sign(P[axis] - Y[axis]) > 0) return false;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.sign(orientation(axis, P, X, Y)) != CGAL::ZERO) return false;
  }
  return true;
}

CGAL::Sign relative_direction(const Moment& at, const Corner& X, const Corner& Y, const Corner& P, const Corner& Q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const CGAL::Sign product = at.sign(Y[axis] - X[axis]) * at.sign(Q[axis] - P[axis]);
    if (product != CGAL::ZERO) return product;
  }
  return CGAL::ZERO;
}

FeaturePoint point_on_edge(const Moment& at, const Corner& P, const Corner& X, const Corner& Y,
                           const EdgeNames& names) {
  if (coincide(at, P, X)) return {names.start, {1, 0, 0}};
  if (coincide(at, P, Y)) return {names.end, {0, 1, 0}};
  std::size_t axis = 0;  // the edge has a length, so one of its coordinates has
  while (at.sign(Y[axis] - X[axis]) == CGAL::ZERO) ++axis;
  const double along = at.ratio(P[axis] - X[axis], Y[axis] - X[axis]);
  return {names.interior, {1 - along, along, 0}};
}

}  // namespace touchstone::oracle
