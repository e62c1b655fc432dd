// Polynomials whose coefficients are doubles of any exponent, each with a bound on its error: the quick look at sparse
// polynomials. They know most signs, and where a root is. What they leave open, the sparse numbers decide.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "numbers/sparse.hpp"

namespace touchstone::numbers {

/// A number within error 2^exponent of value 2^exponent, 1/2 <= |value| <= 1 or 0.
struct Rough {
  double value = 0, error = 0;
  long exponent = 0;

  Rough() noexcept = default;
  explicit Rough(const Sparse& x) noexcept;
  template <int Digits>
  explicit Rough(const Leading<Digits>& x) noexcept : Rough(static_cast<const Sparse::Part&>(x)) {}

 private:
  explicit Rough(const Sparse::Part& x) noexcept;
};

/// A positive number within a relative `slack` of significand 2^exponent: 1/8 <= significand <= 1, and the slack is at
/// most 2^-8.
struct WidePoint {
  double significand = 1;
  long exponent = 0;
  double slack = 0;
};

/// From low 2^exponent to high 2^exponent.
struct WideBracket {
  double low, high;
  long exponent;

  /// About its middle, with all of it within the slack.
  WidePoint point() const noexcept;
};

class WidePolynomial {
 public:
  /// Of at most 4 coefficients, which are sparse numbers or their leading digits.
  template <class N>
  WidePolynomial(const N* c, int size) noexcept : size_(size) {
    for (int i = 0; i < size; ++i) c_[static_cast<std::size_t>(i)] = Rough(c[i]);
  }

  /// The same in -x.
  WidePolynomial mirrored() const noexcept;

  /// Of the constant coefficient; 0 when uncertain.
  int sign_at_zero() const noexcept { return sign_of(c_[0].value, c_[0].error); }

  /// The sign at all x that the point stands for; 0 when uncertain.
  int sign_at(const WidePoint& x) const noexcept;

  /// The signs of the four Bernstein coefficients of a cubic over [low, high], each 0 when uncertain. `low` is 0
  /// without a point, and below `high`. Neither has a slack.
  std::array<int, 4> bernstein_signs(const std::optional<WidePoint>& low, const WidePoint& high) const noexcept;

  /// A narrow bracket of a root between low, 0 without a point, and high: the polynomial certainly has the sign
  /// `sign_low` at its low end, and the other one at its high end, unless these are `low` and `high` themselves.
  /// Nothing where the signs are uncertain, or where there is a root but not within the reach of doubles. Neither point
  /// has a slack.
  std::optional<WideBracket> bracket(const std::optional<WidePoint>& low, const WidePoint& high,
                                     int sign_low) const noexcept;

 private:
  /// The coefficients of x / 2^exponent, times a power of two that makes the greatest one 1/2 to 1.
  struct Window {
    std::array<double, 4> c{}, error{};
  };
  Window window(long exponent) const noexcept;
  int sign_in(const Window& window, double x, double slack) const noexcept;
  std::optional<long> crossing_exponent() const noexcept;
  static int sign_of(double value, double error) noexcept { return value > error ? 1 : value < -error ? -1 : 0; }

  std::array<Rough, 4> c_;
  int size_;
};

}  // namespace touchstone::numbers
