// The two elements relative to one another, in doubles, scaled so that nothing overflows.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

#include "geometry/vector.hpp"

namespace touchstone::baselines {

using Vector = geometry::Vector<double>;

inline Vector operator+(const Vector& a, const Vector& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
inline Vector operator*(double s, const Vector& a) { return {{s * a[0], s * a[1], s * a[2]}}; }
inline Vector operator-(const Vector& a) { return {{-a[0], -a[1], -a[2]}}; }

/// A vector that is linear in t.
struct Motion {
  Vector start{};
  Vector end{};

  Vector delta() const { return end - start; }
  Vector at(double t) const { return (1 - t) * start + t * end; }  // exact at both ends
};

inline Motion operator+(const Motion& a, const Motion& b) { return {a.start + b.start, a.end + b.end}; }
inline Motion operator-(const Motion& a, const Motion& b) { return {a.start - b.start, a.end - b.end}; }
inline Motion operator-(const Motion& a) { return {-a.start, -a.end}; }

/// The vectors of the design's formulas:
/// edge-edge    u = a1 - a0, w = b1 - b0, r = b0 - a0;
/// vertex-face  u = f1 - f0, w = f2 - f0, r = v - f0;
/// point-edge   u = e1 - e0, w = 0,       r = p - e0;
/// point-point  u = 0,       w = 0,       r = q - p.
/// They are differences of the coordinates, rounded, times 2^-exponent; the largest component is in [1/2, 1), or 0.
struct Frame {
  Kind kind = Kind::edge_edge;
  Motion u, w, r;
  int exponent = 0;
  double box = 0;  ///< the product of the largest components of u, w and r
};

Frame frame_of(const Query& query);

}  // namespace touchstone::baselines
