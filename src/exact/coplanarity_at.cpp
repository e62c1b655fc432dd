// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "exact/common_scale.hpp"
#include "exact/exact.hpp"
#include "geometry/vector.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/fixed_int.hpp"

namespace touchstone::exact {
namespace {

/// V from the positions at a time: difference(i, j) is that of corners i and j.
template <class Difference>
auto coplanarity_of(bool edges, const Difference& difference) {
  const auto u = edges ? difference(1, 0) : difference(2, 1);
  const auto w = edges ? difference(3, 2) : difference(3, 1);
  const auto r = edges ? difference(2, 0) : difference(0, 1);
  return geometry::dot(geometry::cross(u, w), r);
}

/// A value times 2^exponent, but for underflow to the least double of its sign.
double scaled(double value, int exponent) noexcept {
  const double result = std::ldexp(value, exponent);
  return value != 0 && result == 0 ? std::copysign(std::numeric_limits<double>::denorm_min(), value) : result;
}

/// With coordinates as integers x / 2^span.low and the time as t / 2^time.low.
template <int Limbs>
double value_in_limbs(const Query& query, const BitSpan& span, double t, const BitSpan& time) {
  using Int = numbers::FixedInt<Limbs>;
  const auto one = numbers::FixedInt<Limbs>::scaled(1, time.low);
  const auto later = numbers::FixedInt<Limbs>::scaled(t, time.low);
  const auto earlier = one - later;
  const auto value = coplanarity_of(query.kind == Kind::edge_edge, [&](std::size_t i, std::size_t j) {
    const auto along = [&](double Vec3::*axis) {
      const auto number = [&](const Vec3& x) { return Int::scaled(x.*axis, span.low); };
      const auto position = [&](const Vec3& a, const Vec3& b) { return number(a) - number(b); };
      const auto wide = earlier * position(query.start[i], query.start[j]) + later * position(query.end[i], query.end[j]);
      Int narrow;  // it fits
      for (int k = 0; k < Limbs; ++k) narrow.set_limb(k, wide.limb(k));
      return narrow;
    };
    return geometry::Vector<Int>{{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)}};
  });
  return scaled(to_double(value), 3 * (span.low + time.low));
}

double value_in_any_size(const Query& query, double t) {
  using numbers::Exact;
  const Exact time(t);
  const Exact value = coplanarity_of(query.kind == Kind::edge_edge, [&](std::size_t i, std::size_t j) {
    const auto along = [&](double Vec3::*axis) {
      const Exact start = Exact(query.start[i].*axis) - Exact(query.start[j].*axis);
      const Exact end = Exact(query.end[i].*axis) - Exact(query.end[j].*axis);
      return start + time * (end - start);
    };
    return geometry::Vector<Exact>{{along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)}};
  });
  const numbers::Approximation approximation = numbers::approximate(value);
  return scaled(approximation.significand, static_cast<int>(approximation.exponent));
}

}  // namespace

double coplanarity_at(const Query& query, double t) {
  const BitSpan span = coordinate_span(query);
  BitSpan time;
  time.add(1.0);
  time.add(t);
  // A difference is below 2^(bits + 1), as it is where it has moved to; times 2^-time.low. Cross products sum 2 and V sums
  // 3 products of three: the room for both, 4 bits, and for the signs is in the three factors' spare bits.
  const int bits = span.bits() + 1 - time.low;
  if (bits <= 64 * 1 - 3) return value_in_limbs<1>(query, span, t, time);
  if (bits <= 64 * 2 - 3) return value_in_limbs<2>(query, span, t, time);
  if (bits <= 64 * 3 - 3) return value_in_limbs<3>(query, span, t, time);
  return value_in_any_size(query, t);
}

}  // namespace touchstone::exact
