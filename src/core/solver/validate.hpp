// Queries from outside. A meaningless one becomes an error before anything is computed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include <touchstone/curved_query.hpp>
#include <touchstone/error.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::solver {

/// Whether 0 <= t_max <= 1, -0.0 included. It compares bits, because in flush-to-zero mode a comparison of doubles
/// takes a negative subnormal for zero.
inline bool is_time(double t_max) noexcept {
  constexpr std::uint64_t kOne = 0x3FF0000000000000;
  constexpr std::uint64_t kMinusZero = 0x8000000000000000;
  std::uint64_t bits;
  std::memcpy(&bits, &t_max, sizeof bits);
  return bits <= kOne || bits == kMinusZero;
}

/// @throws InvalidQuery  naming t_max, unless is_time(t_max)
void validate_t_max(double t_max);

/// @throws InvalidQuery  unless is_time(time)
void validate_time(double time);

/// @throws InvalidQuery  unless the time is finite
void validate_finite_time(double time);

/// @throws InvalidQuery  unless numerator and denominator are decimal integers, the denominator not zero
void validate_fraction(const Fraction& time);

/// @throws InvalidQuery  naming the kind's number, unless it is one of Kind's
void validate_kind(Kind kind);

/// @throws InvalidQuery  naming the distance, unless it is finite and not negative
void validate_distance(double distance);

/// @throws InvalidQuery  naming the distance or the metric
void validate(const Separation& separation);

/// @throws InvalidQuery  naming the method's number, unless it is one of Method's
void validate_method(Method method);

/// @throws InvalidQuery  naming its number, unless it is one of Wanted's
void validate_wanted(Wanted wanted);

/// @throws InvalidQuery  unless the width is one of VectorWidth's, and this machine has it
void validate_vector_width(VectorWidth width);

/// @throws InvalidQuery  naming the kind, t_max or the first coordinate that is not finite
/// Not inlined, and its operands come from memory: see cascade.hpp.
#if defined(__GNUC__)
__attribute__((noinline))
#endif
void validate(const Query& query, double t_max);

/// @throws InvalidQuery  naming the kind, t_max or the first coordinate that is not a fraction
void validate(const RationalQuery& query, double t_max);

/// @throws InvalidQuery  naming the number of arcs that is not a power of two in the range of ScrewOptions
void validate_arcs(int arcs, int most_arcs);

/// Whether the origin of a body may move on a curve.
enum class OriginPath : std::uint8_t { straight, curved };

/// @param name  what the message calls it
/// @throws InvalidQuery  for a number that is not finite, a quaternion that is zero at an end or between them, or a
///                       position on a curve where it must be straight
void validate(const RigidMotion& motion, const std::string& name, OriginPath path);

/// @throws InvalidQuery  naming the kind, t_max, the first corner or the first motion without meaning
void validate(const CurvedQuery& query, double t_max, OriginPath path = OriginPath::straight);

}  // namespace touchstone::solver
