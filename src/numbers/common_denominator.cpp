// SPDX-License-Identifier: MIT
#include "numbers/common_denominator.hpp"

#include <gmpxx.h>

#include <string>

#include "numbers/gmp_conversions.hpp"

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

}  // namespace touchstone::numbers
