// A cubic over [0, 1], and a little beyond, known up to rounding errors: certified sign variations, and one root
// certified to an interval.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace touchstone::filters {

/// A time at most 2^-53 away from t whose distance to 1 is a double, so that 1 - t has no rounding error in the bounds
/// below. BernsteinCubic evaluates only at such times.
inline double exact_to_one(double t) noexcept { return 1 - (1 - t); }

class BernsteinCubic {
 public:
  /// All functions hold for t in [-kMargin, 1 + kMargin]. So a root at or near the step's end is no different from
  /// others.
  static constexpr double kMargin = 0x1p-20;

  /// `coefficients` b0, 3 b1, 3 b2, b3 as coplanarity_coefficients computes them, from vectors whose coordinates'
  /// bounds have the product `size`.
  BernsteinCubic(const std::array<double, 4>& coefficients, double size) noexcept;

  /// The sign variations of the Bernstein coefficients over [p, q], the values at both ends being certainly not zero:
  /// `one` proves exactly one root there, a simple one inside; `none` proves that there is none.
  enum class Variations : std::uint8_t { none, one, uncertain };
  Variations variations(double p, double q) const noexcept;

  /// Points low = split[0] < ... < split[n] = high between which the cubic is likely to have at most one sign
  /// variation, where it may have more over [low, high]; returns n, at most 3. This is only likely: `variations`
  /// certifies it.
  int split_points(double low, double high, double (&split)[4]) const noexcept;

  /// Where [p, q] has exactly one root: proves that it lies in [t - radius, t + radius], inside [p, q], where the
  /// cubic's slope keeps the sign of `slope` and is at least half of it. Certain only if so.
  struct Root {
    bool certain;
    double t;       ///< exact_to_one
    double radius;  ///< at most kGreatestRadius
    double slope;   ///< the cubic's derivative at t, off by at most slope_error()
  };
  Root root_between(double p, double q) const noexcept;

  /// The cubic's value and slope at t, off by at most value_error() and slope_error().
  double value(double t) const noexcept { return value(1 - t, t); }
  double slope(double t) const noexcept { return slope(1 - t, t); }
  double value_error() const noexcept;

  /// Its Bernstein coefficients over [p, q], off by at most part_error().
  std::array<double, 4> part(double p, double q) const noexcept;
  double part_error() const noexcept;

  double size() const noexcept { return size_; }
  double slope_error() const noexcept;

  /// At h away from t, |h| <= kGreatestRadius, the slope differs from slope(t) by at most slope_error() + curvature()
  /// |h|.
  double curvature() const noexcept { return curvature_; }
  static constexpr double kGreatestRadius = 0x1p-10;

 private:
  /// At t = 1 - s.
  double value(double s, double t) const noexcept {
    return (c_[0] * s + c_[1] * t) * (s * s) + (c_[2] * s + c_[3] * t) * (t * t);
  }
  double slope(double s, double t) const noexcept { return (d0_ * s + 2 * d1_ * t) * s + d2_ * t * t; }

  std::array<double, 4> c_;  // b0, 3 b1, 3 b2, b3
  double size_;
  double d0_, d1_, d2_;  // Bernstein coefficients of the derivative
  double curvature_;
};

}  // namespace touchstone::filters
