// SPDX-License-Identifier: MIT
#include "numbers/common_denominator.hpp"

#include <CGAL/Gmpz.h>
#include <gmp.h>

#include <string>

namespace touchstone::numbers {

std::vector<Exact> over_common_denominator(const std::vector<std::pair<std::string_view, std::string_view>>& fractions) {
  const auto integer = [](std::string_view text) { return CGAL::Gmpz(std::string(text)); };
  CGAL::Gmpz multiple(1);
  for (const auto& fraction : fractions) {
    const CGAL::Gmpz denominator = integer(fraction.second);
    mpz_lcm(multiple.mpz(), multiple.mpz(), denominator.mpz());
  }
  std::vector<Exact> integers;
  integers.reserve(fractions.size());
  for (const auto& [numerator, denominator] : fractions) {
    const CGAL::Gmpz value = integer(numerator) * (multiple / integer(denominator));
    integers.push_back(exact_from_integer(value));
  }
  return integers;
}

}  // namespace touchstone::numbers
