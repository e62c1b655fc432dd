// The doubles beside a root that is known with a bound on its error.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

/// The doubles beside x > 0.
inline double after(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }
inline double before(double x) noexcept { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) - 1); }

/// Sets `lower` to the greatest double below a root > 0 that is no double itself; false where that is not certain.
/// @param sign_at        the sign at a double of a function that changes it at the root, 0 when uncertain
/// @param falls          whether the function is positive before the root
template <class SignAt>
bool double_below(const numbers::BoundedPair& root, const SignAt& sign_at, bool falls, double& lower) noexcept {
  const double nearest = root.value.high, rest = root.value.low;
  if (!(std::fabs(rest) + root.error < nearest - before(nearest))) return false;
  int later = rest > root.error ? 1 : rest < -root.error ? -1 : 0;  // than the nearest double
  if (later == 0) {
    const int sign = sign_at(nearest);
    if (sign == 0) return false;
    later = (sign > 0) == falls ? 1 : -1;
  }
  lower = later > 0 ? nearest : before(nearest);
  return true;
}

}  // namespace touchstone::filters
