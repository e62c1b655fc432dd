// The frame u, w, r of an edge-edge or vertex-face query and the polynomials built on it, written once for every number
// type: doubles, vectors of doubles, error-bounded doubles, integers, and polynomials in t over any of them.
//
// The oracle and the baselines do not use this file. They are independent deciders, and a wrong formula here must not
// be able to deceive them too.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>

#include "geometry/inline.hpp"
#include "geometry/vector.hpp"

namespace touchstone::geometry {

/// Edge-edge:   u = a1 - a0, w = b1 - b0, r = b0 - a0.
/// Vertex-face: u = f1 - f0, w = f2 - f0, r = v - f0.
///
/// The corners are coplanar where V = (u x w) . r is zero. Where they are and n = u x w is not zero, choose an axis k
/// with n_k != 0:
/// - two edges meet at the fraction (r x w)_k / n_k of the first and at the fraction (r x u)_k / n_k of the second;
/// - a vertex has the weight (r x w)_k / n_k at f1, the weight (u x r)_k / n_k at f2, and the rest at f0.
template <class V>
struct Frame {
  V u, w, r;
};

/// The frame of an edge-edge or vertex-face query, from difference(i, j): corner i minus corner j.
template <class Difference>
TOUCHSTONE_INLINE auto frame_of(Kind kind, const Difference& difference) -> Frame<decltype(difference(0, 0))> {
  if (kind == Kind::edge_edge) return {difference(1, 0), difference(3, 2), difference(2, 0)};
  return {difference(2, 1), difference(3, 1), difference(0, 1)};
}

/// n = u x w.
template <class V>
TOUCHSTONE_INLINE auto normal(const Frame<V>& f) {
  return cross(f.u, f.w);
}

/// V = n . r.
template <class V>
TOUCHSTONE_INLINE auto coplanarity(const Frame<V>& f) {
  return dot(normal(f), f.r);
}

/// The gradient of V by each corner, from those by u, w and r: w x r, r x u and n.
template <class V>
TOUCHSTONE_INLINE std::array<V, 4> gradient_by_corners(Kind kind, const Frame<V>& by) {
  if (kind == Kind::edge_edge) return {-(by.u + by.r), by.u, by.r - by.w, by.w};
  return {by.r, -(by.u + by.w + by.r), by.u, by.w};
}

/// The numerator of the first fraction or weight along an axis: (r x w)_k. The denominator is n_k.
template <class V>
TOUCHSTONE_INLINE auto first_numerator(const Frame<V>& f, std::size_t axis) {
  return cross_component(f.r, f.w, axis);
}

/// The numerator of the second one: (r x u)_k for edges, (u x r)_k for a face.
template <class V>
TOUCHSTONE_INLINE auto second_numerator(Kind kind, const Frame<V>& f, std::size_t axis) {
  return kind == Kind::edge_edge ? cross_component(f.r, f.u, axis) : cross_component(f.u, f.r, axis);
}

}  // namespace touchstone::geometry
