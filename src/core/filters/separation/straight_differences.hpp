// The differences of points of two elements that move along straight lines, near a time and at it, over numbers that
// carry their bounds along.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include "filters/separation/entry_step.hpp"
#include "filters/separation/feet.hpp"

namespace touchstone::filters {

/// A coordinate of a difference at all times within `radius` of t, from its values at both ends, which are off by a
/// rounding each.
inline Jet near_time(double start, double end, double t, double radius) noexcept {
  const numbers::Bounded from = {start, numbers::kRounding * std::fabs(start)},
                         to = {end, numbers::kRounding * std::fabs(end)};
  const numbers::Bounded slope = to - from;
  numbers::Bounded value = from + numbers::Bounded{t, 0} * slope;
  value.error += radius * (std::fabs(slope.value) + slope.error);
  return {value, slope};
}

inline StraightDifferences<Jet> differences_near(const Step& step, double t, double radius) noexcept {
  const auto vector = [t, radius](const Vector(&v)[2]) {
    geometry::Vector<Jet> found;
    for (std::size_t k = 0; k < 3; ++k) found[k] = near_time(v[0][k], v[1][k], t, radius);
    return found;
  };
  return {vector(step.r), vector(step.u), vector(step.w), {}, {}, {}};
}

inline StraightDifferences<numbers::BoundedPair> differences_at(const PreciseStep& step,
                                                                const numbers::BoundedPair& t) noexcept {
  const auto vector = [&t](const PreciseVector(&v)[2]) {
    geometry::Vector<numbers::BoundedPair> found;
    for (std::size_t k = 0; k < 3; ++k) {
      const numbers::BoundedPair from = {v[0][k], 0}, to = {v[1][k], 0};
      found[k] = from + t * (to - from);
    }
    return found;
  };
  return {vector(step.r), vector(step.u), vector(step.w), {}, {}, {}};
}

}  // namespace touchstone::filters
