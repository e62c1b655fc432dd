// SPDX-License-Identifier: MIT
#include "numbers/integers/common_denominator.hpp"

#include <gmpxx.h>

#include <string>

#include "numbers/integers/gmp_conversions.hpp"

namespace touchstone::numbers {

std::vector<Exact> over_common_denominator(
    const std::vector<std::pair<std::string_view, std::string_view>>& fractions) {
  const auto integer = [](std::string_view text) { return mpz_class(std::string(text)); };
  mpz_class multiple(1);
  for (const auto& fraction : fractions) multiple = lcm(multiple, integer(fraction.second));
  std::vector<Exact> integers;
  integers.reserve(fractions.size());
  for (const auto& [numerator, denominator] : fractions) {
    integers.push_back(exact_from_integer(integer(numerator) * (multiple / integer(denominator))));
  }
  return integers;
}

std::vector<Exact> without_common_factor(const std::vector<Exact>& numbers) {
  std::vector<mpq_class> rationals;
  mpz_class multiple(1), factor(0);
  for (const Exact& x : numbers) {
    rationals.push_back(to_rational(x));
    multiple = lcm(multiple, rationals.back().get_den());
  }
  for (mpq_class& x : rationals) {
    x *= multiple;
    factor = gcd(factor, x.get_num());
  }
  std::vector<Exact> integers;
  integers.reserve(numbers.size());
  for (const mpq_class& x : rationals) {
    integers.push_back(factor == 0 ? Exact(0) : exact_from_integer(mpz_class(x.get_num() / factor)));
  }
  return integers;
}

}  // namespace touchstone::numbers
