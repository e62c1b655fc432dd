// The arithmetic of doubles, one function an operation, so that a check can be tried on a wrong one.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::cli {

struct Arithmetic {
  double (*sum)(double, double);
  double (*product)(double, double);
  double (*quotient)(double, double);
  double (*root)(double);
  double (*fused)(double a, double b, double c);            ///< a b + c, rounded once
  double (*product_and_sum)(double a, double b, double c);  ///< a b + c, rounded twice, as the filters' bounds need it
  double (*sum_of_three)(double a, double b, double c);     ///< (a + b) + c, in this order
};

/// That of this build and this processor, compiled with the flags of the library.
extern const Arithmetic kThisArithmetic;

}  // namespace touchstone::cli
