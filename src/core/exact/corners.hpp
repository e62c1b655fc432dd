// From a query to moving corners in exact numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <type_traits>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "exact/common_scale.hpp"
#include "exact/elements.hpp"
#include "exact/off_the_stack.hpp"

namespace touchstone::exact {

/// The corners of a query, all multiplied by one positive number, which changes no touching time, nature, feature or
/// weight. For integer types, that number makes all coordinates integers; the caller makes sure that they have at most
/// kMostBits. For Exact, it makes the largest coordinate of ordinary size.
template <class N>
typename Forms<N>::Corners moving_corners(const Query& query);
template <class N>
typename Forms<N>::Corners moving_corners(const RationalQuery& query);  ///< for Exact only

/// The same for AnyDegree only: multiplied by a positive number at each time, a polynomial in t.
template <class N>
typename Forms<N>::Corners moving_corners(const CurvedQuery& query);

/// The same for Exact, with the positive number that the corners are multiplied by. For rational coordinates and their
/// common denominator it is a multiple of that.
struct ScaledCorners {
  Forms<Exact>::Corners corners;
  Exact factor;
};
ScaledCorners scaled_corners(const Query& query);
ScaledCorners scaled_corners(const RationalQuery& query);

/// The corners of a curved query as they are: corner i is at numerators[i] / weights[i], times one positive number. All
/// numerators and weights are multiplied by another one, which is 1 where quaternions are of ordinary size.
struct HomogeneousCorners {
  std::array<geometry::Vector<Form>, 4> numerators;
  std::array<Form, 4> weights;  ///< |q|^2 for a corner of a body, constant for one on a curve
  Exact factor;                 ///< the positive number
};
HomogeneousCorners homogeneous_corners(const CurvedQuery& query);

/// The same for Near, from the spans of the query's coordinates along each axis: each has such a number of its own,
/// which changes none of these either: touching and weights are affine, and signs along one axis keep theirs.
template <class N>
typename Forms<N>::Corners moving_corners(const Query& query, const std::array<BitSpan, 3>& spans);

/// Calls f with elements of this type. Those over polynomials of any degree are too large for a stack.
template <class Elements, class Corners, class F>
auto with_these_elements(const Corners& corners, const F& f) {
  if constexpr (std::is_same_v<typename Elements::Number, AnyDegree>) {
    return f(*off_the_stack([&] { return Elements(corners); }));
  } else {
    return f(Elements(corners));
  }
}

/// Calls f with the elements of a kind, over numbers of type N.
template <class N, class F>
auto with_elements_of(Kind kind, const typename Forms<N>::Corners& corners, const F& f) {
  switch (kind) {
    case Kind::edge_edge: return with_these_elements<EdgeEdgeElements<N>>(corners, f);
    case Kind::vertex_face: return with_these_elements<VertexFaceElements<N>>(corners, f);
    case Kind::point_edge: return with_these_elements<PointEdgeElements<N>>(corners, f);
    case Kind::point_point: break;
  }
  return with_these_elements<PointPointElements<N>>(corners, f);
}
template <class N, class Q, class F>
auto with_elements(const Q& query, const F& f) {
  if constexpr (std::is_same_v<N, AnyDegree>) {
    return with_elements_of<N>(query.kind, *off_the_stack([&] { return moving_corners<N>(query); }), f);
  } else {
    return with_elements_of<N>(query.kind, moving_corners<N>(query), f);
  }
}

}  // namespace touchstone::exact
