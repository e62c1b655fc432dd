// Polynomials as lists of exact coefficients.
// SPDX-License-Identifier: MIT
#pragma once

#include "numbers/integers/exact_number.hpp"
#include "numbers/roots/polynomial.hpp"

namespace touchstone::numbers {

/// The largest degree of a polynomial whose roots and signs are decided. Straight motion takes 3, and 6 for the
/// distance to a plane. Four corners on four bodies that turn take 27, and 54 for the distance.
inline constexpr int kMostDegree = 54;

/// Coefficients of a polynomial, constant first; the formal degree is size - 1.
struct Coefficients {
  const Exact* c;
  int size;

  template <int D>
  Coefficients(const Polynomial<Exact, D>& p) : c(p.c.data()), size(D + 1) {}
  Coefficients(const Exact* first, int count) : c(first), size(count) {}
};

}  // namespace touchstone::numbers
