// SPDX-License-Identifier: MIT
#include "cli/doctor/arithmetic.hpp"

#include <cmath>

namespace touchstone::cli {
namespace {

/// A value that the compiler knows nothing about: no operation on it is done before the program runs, or moved over a
/// change of the rounding mode.
double opaque(double x) {
  volatile double hidden = x;
  return hidden;
}

double sum(double a, double b) { return opaque(opaque(a) + opaque(b)); }
double product(double a, double b) { return opaque(opaque(a) * opaque(b)); }
double quotient(double a, double b) { return opaque(opaque(a) / opaque(b)); }
double root(double a) { return opaque(std::sqrt(opaque(a))); }
double fused(double a, double b, double c) { return opaque(std::fma(opaque(a), opaque(b), opaque(c))); }

// The operands are opaque and the steps between them are not, so that a flag which lets the compiler contract or
// reassociate has its effect here as in the filters.
double product_and_sum(double a, double b, double c) {
  const double x = opaque(a), y = opaque(b), z = opaque(c);
  return opaque(x * y + z);
}
double sum_of_three(double a, double b, double c) {
  const double x = opaque(a), y = opaque(b), z = opaque(c);
  return opaque((x + y) + z);
}

}  // namespace

const Arithmetic kThisArithmetic = {&sum, &product, &quotient, &root, &fused, &product_and_sum, &sum_of_three};

}  // namespace touchstone::cli
