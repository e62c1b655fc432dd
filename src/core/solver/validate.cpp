// SPDX-License-Identifier: MIT
#include "solver/validate.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "numbers/doubles/decimal_text.hpp"
#include "numbers/fraction.hpp"

namespace touchstone::solver {
namespace {

constexpr char kAxes[] = "xyz";

std::string where(Kind kind, std::size_t corner, int end, std::size_t axis) {
  std::string text(name_of(kind));
  text.append(" query: corner ").append(corner_name(kind, corner)).append(" at t = ").append(std::to_string(end));
  return text.append(" has ").append(1, kAxes[axis]).append(" = ");
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kShown = 40;
  return text.size() <= kShown ? text : text.substr(0, kShown) + "...";
}

std::string text_of(const Fraction& fraction) {
  return shortened(fraction.numerator) + "/" + shortened(fraction.denominator);
}

/// Why the two texts are no fraction, for a message after them; empty when they are one.
std::string fault_of(const Fraction& fraction) {
  if (!numbers::is_decimal_integer(fraction.numerator) || !numbers::is_decimal_integer(fraction.denominator)) {
    return "; numerator and denominator must be decimal integers";
  }
  const bool zero = fraction.denominator.find_first_not_of("-0") == std::string::npos;
  return zero ? "; the denominator must not be 0" : "";
}

/// Whether `count` numbers are finite: x - x is +0 for a finite x and a NaN for any other.
bool all_finite(const double* x, std::size_t count) noexcept {
  std::uint64_t differences = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double difference = x[i] - x[i];
    std::uint64_t bits;
    std::memcpy(&bits, &difference, sizeof bits);
    differences |= bits;
  }
  return differences == 0;
}

[[noreturn]] void throw_not_finite(const Query& query) {
  for (int side = 0; side < 2; ++side) {
    const auto& corners = side == 0 ? query.start : query.end;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      const double coordinates[3] = {corners[i].x, corners[i].y, corners[i].z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (std::isfinite(coordinates[axis])) continue;
        throw InvalidQuery(where(query.kind, i, side, axis) + numbers::decimal_text(coordinates[axis]) +
                           "; coordinates must be finite");
      }
    }
  }
  throw InvalidQuery("a coordinate is not finite");
}

}  // namespace

void validate_t_max(double t_max) {
  if (is_time(t_max)) return;
  throw InvalidQuery("t_max is " + numbers::decimal_text(t_max) + "; it must be in [0, 1]");
}

void validate_time(double time) {
  if (is_time(time)) return;
  throw InvalidQuery("the time is " + numbers::decimal_text(time) + "; it must be in [0, 1]");
}

void validate_finite_time(double time) {
  if (!std::isfinite(time)) throw InvalidQuery("the time is " + numbers::decimal_text(time) + "; it must be finite");
}

void validate_fraction(const Fraction& time) {
  const std::string fault = fault_of(time);
  if (!fault.empty()) throw InvalidQuery("the time is " + text_of(time) + fault);
}

void validate_kind(Kind kind) {
  if (kind <= kKinds.back()) return;
  throw InvalidQuery("the kind is " + std::to_string(static_cast<int>(kind)) + "; it must be one of 0 to " +
                     std::to_string(static_cast<int>(kKinds.back())) +
                     ": edge-edge, vertex-face, point-edge or point-point");
}

void validate_distance(double distance) {
  std::uint64_t bits;  // compared as bits: see is_time
  std::memcpy(&bits, &distance, sizeof bits);
  constexpr std::uint64_t kInfinity = 0x7FF0000000000000;
  constexpr std::uint64_t kMinusZero = 0x8000000000000000;
  if (bits < kInfinity || bits == kMinusZero) return;
  throw InvalidQuery("the separation is " + numbers::decimal_text(distance) + "; it must be finite and not negative");
}

void validate(const Separation& separation) {
  validate_distance(separation.distance);
  if (!name_of(separation.metric).empty()) return;
  throw InvalidQuery("the metric is " + std::to_string(static_cast<int>(separation.metric)) +
                     "; it must be 0 or 1: euclidean or max");
}

void validate_method(Method method) {
  if (has_method(method)) return;
  if (method <= Method::fast_cgal) {
    throw InvalidQuery(
        "Method::oracle and Method::fast_cgal need CGAL, and this library was built without it; build it with "
        "-DTOUCHSTONE_WITH_CGAL=ON, or ask by Method::fast or Method::exact");
  }
  throw InvalidQuery("the method is " + std::to_string(static_cast<int>(method)) + "; it must be one of 0 to " +
                     std::to_string(static_cast<int>(Method::fast_cgal)) + ": fast, exact, oracle or fast_cgal");
}

void validate_wanted(Wanted wanted) {
  if (wanted <= Wanted::contact) return;
  throw InvalidQuery("what is wanted is " + std::to_string(static_cast<int>(wanted)) + "; it must be one of 0 to " +
                     std::to_string(static_cast<int>(Wanted::contact)) + ": all, features, time or contact");
}

void validate_vector_width(VectorWidth width) {
  if (width > VectorWidth::bits_512) {
    throw InvalidQuery("the SIMD width is " + std::to_string(static_cast<int>(width)) + "; it must be one of 0 to " +
                       std::to_string(static_cast<int>(VectorWidth::bits_512)) +
                       ": widest, none, bits_128, bits_256 or bits_512");
  }
  if (has_vectors(width)) return;
  throw InvalidQuery("this machine does not have the chosen SIMD width; VectorWidth::widest always works");
}

void validate(const Query& query, double t_max) {
  validate_kind(query.kind);
  validate_t_max(t_max);
  const double* const start = &query.start[0].x;
  const double* const end = &query.end[0].x;
  const std::size_t count = 3 * corner_count(query.kind);
  const bool finite =
      count == 12 ? all_finite(start, 12) && all_finite(end, 12) : all_finite(start, count) && all_finite(end, count);
  if (!finite) throw_not_finite(query);
}

void validate(const RationalQuery& query, double t_max) {
  validate_kind(query.kind);
  validate_t_max(t_max);
  for (int side = 0; side < 2; ++side) {
    const auto& corners = side == 0 ? query.start : query.end;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string fault = fault_of(corners[i][axis]);
        if (fault.empty()) continue;
        throw InvalidQuery(where(query.kind, i, side, axis) + text_of(corners[i][axis]) + fault);
      }
    }
  }
}

}  // namespace touchstone::solver
