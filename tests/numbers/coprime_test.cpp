// A prime tells that two polynomials have no common root; it never tells so where they have one.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "numbers/integers/exact_number.hpp"
#include "numbers/roots/coprime.hpp"
#include "numbers/roots/integer_polynomial.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

namespace touchstone::tests {
namespace {

using numbers::Coefficients;
using numbers::Exact;
using Polynomial = std::vector<Exact>;

constexpr std::uint64_t kSeed = 91;
const Exact kPrime = numbers::power_of_two(61) - Exact(1);

Coefficients of(const Polynomial& c) { return {c.data(), static_cast<int>(c.size())}; }

/// Numbers of one limb or of several, with exponents of both signs.
Exact number(seeded::Rng& rng) {
  Exact x(std::ldexp(rng.symmetric(), rng.between(-3, 3)));
  if (rng.one_in(2)) x = Exact(rng.between(-4, 4));
  if (rng.one_in(4)) x = x * x * x + Exact(rng.symmetric());
  return rng.one_in(8) ? x * numbers::power_of_two(rng.between(-700, 700)) : x;
}

Polynomial polynomial(seeded::Rng& rng, int degree) {
  Polynomial c;
  for (int i = 0; i <= degree; ++i) c.push_back(number(rng));
  while (numbers::is_zero(c.back())) c.back() = number(rng);
  return c;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] = c[i + j] + a[i] * b[j];
  }
  return c;
}

TEST_CASE("polynomials with a common root are never told to be coprime, and others nearly always are") {
  std::size_t coprime = 0, told = 0;
  for (std::uint64_t index = 0; index < 3000; ++index) {
    seeded::Rng rng(seeded::seed_of_stream(kSeed, index));
    INFO("seed " << kSeed << ", index " << index);
    const Polynomial p = polynomial(rng, rng.between(1, 9)), q = polynomial(rng, rng.between(0, 9));
    const Polynomial common = polynomial(rng, rng.between(1, 5));
    REQUIRE_FALSE(numbers::certainly_coprime(of(product(p, common)), of(product(q, common))));
    const auto divisor =
        numbers::greatest_common_divisor(numbers::primitive_integers(of(p)), numbers::primitive_integers(of(q)));
    const bool found = numbers::certainly_coprime(of(p), of(q));
    if (divisor.size() > 1) REQUIRE_FALSE(found);
    coprime += divisor.size() == 1;
    told += found;
  }
  std::printf("%zu pairs of 3000 are coprime, and %zu are told to be\n", coprime, told);
  CHECK(coprime > 1000);
  CHECK(told == coprime);
}

TEST_CASE("where the prime divides coefficients, nothing is told") {
  const Exact one(1), two(2);
  // Modulo the prime the first polynomial loses its root, and the other has no terms at all.
  REQUIRE_FALSE(numbers::certainly_coprime(of({one, kPrime}), of({two, kPrime})));
  REQUIRE_FALSE(numbers::certainly_coprime(of({one, one}), of({kPrime, kPrime})));
  REQUIRE_FALSE(numbers::certainly_coprime(of({one, one}), of({Exact(0), Exact(0)})));
  // t + 1 and t + 1 + the prime are the same to it.
  REQUIRE_FALSE(numbers::certainly_coprime(of({one, one}), of({one + kPrime, one})));
  REQUIRE(numbers::certainly_coprime(of({one, one}), of({two, one})));
  REQUIRE(numbers::certainly_coprime(of({one, one}), of({two, kPrime})));
  REQUIRE(numbers::certainly_coprime(of({one, one}), of({two})));
}

}  // namespace
}  // namespace touchstone::tests
