// Polynomials with integer coefficients: common divisors, and factors whose roots are simple.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <gmpxx.h>

#include "numbers/roots/coefficients.hpp"

namespace touchstone::numbers {

/// A polynomial with integer coefficients, constant first; the leading one is not zero. Empty for the zero polynomial.
using Integers = std::vector<mpz_class>;

/// A positive multiple of p without a common factor of the coefficients.
Integers primitive_integers(Coefficients p);

/// The greatest common divisor, primitive. One of them may be zero.
Integers greatest_common_divisor(Integers a, Integers b);

/// The product of two polynomials.
Integers product(const Integers& a, const Integers& b);

/// Element i is the product of (t - root) over the roots of multiplicity i + 1, up to a constant.
std::vector<Integers> factors_by_multiplicity(const Integers& p);

}  // namespace touchstone::numbers
