// The frame of a curved query in polynomials of t, in doubles with bounds on their errors.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/curved_query.hpp>

#include "filters/curved/curved_form.hpp"
#include "geometry/vector.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

/// The corners, all multiplied by one positive polynomial; differences within an element only by a divisor of it.
/// Let A be corner 0, the first one of the first element, and B the first one of the second element.
struct CurvedFrame {
  bool known = false;  ///< false where an element's corners move in different ways, or sizes are extreme
  double factor = 1;   ///< a power of two that lengths are multiplied by, in addition to the polynomial
  VectorForm between;  ///< B - A
  /// Differences within the elements. Edges: a1 - a0 and b1 - b0. Vertex-face: f1 - f0 and f2 - f0. Point-edge: e1 - e0
  /// is the second one.
  VectorForm u, w;
  /// Fractions along an element are compared with these: the factors that `u` or `w` lacks.
  ScalarForm first_multiplier, second_multiplier;
};

/// @param query  valid
CurvedFrame curved_frame(const CurvedQuery& query) noexcept;

/// V = (u x w) . (B - A), up to its sign.
ScalarForm coplanarity_of(const CurvedFrame& frame) noexcept;

/// A coordinate of (B - A) x w, of degree at most 12: for a point and an edge.
ScalarForm cross_component_of(const CurvedFrame& frame, std::size_t axis) noexcept;

/// The same frame at one time in double-doubles.
struct FrameAt {
  using Vector = geometry::Vector<numbers::BoundedPair>;
  Vector between, u, w;
  numbers::BoundedPair first_multiplier, second_multiplier;
};
/// @param query  one whose curved_frame is known
/// @param t      in [0, 1]
FrameAt frame_at(const CurvedQuery& query, const numbers::BoundedPair& t) noexcept;

}  // namespace touchstone::filters
