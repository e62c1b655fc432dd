// The text of contact_values. It is compiled for several processors: see numbers/pack.hpp for what that forbids.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/contact_values.hpp"
#include "geometry/frame.hpp"
#include "numbers/double_double.hpp"
#include "numbers/pack.hpp"

namespace touchstone::filters {
namespace {

using Coordinates = numbers::Pack<4>;  // x, y, z and a lane of zeros
using Precise = numbers::DoubleDoubleOf<Coordinates>;
using numbers::DoubleDouble;

/// A moving difference of two corners at t: its value and its slope.
struct Moving {
  Precise value;
  Coordinates slope;
};

inline Coordinates coordinates(const Vec3& x) noexcept { return numbers::pack(x.x, x.y, x.z, 0); }

/// Corner i minus corner j.
inline Moving moving_difference(const Query& query, std::size_t i, std::size_t j, double t) noexcept {
  const Precise from = numbers::two_difference(coordinates(query.start[i]), coordinates(query.start[j]));
  const Precise to = numbers::two_difference(coordinates(query.end[i]), coordinates(query.end[j]));
  const double s = 1 - t;  // exact
  const Precise value = numbers::pack(s, s, s, s) * from + numbers::pack(t, t, t, t) * to;
  return {numbers::normalised(value), to.high - from.high};
}

/// The coordinates (y, z, x) and (z, x, y).
inline Coordinates yzx(Coordinates a) noexcept { return numbers::shuffled<1, 2, 0, 3>(a); }
inline Coordinates zxy(Coordinates a) noexcept { return numbers::shuffled<2, 0, 1, 3>(a); }
inline Precise yzx(const Precise& a) noexcept { return {yzx(a.high), yzx(a.low)}; }
inline Precise zxy(const Precise& a) noexcept { return {zxy(a.high), zxy(a.low)}; }

template <class N>
N cross(const N& a, const N& b) noexcept {
  return yzx(a) * zxy(b) - zxy(a) * yzx(b);
}

inline DoubleDouble coordinate(const Precise& a, std::size_t k) noexcept { return {a.high.v[k], a.low.v[k]}; }

/// One coordinate of a x b.
struct Component {
  DoubleDouble value;
  double slope;
};

/// Coordinate k of a x b, whose value is known already.
inline Component component(const Moving& a, const Moving& b, const Precise& value, std::size_t k) noexcept {
  const Coordinates slope = cross(a.slope, b.value.high) + cross(a.value.high, b.slope);
  return {coordinate(value, k), slope.v[k]};
}

inline Component cross_component(const Moving& a, const Moving& b, std::size_t k) noexcept {
  return component(a, b, cross(a.value, b.value), k);
}

inline Component operator-(const Component& a, const Component& b) noexcept {
  return {a.value - b.value, a.slope - b.slope};
}

inline ValueAndSlope rounded(const Component& a) noexcept { return {numbers::rounded(a.value), a.slope}; }

/// ContactValues before they are rounded.
struct PreciseValues {
  DoubleDouble coplanarity;
  Component normal, first, second, third, fourth;
};

inline PreciseValues precise_values(const Query& query, double t, std::size_t k) {
  const bool edges = query.kind == Kind::edge_edge;
  const auto frame = geometry::frame_of(
      edges, [&query, t](std::size_t i, std::size_t j) { return moving_difference(query, i, j, t); });
  // Normalised between the two products of V: so not geometry::coplanarity.
  const Precise n = numbers::normalised(cross(frame.u.value, frame.w.value));
  const Precise products = n * frame.r.value;
  const DoubleDouble coplanarity = coordinate(products, 0) + coordinate(products, 1) + coordinate(products, 2);
  const Component normal = component(frame.u, frame.w, n, k);
  const Component first = geometry::first_numerator(frame, k);
  const Component second = geometry::second_numerator(edges, frame, k);
  const Component without_first = normal - first;
  const Component third = edges ? without_first : without_first - second;
  const Component fourth = edges ? normal - second : third;
  return {coplanarity, normal, first, second, third, fourth};
}

inline ContactValues rounded(const PreciseValues& at) noexcept {
  return {numbers::rounded(at.coplanarity),
          rounded(at.normal),
          rounded(at.first),
          rounded(at.second),
          rounded(at.third),
          rounded(at.fourth)};
}

}  // namespace
}  // namespace touchstone::filters
