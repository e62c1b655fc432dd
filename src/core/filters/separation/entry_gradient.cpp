// SPDX-License-Identifier: MIT
#include "filters/separation/entry_gradient.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/nearest_points.hpp"
#include "numbers/doubles/double_double.hpp"

namespace touchstone::filters {
namespace {

using numbers::BoundedPair;
using numbers::DoubleDouble;

/// A BoundedPair that is exactly zero where a factor or both summands are: then its error is 0, too.
struct ZeroKeeping {
  BoundedPair pair;

  bool is_zero() const noexcept { return pair.value.high == 0 && pair.error == 0; }
  /// Whether it is known within a relative 2^-58.
  bool is_certain() const noexcept { return pair.error <= 0x1p-58 * std::fabs(pair.value.high); }

  friend ZeroKeeping operator-(const ZeroKeeping& a) noexcept { return {-a.pair}; }
  friend ZeroKeeping operator+(const ZeroKeeping& a, const ZeroKeeping& b) noexcept { return {a.pair + b.pair}; }
  friend ZeroKeeping operator-(const ZeroKeeping& a, const ZeroKeeping& b) noexcept { return {a.pair - b.pair}; }
  friend ZeroKeeping operator*(const ZeroKeeping& a, const ZeroKeeping& b) noexcept {
    return a.is_zero() || b.is_zero() ? ZeroKeeping() : ZeroKeeping{a.pair * b.pair};
  }
};
using NumberVector = geometry::Vector<ZeroKeeping>;

/// Corner i minus corner j at one end of the step, exactly.
NumberVector difference_at_end(const std::array<Vec3, 4>& x, std::size_t i, std::size_t j) noexcept {
  const auto along = [](double a, double b) { return ZeroKeeping{{numbers::two_difference(a, b), 0}}; };
  return {{along(x[i].x, x[j].x), along(x[i].y, x[j].y), along(x[i].z, x[j].z)}};
}

/// Far enough from overflow and underflow.
bool is_ordinary(double x) noexcept { return std::fabs(x) >= 0x1p-900 && std::fabs(x) <= 0x1p900; }

}  // namespace

// A derivative is a quotient of products of four numbers, each known within a relative 2^-58, and of a few roundings in
// double-doubles. So it is within a relative 2^-55 before its one rounding to a double, and then the true one or a
// double beside it, at a power of two as well.
bool entry_gradient(const Query& query, const Answer& entry, const BoundedPair& time,
                    geometry::EndGradients& gradient) noexcept {
  const std::size_t count = corner_count(query.kind);
  const ZeroKeeping one = {numbers::exact_pair(1)}, fraction = {time}, rest = one - fraction;
  const auto difference = [&query, &fraction](std::size_t i, std::size_t j) {
    const NumberVector from = difference_at_end(query.start, i, j), to = difference_at_end(query.end, i, j);
    return from + fraction * (to - from);
  };
  const auto [direction, weights] =
      geometry::closest_points(query.kind, entry.feature_a, entry.feature_b, one, difference);
  // The weights add up to 0, so that velocities relative to the first corner do.
  NumberVector velocity{};
  for (std::size_t i = 1; i < count; ++i) {
    if (weights[i].is_zero()) continue;
    velocity = velocity + weights[i] * (difference_at_end(query.end, i, 0) - difference_at_end(query.start, i, 0));
  }
  const ZeroKeeping speed = geometry::dot(direction, velocity);
  bool certain = speed.is_certain() && fraction.is_certain() && rest.is_certain();
  for (std::size_t k = 0; k < 3; ++k) certain = certain && direction[k].is_certain();
  for (const ZeroKeeping& weight : weights) certain = certain && weight.is_certain();
  for (const ZeroKeeping& size : geometry::squared_sizes(query.kind, one, difference)) {
    certain = certain && size.pair.value.high != 0 && size.is_certain();
  }
  if (!certain || !is_ordinary(speed.pair.value.high)) return false;

  gradient = {};
  const std::array<DoubleDouble, 2> factors = {-(rest.pair.value / speed.pair.value),
                                               -(fraction.pair.value / speed.pair.value)};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < count; ++i) {
      if (weights[i].is_zero()) continue;
      const DoubleDouble factor = numbers::normalised(factors[side] * weights[i].pair.value);
      double x[3] = {};
      for (std::size_t k = 0; k < 3; ++k) {
        if (direction[k].is_zero()) continue;
        x[k] = numbers::rounded(factor * direction[k].pair.value);
        certain = certain && is_ordinary(factor.high) && is_ordinary(x[k]);
      }
      gradient[side][i] = {x[0], x[1], x[2]};
    }
  }
  return certain;
}

}  // namespace touchstone::filters
