// The text of contact_values. It is written once, for the coordinates of one query in a pack and for packs of several
// queries. It is compiled for several processors: see numbers/doubles/pack.hpp for what that forbids.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "filters/contact_values.hpp"
#include "geometry/frame.hpp"
#include "numbers/doubles/double_double.hpp"
#include "numbers/doubles/pack.hpp"

namespace touchstone::filters {
namespace {

using numbers::DoubleDoubleOf;

// The coordinates of one query: x, y, z and a lane of zeros.

using Coordinates = numbers::Pack<4>;

inline Coordinates coordinates(const Vec3& x) noexcept { return numbers::pack(x.x, x.y, x.z, 0); }

/// x in every coordinate.
inline Coordinates in_each(Coordinates, double x) noexcept { return numbers::pack(x, x, x, x); }

/// The coordinates (y, z, x) and (z, x, y).
inline Coordinates yzx(Coordinates a) noexcept { return numbers::shuffled<1, 2, 0, 3>(a); }
inline Coordinates zxy(Coordinates a) noexcept { return numbers::shuffled<2, 0, 1, 3>(a); }

inline double coordinate(Coordinates a, std::size_t k) noexcept { return a.v[k]; }

// The coordinates of several queries: a pack for each axis.

template <int Width>
struct CoordinatesOfSeveral {
  numbers::Pack<Width> x, y, z;

  using Self = CoordinatesOfSeveral;
  friend TOUCHSTONE_INLINE Self operator+(const Self& a, const Self& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend TOUCHSTONE_INLINE Self operator-(const Self& a, const Self& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend TOUCHSTONE_INLINE Self operator*(const Self& a, const Self& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend TOUCHSTONE_INLINE Self operator*(double a, const Self& b) { return {a * b.x, a * b.y, a * b.z}; }
#ifdef __FMA__
  friend TOUCHSTONE_INLINE Self multiply_subtract(const Self& a, const Self& b, const Self& c) {
    return {multiply_subtract(a.x, b.x, c.x), multiply_subtract(a.y, b.y, c.y), multiply_subtract(a.z, b.z, c.z)};
  }
#endif
};

template <int Width>
TOUCHSTONE_INLINE CoordinatesOfSeveral<Width> in_each(const CoordinatesOfSeveral<Width>&,
                                                      const numbers::Pack<Width>& x) noexcept {
  return {x, x, x};
}
template <int Width>
TOUCHSTONE_INLINE CoordinatesOfSeveral<Width> yzx(const CoordinatesOfSeveral<Width>& a) noexcept {
  return {a.y, a.z, a.x};
}
template <int Width>
TOUCHSTONE_INLINE CoordinatesOfSeveral<Width> zxy(const CoordinatesOfSeveral<Width>& a) noexcept {
  return {a.z, a.x, a.y};
}
template <int Width>
TOUCHSTONE_INLINE numbers::Pack<Width> coordinate(const CoordinatesOfSeveral<Width>& a, std::size_t k) noexcept {
  return k == 0 ? a.x : k == 1 ? a.y : a.z;
}
/// Coordinate `axis`, which each query has its own of.
template <int Width>
TOUCHSTONE_INLINE numbers::Pack<Width> coordinate(const CoordinatesOfSeveral<Width>& a,
                                                  const typename numbers::PackLanes<Width>::Axis& axis) noexcept {
  return chosen(axis.is_z, a.z, chosen(axis.is_y, a.y, a.x));
}

// From here on C is one of the two.

template <class C>
using Precise = DoubleDoubleOf<C>;

/// A moving difference of two corners at t: its value and its slope.
template <class C>
struct Moving {
  Precise<C> value;
  C slope;
};

/// corner(side, i) is corner i at t = 0 (side 0) or t = 1: corner i minus corner j, at t.
template <class Corner, class N>
TOUCHSTONE_INLINE auto moving_difference(const Corner& corner, std::size_t i, std::size_t j, const N& t) noexcept
    -> Moving<decltype(corner(0, i))> {
  const auto from = numbers::two_difference(corner(0, i), corner(0, j));
  const auto to = numbers::two_difference(corner(1, i), corner(1, j));
  const N s = 1 - t;  // exact
  const auto value = in_each(from.high, s) * from + in_each(to.high, t) * to;
  return {numbers::normalised(value), to.high - from.high};
}

template <class C>
TOUCHSTONE_INLINE Precise<C> yzx(const Precise<C>& a) noexcept {
  return {yzx(a.high), yzx(a.low)};
}
template <class C>
TOUCHSTONE_INLINE Precise<C> zxy(const Precise<C>& a) noexcept {
  return {zxy(a.high), zxy(a.low)};
}

template <class N>
TOUCHSTONE_INLINE N cross_of_lanes(const N& a, const N& b) noexcept {
  return yzx(a) * zxy(b) - zxy(a) * yzx(b);
}

template <class C, class Axis>
TOUCHSTONE_INLINE auto coordinate(const Precise<C>& a, const Axis& k) noexcept
    -> DoubleDoubleOf<decltype(coordinate(a.high, k))> {
  return {coordinate(a.high, k), coordinate(a.low, k)};
}

/// One coordinate of a x b.
template <class N>
struct ComponentOf {
  DoubleDoubleOf<N> value;
  N slope;
};
using Component = ComponentOf<double>;

/// Coordinate k of a x b, whose value is known already.
template <class C, class Axis>
TOUCHSTONE_INLINE auto component(const Moving<C>& a, const Moving<C>& b, const Precise<C>& value,
                                 const Axis& k) noexcept -> ComponentOf<decltype(coordinate(value.high, k))> {
  const C slope = cross_of_lanes(a.slope, b.value.high) + cross_of_lanes(a.value.high, b.slope);
  return {coordinate(value, k), coordinate(slope, k)};
}

template <class C, class Axis>
TOUCHSTONE_INLINE auto cross_component(const Moving<C>& a, const Moving<C>& b, const Axis& k) noexcept {
  return component(a, b, cross_of_lanes(a.value, b.value), k);
}

// Of several queries, each along its own axis: only that coordinate is computed.

/// The coordinates after `axis`, in the order (y, z, x).
template <int Width>
struct NextTwo {
  numbers::Pack<Width> first, second;

  NextTwo(const CoordinatesOfSeveral<Width>& a, const typename numbers::PackLanes<Width>::Axis& axis) noexcept
      : first(coordinate(yzx(a), axis)), second(coordinate(zxy(a), axis)) {}
};

template <int Width>
TOUCHSTONE_INLINE ComponentOf<numbers::Pack<Width>> component(
    const Moving<CoordinatesOfSeveral<Width>>& a, const Moving<CoordinatesOfSeveral<Width>>& b,
    const Precise<CoordinatesOfSeveral<Width>>& value, const typename numbers::PackLanes<Width>::Axis& k) noexcept {
  const NextTwo<Width> a_slope(a.slope, k), b_slope(b.slope, k), a_value(a.value.high, k), b_value(b.value.high, k);
  return {coordinate(value, k), (a_slope.first * b_value.second - a_slope.second * b_value.first) +
                                    (a_value.first * b_slope.second - a_value.second * b_slope.first)};
}

template <int Width>
TOUCHSTONE_INLINE ComponentOf<numbers::Pack<Width>> cross_component(
    const Moving<CoordinatesOfSeveral<Width>>& a, const Moving<CoordinatesOfSeveral<Width>>& b,
    const typename numbers::PackLanes<Width>::Axis& k) noexcept {
  using Value = DoubleDoubleOf<numbers::Pack<Width>>;
  const NextTwo<Width> a_high(a.value.high, k), a_low(a.value.low, k), b_high(b.value.high, k), b_low(b.value.low, k);
  const Value value = Value{a_high.first, a_low.first} * Value{b_high.second, b_low.second} -
                      Value{a_high.second, a_low.second} * Value{b_high.first, b_low.first};
  const NextTwo<Width> a_slope(a.slope, k), b_slope(b.slope, k);
  return {value, (a_slope.first * b_high.second - a_slope.second * b_high.first) +
                     (a_high.first * b_slope.second - a_high.second * b_slope.first)};
}

template <class N>
TOUCHSTONE_INLINE ComponentOf<N> operator-(const ComponentOf<N>& a, const ComponentOf<N>& b) noexcept {
  return {a.value - b.value, a.slope - b.slope};
}

template <class N>
TOUCHSTONE_INLINE ValueAndSlopeOf<N> rounded(const ComponentOf<N>& a) noexcept {
  return {numbers::rounded(a.value), a.slope};
}

/// The frame at t, and n = u x w, normalised between the two products of V: so not geometry::coplanarity.
template <class C>
struct MovingFrame {
  geometry::Frame<Moving<C>> moving;
  Precise<C> normal;
};

template <class Corner, class N>
TOUCHSTONE_INLINE auto moving_frame(Kind kind, const Corner& corner, const N& t) noexcept
    -> MovingFrame<decltype(corner(0, 0))> {
  const auto moving = geometry::frame_of(
      kind, [&corner, &t](std::size_t i, std::size_t j) { return moving_difference(corner, i, j, t); });
  return {moving, numbers::normalised(cross_of_lanes(moving.u.value, moving.w.value))};
}

template <class C>
TOUCHSTONE_INLINE auto precise_coplanarity(const MovingFrame<C>& f) noexcept {
  const Precise<C> products = f.normal * f.moving.r.value;
  const auto product = [&products](std::size_t k) { return coordinate(products, k); };
  return product(0) + product(1) + product(2);
}

/// The components of ContactValues before they are rounded.
template <class N>
struct PreciseComponents {
  ComponentOf<N> normal, first, second, third, fourth;
};

template <class C, class Axis>
TOUCHSTONE_INLINE auto precise_components(Kind kind, const MovingFrame<C>& f, const Axis& k) noexcept {
  const auto normal = component(f.moving.u, f.moving.w, f.normal, k);
  const auto first = cross_component(f.moving.r, f.moving.w, k);
  const bool edges = kind == Kind::edge_edge;
  const auto second = edges ? cross_component(f.moving.r, f.moving.u, k) : cross_component(f.moving.u, f.moving.r, k);
  const auto without_first = normal - first;
  const auto third = edges ? without_first : without_first - second;
  const auto fourth = edges ? normal - second : third;
  return PreciseComponents<decltype(coordinate(f.normal.high, k))>{normal, first, second, third, fourth};
}

/// ContactValues before they are rounded.
struct PreciseValues : PreciseComponents<double> {
  numbers::DoubleDouble coplanarity;
};

/// The positions of one query's corners.
inline auto corners_of(const Query& query) noexcept {
  return [&query](int side, std::size_t i) { return coordinates((side == 0 ? query.start : query.end)[i]); };
}

inline MovingFrame<Coordinates> moving_frame(const Query& query, double t) noexcept {
  return moving_frame(query.kind, corners_of(query), t);
}

inline PreciseValues precise_values(const Query& query, double t, std::size_t k) {
  const auto frame = moving_frame(query, t);
  return {precise_components(query.kind, frame, k), precise_coplanarity(frame)};
}

template <class N>
TOUCHSTONE_INLINE ComponentsAt<N> rounded(const PreciseComponents<N>& at) noexcept {
  return {rounded(at.normal), rounded(at.first), rounded(at.second), rounded(at.third), rounded(at.fourth)};
}

inline ContactValues rounded(const PreciseValues& at) noexcept {
  return {rounded<double>(at), numbers::rounded(at.coplanarity)};
}

/// As the including file is compiled.
constexpr ContactValuesFunctions kContactValues = {
    [](const Query& query, double t, std::size_t axis) { return rounded(precise_values(query, t, axis)); },
    [](const Query& query, double t) { return numbers::rounded(precise_coplanarity(moving_frame(query, t))); }};

}  // namespace
}  // namespace touchstone::filters
