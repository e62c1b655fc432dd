// The closest points of two elements on curves, at one time or at all times near it, over numbers that carry their
// bounds along.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "filters/separation/entry_step.hpp"
#include "filters/separation/facet.hpp"
#include "geometry/vector.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

/// A number and its derivative, at all times near one.
struct Jet {
  numbers::Bounded value, slope;

  int sign() const noexcept { return value.sign(); }
};
inline Jet operator-(const Jet& a) noexcept { return {-a.value, -a.slope}; }
inline Jet operator+(const Jet& a, const Jet& b) noexcept { return {a.value + b.value, a.slope + b.slope}; }
inline Jet operator-(const Jet& a, const Jet& b) noexcept { return {a.value - b.value, a.slope - b.slope}; }
inline Jet operator*(const Jet& a, const Jet& b) noexcept {
  return {a.value * b.value, a.value * b.slope + a.slope * b.value};
}

/// A double as a number of each sort.
template <class N>
N exact_number(double x) noexcept;
template <>
inline Jet exact_number<Jet>(double x) noexcept {
  return {{x, 0}, {0, 0}};
}
template <>
inline numbers::BoundedPair exact_number<numbers::BoundedPair>(double x) noexcept {
  return numbers::exact_pair(x);
}

/// The differences of points of the two elements: c = r - s (first u) - q (second w), with (s, q) in the domain. As all
/// lengths, they are multiplied by the scale.
template <class N>
struct PointDifferences {
  geometry::Vector<N> r, u, w;
  N first, second;
  N scale;
};

/// The nearest points of a pair of features, or of the lines or planes through them.
template <class N>
struct Feet {
  /// gap / measure is their squared distance or, in the metric max, their distance. The measure is positive.
  N gap, measure;
  /// Of the free parameters, times the units. For both in a triangle the third one is 1 - s - q.
  std::array<N, 3> weights;
  std::array<N, 3> units;
  /// If all of these are positive, the points are the only closest ones of the elements: free parameters are inside,
  /// and the others are at an end from which c becomes longer. |c|^2 is convex.
  std::array<N, 10> conditions;
  std::size_t count = 0;

  void require(const N& x) noexcept { conditions[count++] = x; }
};

template <class N>
geometry::Vector<N> times(const N& factor, const geometry::Vector<N>& v) noexcept {
  return {{factor * v[0], factor * v[1], factor * v[2]}};
}

template <class N>
N signed_by(double sign, const N& x) noexcept {
  return sign < 0 ? -x : x;
}

/// That other points are farther along n.
template <class N>
void require_farther(Feet<N>& feet, Domain domain, Free free, const Parameters& p, const geometry::Vector<N>& n,
                     const PointDifferences<N>& x) noexcept {
  for_each_multiplier(domain, free, p, [&](int i, int j) {
    if (j == 0) return feet.require(signed_by(i, dot(n, x.u)));
    if (i == 0) return feet.require(signed_by(j, dot(n, x.w)));
    feet.require(signed_by(i, dot(n, x.u) - dot(n, x.w)));
  });
}

/// With both parameters free, over units that are multiples of `size`: the third weight, and that all are inside.
template <class N>
void require_inside(Feet<N>& feet, Domain domain, const N& size) noexcept {
  feet.weights[2] = feet.units[0] - feet.weights[0] - feet.weights[1];
  feet.require(size);
  feet.require(feet.weights[0]);
  feet.require(feet.weights[1]);
  if (domain == Domain::square) {
    feet.require(feet.units[0] - feet.weights[0]);
    feet.require(feet.units[1] - feet.weights[1]);
  } else {
    feet.require(feet.weights[2]);
  }
}

/// With one free parameter x: c = p - x unit e.
template <class N>
geometry::Vector<N> foot_on_edge(Feet<N>& feet, const geometry::Vector<N>& p, const geometry::Vector<N>& e,
                                 const N& unit) noexcept {
  const N along = dot(p, e);
  const auto normal = geometry::cross(e, p);
  feet.measure = dot(e, e);
  feet.gap = dot(normal, normal);
  feet.weights[0] = along;
  feet.units[0] = unit * feet.measure;
  feet.require(feet.measure);
  feet.require(along);
  feet.require(feet.units[0] - along);
  return times(feet.measure, p) - times(along, e);  // c, times the denominator
}

/// @param p  the parameters of the feet: those that are not free are 0 or 1
template <class N>
Feet<N> feet_of(Domain domain, Free free, const Parameters& p, const PointDifferences<N>& x) noexcept {
  Feet<N> feet;
  geometry::Vector<N> c = x.r;  // between corners, then between the feet
  if (free != Free::both && free != Free::s && p.s == 1) c = c - times(x.first, x.u);
  if (free != Free::both && free != Free::q && p.q == 1) c = c - times(x.second, x.w);
  switch (free) {
    case Free::none:
      feet.gap = dot(c, c);
      feet.measure = exact_number<N>(1);
      break;
    case Free::s: c = foot_on_edge(feet, c, x.u, x.first); break;
    case Free::q: c = foot_on_edge(feet, c, x.w, x.second); break;
    case Free::sum:
      // s = 1 - q: c = r - u - q (w - u), as a triangle has one factor for both.
      c = foot_on_edge(feet, x.r - times(x.first, x.u), x.w - x.u, x.second);
      break;
    case Free::both: {
      const auto n = geometry::cross(x.u, x.w);
      const N along = dot(n, x.r);
      feet.gap = along * along;
      feet.measure = dot(n, n);
      feet.weights[0] = dot(geometry::cross(x.r, x.w), n);
      feet.weights[1] = dot(geometry::cross(x.u, x.r), n);
      feet.units = {x.first * feet.measure, x.second * feet.measure, x.second * feet.measure};
      require_inside(feet, domain, feet.measure);
      break;
    }
  }
  require_farther(feet, domain, free, p, c, x);
  return feet;
}

/// A facet with what doubles tell of it.
struct SignedFacet {
  Facet facet;
  Vector sigma;          ///< the signs of its normal; 0 along axes that do not count
  std::size_t axis = 0;  ///< along which the edge, or the plane's normal, is longest
  double sign = 1;       ///< of that coordinate
};

/// The distance against which facets are taken: numerator / denominator, denominator > 0.
template <class N>
struct LevelOf {
  N numerator, denominator;
};

/// See max_entry.cpp: where the facet's direction keeps the elements farthest apart, their distance is gap / measure,
/// and c is the level along the axes that count. A gap that is not positive would be of the opposite direction, or of
/// elements that touch.
/// @param level  null for the elements' own distance
template <class N>
Feet<N> feet_of(Domain domain, const SignedFacet& hint, const PointDifferences<N>& x,
                const LevelOf<N>* level) noexcept {
  const Facet& facet = hint.facet;
  Feet<N> feet;
  geometry::Vector<N> p = x.r;
  if (facet.s == 1) p = p - times(x.first, x.u);
  if (facet.q == 1) p = p - times(x.second, x.w);
  const N zero = exact_number<N>(0), one = exact_number<N>(1);
  // The facet's own sign stands beside the products: normal_of multiplies by it.
  geometry::Vector<N> n = {{zero, zero, zero}}, e = n;
  if (facet.sort == Sort::face) n[facet.axis] = one;
  if (facet.sort == Sort::edge) {
    e = edge_of(facet.free, x.u, x.w);
    n = axis_cross(facet.axis, e, zero);
  }
  if (facet.sort == Sort::plane) n = geometry::cross(x.u, x.w);
  for (N& c : n.c) c = signed_by(facet.sign, c);
  feet.gap = dot(n, p);
  feet.measure = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    if (hint.sigma[k] == 0) continue;
    const N size = signed_by(hint.sigma[k], n[k]);
    feet.measure = feet.measure + size;
    if (facet.sort != Sort::face) feet.require(size);
  }
  feet.require(feet.gap);
  const LevelOf<N> own = {feet.gap, feet.measure};
  const auto& [top, bottom] = level != nullptr ? *level : own;
  require_farther(feet, domain, facet.free, {facet.s, facet.q}, n, x);
  // a is the corner minus the level's corner of the cube, times the level's denominator.
  geometry::Vector<N> a = times(bottom, p);
  for (std::size_t k = 0; k < 3; ++k) {
    if (hint.sigma[k] != 0) a[k] = a[k] - signed_by(hint.sigma[k], top);
  }
  const std::size_t axis = hint.axis;
  if (facet.sort == Sort::face) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == facet.axis) continue;
      feet.require(top - a[k]);
      feet.require(top + a[k]);
    }
  } else if (facet.sort == Sort::edge) {
    // x unit e = a / denominator.
    const N length = signed_by(hint.sign, e[axis]), along = signed_by(hint.sign, a[axis]);
    feet.weights[0] = along;
    feet.units[0] = (facet.free == Free::s ? x.first : x.second) * (bottom * length);
    feet.require(length);
    feet.require(along);
    feet.require(feet.units[0] - along);
    const N rest = a[facet.axis] * length - along * e[facet.axis];
    feet.require(top * length - rest);
    feet.require(top * length + rest);
  } else {
    // s first u + q second w = a / denominator.
    const N size = bottom * signed_by(hint.sign, geometry::cross_component(x.u, x.w, axis));
    feet.weights[0] = signed_by(hint.sign, geometry::cross_component(a, x.w, axis));
    feet.weights[1] = signed_by(hint.sign, geometry::cross_component(x.u, a, axis));
    feet.units = {x.first * size, x.second * size, x.second * size};
    require_inside(feet, domain, size);
  }
  return feet;
}

template <class N>
bool certainly_closest(const Feet<N>& feet) noexcept {
  for (std::size_t i = 0; i < feet.count; ++i) {
    if (feet.conditions[i].sign() <= 0) return false;
  }
  return true;
}

}  // namespace touchstone::filters
