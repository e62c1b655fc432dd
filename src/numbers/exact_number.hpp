// The exact ring that decisions are made in: dyadic rationals of any size.
// SPDX-License-Identifier: MIT
#pragma once

#include <CGAL/Gmpz.h>
#include <CGAL/Mpzf.h>

#include <string>

#include "numbers/polynomial.hpp"

namespace touchstone::numbers {

/// CGAL's ring of floats with an unbounded significand, m * 2^(64 e): made for predicates over doubles. Its small
/// values live inside the object, so that a determinant of doubles allocates nothing.
using Exact = CGAL::Mpzf;

inline int sign_of(const Exact& x) { return static_cast<int>(x.sign()); }
inline bool is_zero(const Exact& x) { return x.is_zero(); }

template <int D>
bool is_zero(const Polynomial<Exact, D>& p) {
  for (const Exact& c : p.c) {
    if (!is_zero(c)) return false;
  }
  return true;
}

/// The same integer. (Mpzf's own conversion takes the magnitude, and not of a zero.)
Exact exact_from_integer(const CGAL::Gmpz& integer);

/// 2^exponent for any exponent.
Exact power_of_two(long exponent);

/// x as significand * 2^exponent with 0.5 <= |significand| < 1 (0 and 0 for zero), for x of any magnitude. The
/// significand's relative error is at most 2^-52.
struct Approximation {
  double significand;
  long exponent;
};
Approximation approximate(const Exact& x);

/// The double nearest to numerator / denominator within a relative error of 2^-50, for operands of any magnitude; the
/// denominator is not zero. Overflows to infinity and underflows to zero as ldexp does.
double approximate_quotient(const Exact& numerator, const Exact& denominator);

/// For a person: "0", "-3", "5 * 2^-54".
std::string to_string(const Exact& x);

/// For a person, in lowest terms: "1/3", "2". The denominator is not zero.
std::string quotient_to_string(const Exact& numerator, const Exact& denominator);

}  // namespace touchstone::numbers
