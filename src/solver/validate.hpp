// Queries from outside: meaningless ones become errors before anything is computed. SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

#include <touchstone/error.hpp>
#include <touchstone/query.hpp>

namespace touchstone::solver {

/// Whether all coordinates of `count` corners are finite: x - x is +0 for those and a NaN for the others. In the default
/// floating-point environment, which the callers see to.
inline bool all_finite(const Vec3* corners, std::size_t count) noexcept {
  std::uint64_t differences = 0;
  const double* x = &corners->x;
  for (std::size_t i = 0; i < 3 * count; ++i) {
    const double difference = x[i] - x[i];
    std::uint64_t bits;
    std::memcpy(&bits, &difference, sizeof bits);
    differences |= bits;
  }
  return differences == 0;
}

/// Whether 0 <= t_max <= 1, -0.0 included. Looks at bits: in flush-to-zero mode a comparison takes a negative
/// subnormal for zero.
inline bool is_time(double t_max) noexcept {
  constexpr std::uint64_t kOne = 0x3FF0000000000000;
  constexpr std::uint64_t kMinusZero = 0x8000000000000000;
  std::uint64_t bits;
  std::memcpy(&bits, &t_max, sizeof bits);
  return bits <= kOne || bits == kMinusZero;
}

/// @throws InvalidQuery  naming t_max, unless is_time(t_max)
void validate_t_max(double t_max);

/// @throws InvalidQuery  unless the time is finite
void validate_finite_time(double time);

/// @throws InvalidQuery  naming the first coordinate that is not finite
[[noreturn]] void throw_not_finite(Kind kind, const Vec3* start, const Vec3* end);

inline void validate(Kind kind, const Vec3* start, const Vec3* end, double t_max) {
  if (!is_time(t_max)) validate_t_max(t_max);
  const std::size_t count = corner_count(kind);
  const bool finite = count == 4 ? all_finite(start, 4) && all_finite(end, 4)
                                 : all_finite(start, count) && all_finite(end, count);
  if (!finite) throw_not_finite(kind, start, end);
}

/// @throws InvalidQuery  naming the first coordinate that is not a fraction
void validate(const RationalQuery& query, double t_max);

}  // namespace touchstone::solver
