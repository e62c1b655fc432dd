// Polynomials as lists of exact coefficients. SPDX-License-Identifier: MIT
#pragma once

#include "numbers/exact_number.hpp"
#include "numbers/polynomial.hpp"

namespace touchstone::numbers {

/// Coefficients of a polynomial, constant first; the formal degree is size - 1.
struct Coefficients {
  const Exact* c;
  int size;

  template <int D>
  Coefficients(const Polynomial<Exact, D>& p) : c(p.c.data()), size(D + 1) {}
  Coefficients(const Exact* first, int count) : c(first), size(count) {}
};

}  // namespace touchstone::numbers
