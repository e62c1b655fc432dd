// The text of contact_values, compiled for several processors: see numbers/pack.hpp for what that forbids.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/contact_values.hpp"
#include "geometry/vector.hpp"
#include "numbers/double_double.hpp"
#include "numbers/pack.hpp"

namespace touchstone::filters {
namespace {

using Lanes = numbers::Pack<4>;  // x, y, z and a lane of zeros
using Precise = numbers::DoubleDoubleOf<Lanes>;
using numbers::DoubleDouble;

/// A moving difference of two corners at t: its value and its slope.
struct Moving {
  Precise value;
  Lanes slope;
};

inline Lanes lanes(const Vec3& x) noexcept { return numbers::pack(x.x, x.y, x.z, 0); }

inline Moving moving_difference(const Vec3* start, const Vec3* end, std::size_t i, std::size_t j, double t) noexcept {
  const Precise from = numbers::two_difference(lanes(start[i]), lanes(start[j]));
  const Precise to = numbers::two_difference(lanes(end[i]), lanes(end[j]));
  const double s = 1 - t;  // exact
  const Precise value = numbers::pack(s, s, s, s) * from + numbers::pack(t, t, t, t) * to;
  return {numbers::normalised(value), to.high - from.high};
}

/// The coordinates (y, z, x) and (z, x, y).
inline Lanes yzx(Lanes a) noexcept { return numbers::shuffled<1, 2, 0, 3>(a); }
inline Lanes zxy(Lanes a) noexcept { return numbers::shuffled<2, 0, 1, 3>(a); }
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

inline Component component(const Moving& a, const Moving& b, const Precise& value, std::size_t k) noexcept {
  const Lanes slope = cross(a.slope, b.value.high) + cross(a.value.high, b.slope);
  return {coordinate(value, k), slope.v[k]};
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

inline PreciseValues precise_values(const Vec3* start, const Vec3* end, bool edges, double t, std::size_t k) {
  const auto difference = [&](std::size_t i, std::size_t j) { return moving_difference(start, end, i, j, t); };
  const Moving u = edges ? difference(1, 0) : difference(2, 1);
  const Moving w = edges ? difference(3, 2) : difference(3, 1);
  const Moving r = edges ? difference(2, 0) : difference(0, 1);
  const Precise n = numbers::normalised(cross(u.value, w.value));
  const Precise products = n * r.value;
  const DoubleDouble coplanarity = coordinate(products, 0) + coordinate(products, 1) + coordinate(products, 2);
  const Component normal = component(u, w, n, k);
  const Component first = component(r, w, cross(r.value, w.value), k);
  const Component second =
      edges ? component(r, u, cross(r.value, u.value), k) : component(u, r, cross(u.value, r.value), k);
  const Component without_first = normal - first;
  const Component third = edges ? without_first : without_first - second;
  const Component fourth = edges ? normal - second : third;
  return {coplanarity, normal, first, second, third, fourth};
}

inline ContactValues contact_values_by_steps(const Vec3* start, const Vec3* end, bool edges, double t, std::size_t k) {
  const PreciseValues at = precise_values(start, end, edges, t, k);
  return {numbers::rounded(at.coplanarity),
          rounded(at.normal),
          rounded(at.first),
          rounded(at.second),
          rounded(at.third),
          rounded(at.fourth)};
}

}  // namespace
}  // namespace touchstone::filters
