// SPDX-License-Identifier: MIT
#include "numbers/roots/common_divisor.hpp"

#include "numbers/integers/gmp_conversions.hpp"
#include "numbers/roots/integer_polynomial.hpp"

namespace touchstone::numbers {

std::vector<Exact> simple_common_divisor(Coefficients p, Coefficients q) {
  const Integers common = greatest_common_divisor(primitive_integers(p), primitive_integers(q));
  Integers simple = {1};
  for (const Integers& factor : factors_by_multiplicity(common)) simple = product(simple, factor);
  std::vector<Exact> result;
  for (const mpz_class& c : simple) result.push_back(exact_from_integer(c));
  return result;
}

}  // namespace touchstone::numbers
