// An interval around one root that narrows fast. CGAL's own refinement without MPFI halves it, one bit at a time,
// which takes thousands of steps where coordinates of 2^-1000 and 2^1000 meet.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "oracle/algebra.hpp"

namespace touchstone::oracle {

/// denominator^degree p(numerator / denominator): an integer, of the sign of p there when the denominator is positive.
Integer scaled_value(const Polynomial& p, const Integer& numerator, const Integer& denominator);

/// The sign of p at a rational number.
CGAL::Sign sign_at(const Polynomial& p, const Rational& time);

/// A root of a polynomial and an interval [low, high] that holds it and no other: either low < root < high and the
/// polynomial has opposite signs at the ends, or low = root = high.
class Bracket {
 public:
  /// @pre low < high, and opposite signs there; or low = high
  Bracket(const Polynomial& polynomial, const Rational& low, const Rational& high);

  /// Narrows the interval to a length of at most 2^-bits.
  void narrow(unsigned bits);

  /// Whether the interval has shrunk to the root itself, which is then rational.
  bool is_exact() const { return low_ == high_; }

  Rational low() const { return Rational(low_, unit_); }
  Rational high() const { return Rational(high_, unit_); }

  /// The root compared with a rational number, exactly.
  CGAL::Comparison_result compare(const Rational& time) const;

  /// The sign that another polynomial has on all of the interval, or zero when this bound cannot tell (or it is zero).
  /// @pre the interval lies in [-2, 2]
  CGAL::Sign sign_throughout(const Polynomial& other) const;

  /// The value of another polynomial at `low` and how far from it the value at the root can be.
  /// @pre the interval lies in [-2, 2]
  std::pair<Rational, Rational> value_and_error(const Polynomial& other) const;

 private:
  void step();
  void cut_at(const Integer& position);

  Polynomial polynomial_;
  Integer low_, high_, unit_;       // the interval is [low_ / unit_, high_ / unit_], unit_ > 0
  Integer low_value_, high_value_;  // scaled values of the polynomial at its ends
  unsigned cells_log2_ = 1;         // the next step tries for one of 2^cells_log2_ equal cells
};

}  // namespace touchstone::oracle
