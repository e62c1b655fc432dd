// Quadratic interval refinement (J. Abbott, 2006): guess by the secant which of N equal cells holds the root. When the
// guess is right, the next step dares N^2 cells, otherwise sqrt(N); near a simple root the number of correct bits
// doubles with every step, and a halving is the least that a step can do.
// SPDX-License-Identifier: MIT
#include "oracle/bracket.hpp"

#include <algorithm>

namespace touchstone::oracle {
namespace {

/// numerator / denominator rounded down, denominator > 0.
Integer floor_quotient(const Integer& numerator, const Integer& denominator) {
  Integer quotient;
  ::mpz_fdiv_q(quotient.mpz(), numerator.mpz(), denominator.mpz());
  return quotient;
}

/// An upper bound of |p'| on [-2, 2]: the sum of k |p_k| 2^(k-1).
Integer slope_bound(const Polynomial& p) {
  Integer slope(0);
  for (int k = p.degree(); k >= 1; --k) slope = 2 * slope + k * CGAL::abs(p[k]);
  return slope;
}

}  // namespace

Integer scaled_value(const Polynomial& p, const Integer& numerator, const Integer& denominator) {
  Integer value = p[p.degree()];
  Integer scale(1);
  for (int k = p.degree() - 1; k >= 0; --k) {
    scale *= denominator;
    value = value * numerator + p[k] * scale;
  }
  return value;
}

CGAL::Sign sign_at(const Polynomial& p, const Rational& time) {
  return CGAL::sign(scaled_value(p, time.numerator(), time.denominator()));
}

Bracket::Bracket(const Polynomial& polynomial, const Rational& low, const Rational& high)
    : polynomial_(polynomial),
      low_(low.numerator() * high.denominator()),
      high_(high.numerator() * low.denominator()),
      unit_(low.denominator() * high.denominator()),
      low_value_(scaled_value(polynomial, low_, unit_)),
      high_value_(scaled_value(polynomial, high_, unit_)) {}

void Bracket::narrow(unsigned bits) {
  while (low_ != high_) {
    Integer length = high_ - low_;
    length <<= bits;
    if (length <= unit_) return;
    step();
  }
}

void Bracket::step() {
  const Integer cell = high_ - low_;  // in the new unit, the length of one cell
  unit_ <<= cells_log2_;
  low_ <<= cells_log2_;
  high_ <<= cells_log2_;
  const unsigned long shift = static_cast<unsigned long>(polynomial_.degree()) * cells_log2_;
  low_value_ <<= shift;
  high_value_ <<= shift;

  Integer cells(1);
  cells <<= cells_log2_;
  const Integer rise = CGAL::abs(low_value_) + CGAL::abs(high_value_);
  const Integer guess = floor_quotient(CGAL::abs(low_value_) * cells, rise);  // less than cells: high_value_ is not 0

  const Integer from = low_ + guess * cell;
  const Integer to = from + cell;
  cut_at(from);
  cut_at(to);
  cells_log2_ = high_ - low_ == cell ? 2 * cells_log2_ : std::max(1U, cells_log2_ / 2);
}

void Bracket::cut_at(const Integer& position) {
  if (position <= low_ || high_ <= position) return;
  const Integer value = scaled_value(polynomial_, position, unit_);
  const CGAL::Sign side = CGAL::sign(value) * CGAL::sign(low_value_);
  if (side >= 0) {
    low_ = position;
    low_value_ = value;
  }
  if (side <= 0) {
    high_ = position;
    high_value_ = value;
  }
}

CGAL::Comparison_result Bracket::compare(const Rational& time) const {
  if (low_ == high_) return CGAL::compare(low(), time);
  if (time <= low()) return CGAL::LARGER;
  if (high() <= time) return CGAL::SMALLER;
  const CGAL::Sign there = sign_at(polynomial_, time);
  if (there == CGAL::ZERO) return CGAL::EQUAL;
  return there == CGAL::sign(low_value_) ? CGAL::LARGER : CGAL::SMALLER;
}

CGAL::Sign Bracket::sign_throughout(const Polynomial& other) const {
  const Integer value = scaled_value(other, low_, unit_);
  if (low_ == high_ || other.degree() <= 0) return CGAL::sign(value);
  // By the mean value theorem the value anywhere differs from this one by at most the length times the slope; both
  // in units of 1 / unit^degree.
  Integer error = (high_ - low_) * slope_bound(other);
  for (int k = 1; k < other.degree(); ++k) error *= unit_;
  return CGAL::abs(value) > error ? CGAL::sign(value) : CGAL::ZERO;
}

std::pair<Rational, Rational> Bracket::value_and_error(const Polynomial& other) const {
  return {other.evaluate(low()), (high() - low()) * Rational(slope_bound(other))};
}

}  // namespace touchstone::oracle
