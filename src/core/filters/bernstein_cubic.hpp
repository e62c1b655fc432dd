// A cubic over [0, 1], and a little beyond, known up to rounding errors: certified sign variations, and one root
// certified to an interval.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "filters/step_cubic.hpp"

namespace touchstone::filters {

/// A time at most 2^-53 away from t whose distance to 1 is a double, so that 1 - t has no rounding error in the bounds
/// below. BernsteinCubic evaluates only at such times.
inline double exact_to_one(double t) noexcept { return 1 - (1 - t); }

class BernsteinCubic : public StepCubic<double> {
 public:
  using StepCubic::StepCubic;

  /// Whether all coefficients are zero as computed: then no sign is certain anywhere.
  bool is_zero() const noexcept { return c_[0] == 0 && c_[1] == 0 && c_[2] == 0 && c_[3] == 0; }

  /// The sign variations of the Bernstein coefficients over [p, q], the values at both ends being certainly not zero:
  /// `one` proves exactly one root there, a simple one inside; `none` proves that there is none.
  enum class Variations : std::uint8_t { none, one, uncertain };
  Variations variations(double p, double q) const noexcept;

  /// Points low = split[0] < ... < split[n] = high between which the cubic is likely to have at most one sign
  /// variation, where it may have more over [low, high]; returns n, at most 3. This is only likely: `variations`
  /// certifies it.
  int split_points(double low, double high, double (&split)[4]) const noexcept;

  /// Its Bernstein coefficients over [p, q], off by at most restriction_error().
  std::array<double, 4> restricted_to(double p, double q) const noexcept;
  double restriction_error() const noexcept;
};

}  // namespace touchstone::filters
