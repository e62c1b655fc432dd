// The closest points of two elements, at one time or at all times near it, over numbers that carry their bounds along.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

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
inline numbers::Bounded exact_number<numbers::Bounded>(double x) noexcept {
  return {x, 0};
}
template <>
inline Jet exact_number<Jet>(double x) noexcept {
  return {{x, 0}, {0, 0}};
}
template <>
inline numbers::BoundedPair exact_number<numbers::BoundedPair>(double x) noexcept {
  return numbers::exact_pair(x);
}

/// The number of which a jet has the derivative, too.
inline numbers::Bounded value_of(const Jet& x) noexcept { return x.value; }
inline const numbers::BoundedPair& value_of(const numbers::BoundedPair& x) noexcept { return x; }
template <class N>
using ValueOf = std::remove_cvref_t<decltype(value_of(std::declval<const N&>()))>;

/// The factor 1, which costs nothing.
struct One {};
template <class N>
const N& operator*(One, const N& x) noexcept {
  return x;
}
inline One operator*(One, One) noexcept { return {}; }
inline One value_of(One) noexcept { return {}; }

/// The differences of points of the two elements: c = r - s (first u) - q (second w), with (s, q) in the domain. As all
/// lengths, they are multiplied by the scale.
template <class N, class Factor = N>
struct PointDifferences {
  geometry::Vector<N> r, u, w;
  Factor first, second, scale;
};
template <class N>
geometry::Vector<ValueOf<N>> values_of(const geometry::Vector<N>& v) noexcept {
  return {{value_of(v[0]), value_of(v[1]), value_of(v[2])}};
}
template <class N, class Factor>
PointDifferences<ValueOf<N>, ValueOf<Factor>> values_of(const PointDifferences<N, Factor>& x) noexcept {
  return {values_of(x.r), values_of(x.u), values_of(x.w), value_of(x.first), value_of(x.second), value_of(x.scale)};
}

/// Those of elements on straight lines.
template <class N>
using StraightDifferences = PointDifferences<N, One>;

/// The nearest points of a pair of features, or of the lines or planes through them.
template <class N>
struct Feet {
  using Value = ValueOf<N>;

  /// gap / measure is their squared distance or, in the metric max, their distance. The measure is positive.
  N gap, measure;
  /// Of the free parameters, times the units. For both in a triangle the third one is 1 - s - q.
  std::array<Value, 3> weights;
  std::array<Value, 3> units;
  /// If all of these are positive, the points are the only closest ones of the elements: free parameters are inside,
  /// and the others are at an end from which c becomes longer. |c|^2 is convex.
  std::array<Value, 10> conditions;
  std::size_t count = 0;

  /// Of numbers at a time, nothing is required: that was at all times near it.
  void require(const Value& x) noexcept {
    if constexpr (std::is_same_v<N, Jet>) conditions[count++] = x;
  }
};

template <class Factor, class N>
geometry::Vector<N> times(const Factor& factor, const geometry::Vector<N>& v) noexcept {
  return {{factor * v[0], factor * v[1], factor * v[2]}};
}

template <class N>
N signed_by(double sign, const N& x) noexcept {
  return sign < 0 ? -x : x;
}

/// That other points are farther along n.
template <class N, class V, class Factor>
void require_farther(Feet<N>& feet, Domain domain, Free free, const Parameters& p, const geometry::Vector<V>& n,
                     const PointDifferences<V, Factor>& x) noexcept {
  for_each_multiplier(domain, free, p, [&](int i, int j) {
    if (j == 0) return feet.require(signed_by(i, dot(n, x.u)));
    if (i == 0) return feet.require(signed_by(j, dot(n, x.w)));
    feet.require(signed_by(i, dot(n, x.u) - dot(n, x.w)));
  });
}

/// With both parameters free, over units that are multiples of `size`: the third weight, and that all are inside.
template <class N, class V>
void require_inside(Feet<N>& feet, Domain domain, const V& size) noexcept {
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

/// With one free parameter x: c = p - x unit e. Returns c times the measure.
template <class N, class Factor>
geometry::Vector<ValueOf<N>> foot_on_edge(Feet<N>& feet, const geometry::Vector<N>& p, const geometry::Vector<N>& e,
                                          const Factor& unit) noexcept {
  const auto from = values_of(p), edge = values_of(e);
  const auto along = dot(from, edge);
  const auto normal = geometry::cross(e, p);
  feet.measure = dot(e, e);
  feet.gap = dot(normal, normal);
  feet.weights[0] = along;
  feet.units[0] = value_of(unit) * value_of(feet.measure);
  feet.require(value_of(feet.measure));
  feet.require(along);
  feet.require(feet.units[0] - along);
  return times(value_of(feet.measure), from) - times(along, edge);
}

/// @param p  the parameters of the feet: those that are not free are 0 or 1
template <class N, class Factor>
Feet<N> feet_of(Domain domain, Free free, const Parameters& p, const PointDifferences<N, Factor>& x) noexcept {
  Feet<N> feet;
  geometry::Vector<N> c = x.r;  // between corners
  if (free != Free::both && free != Free::s && p.s == 1) c = c - times(x.first, x.u);
  if (free != Free::both && free != Free::q && p.q == 1) c = c - times(x.second, x.w);
  const auto values = values_of(x);
  auto between = values_of(c);  // the feet
  switch (free) {
    case Free::none:
      feet.gap = dot(c, c);
      feet.measure = exact_number<N>(1);
      break;
    case Free::s: between = foot_on_edge(feet, c, x.u, x.first); break;
    case Free::q: between = foot_on_edge(feet, c, x.w, x.second); break;
    case Free::sum:
      // s = 1 - q: c = r - u - q (w - u), as a triangle has one factor for both.
      between = foot_on_edge(feet, x.r - times(x.first, x.u), x.w - x.u, x.second);
      break;
    case Free::both: {
      const auto normal = geometry::cross(x.u, x.w);
      const N along = dot(normal, x.r);
      feet.gap = along * along;
      feet.measure = dot(normal, normal);
      const auto n = values_of(normal);
      const auto& [r, u, w, first, second, scale] = values;
      feet.weights[0] = dot(geometry::cross(r, w), n);
      feet.weights[1] = dot(geometry::cross(u, r), n);
      const auto size = value_of(feet.measure);
      feet.units = {first * size, second * size, second * size};
      require_inside(feet, domain, size);
      return feet;  // no other points are as near
    }
  }
  require_farther(feet, domain, free, p, between, values);
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
template <class V>
struct LevelOf {
  V numerator, denominator;
};

/// See facet.hpp: where the facet's direction keeps the elements farthest apart, their distance is gap / measure, and c
/// is the level along the axes that count. A gap that is not positive would be of the opposite direction, or of
/// elements that touch.
/// @param level  null for the elements' own distance
template <class N, class Factor>
Feet<N> feet_of(Domain domain, const SignedFacet& hint, const PointDifferences<N, Factor>& x,
                const LevelOf<ValueOf<N>>* level) noexcept {
  using V = ValueOf<N>;
  const Facet& facet = hint.facet;
  Feet<N> feet;
  geometry::Vector<N> corner = x.r;
  if (facet.s == 1) corner = corner - times(x.first, x.u);
  if (facet.q == 1) corner = corner - times(x.second, x.w);
  const N zero = exact_number<N>(0), one = exact_number<N>(1);
  const geometry::Vector<N> normal = normal_of(facet, x.u, x.w, zero, one);
  feet.gap = dot(normal, corner);
  feet.measure = zero;
  for (std::size_t k = 0; k < 3; ++k) {
    if (hint.sigma[k] == 0) continue;
    const N size = signed_by(hint.sigma[k], normal[k]);
    feet.measure = feet.measure + size;
    if (facet.sort != Sort::face) feet.require(value_of(size));
  }
  feet.require(value_of(feet.gap));
  const LevelOf<V> own = {value_of(feet.gap), value_of(feet.measure)};
  const auto& [top, bottom] = level != nullptr ? *level : own;
  const auto values = values_of(x);
  const auto& [r, u, w, first, second, scale] = values;
  require_farther(feet, domain, facet.free, {facet.s, facet.q}, values_of(normal), values);
  // a is the corner minus the level's corner of the cube, times the level's denominator.
  geometry::Vector<V> a = times(bottom, values_of(corner));
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
    const auto e = edge_of(facet.free, u, w);
    const V length = signed_by(hint.sign, e[axis]), along = signed_by(hint.sign, a[axis]);
    feet.weights[0] = along;
    const V scaled = bottom * length;
    feet.units[0] = facet.free == Free::s ? first * scaled : second * scaled;
    feet.require(length);
    feet.require(along);
    feet.require(feet.units[0] - along);
    const V rest = a[facet.axis] * length - along * e[facet.axis];
    feet.require(top * length - rest);
    feet.require(top * length + rest);
  } else {
    // s first u + q second w = a / denominator.
    const V size = bottom * signed_by(hint.sign, geometry::cross_component(u, w, axis));
    feet.weights[0] = signed_by(hint.sign, geometry::cross_component(a, w, axis));
    feet.weights[1] = signed_by(hint.sign, geometry::cross_component(u, a, axis));
    feet.units = {first * size, second * size, second * size};
    require_inside(feet, domain, size);
  }
  return feet;
}

inline bool certainly_closest(const Feet<Jet>& feet) noexcept {
  for (std::size_t i = 0; i < feet.count; ++i) {
    if (feet.conditions[i].sign() <= 0) return false;
  }
  return true;
}

}  // namespace touchstone::filters
