// Signs of polynomials in doubles of any exponent, against exact ones: where they are certain, they are right.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "numbers/near_root.hpp"
#include "numbers/sparse_values.hpp"
#include "numbers/wide_polynomial.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using numbers::Doubt;
using numbers::Sparse;
using numbers::SparseScratch;
using numbers::WidePoint;
using numbers::WidePolynomial;

namespace {

using Coefficients = std::array<Sparse, 4>;

Sparse at(const WidePoint& x) { return numbers::sparse(x.significand, x.exponent); }

WidePoint random_point(tests::Rng& rng) {
  const int reach = rng.one_in(2) ? 3 : 1200;
  return {0.25 + 0.75 * rng.unit(), -rng.between(0, reach), 0};
}

/// 53 bits, or few of them; sometimes more far below, which doubles do not see.
Sparse random_coefficient(tests::Rng& rng, int reach) {
  if (rng.one_in(8)) return Sparse();
  const double significand = rng.one_in(2) ? rng.symmetric() : rng.between(-9, 9);
  Sparse c = numbers::sparse(significand, rng.between(-reach, reach));
  if (rng.one_in(3)) c = c + numbers::sparse(rng.symmetric(), rng.between(-reach, reach));
  return c;
}

Sparse value(const Coefficients& c, int size, const Sparse& x) {
  return numbers::value_at<Sparse>(c.data(), size, x, Sparse(1));
}

/// A polynomial, often with a root at x but for a change of its constant that is close to the rounding of doubles.
Coefficients polynomial_near(const Sparse& x, int size, tests::Rng& rng) {
  const int reach = rng.one_in(2) ? 4 : 900;
  Coefficients c;
  for (int i = 0; i < size; ++i) c[static_cast<std::size_t>(i)] = random_coefficient(rng, reach);
  if (rng.one_in(4)) return c;
  c[0] = c[0] - value(c, size, x);
  long greatest = numbers::kNoError;
  Sparse power(1);
  for (int i = 0; i < size; ++i) {
    greatest = std::max(greatest, (c[static_cast<std::size_t>(i)] * power).bits());
    power = power * x;
  }
  if (greatest > numbers::kNoError) {
    c[0] = c[0] + numbers::sparse(rng.symmetric(), greatest - rng.between(38, 58));
  }
  return c;
}

struct Tally {
  int certain = 0, uncertain = 0, wrong = 0;
  void add(int sign, int exact) {
    (sign != 0 ? certain : uncertain) += 1;
    wrong += sign != 0 && sign != exact;
  }
};

template <class N>
std::array<N, 4> as(const Coefficients& c) {
  return {N(c[0]), N(c[1]), N(c[2]), N(c[3])};
}

}  // namespace

TEST_CASE("signs in wide doubles are right at all points of the slack") {
  tests::Rng rng(71);
  Tally tally;
  for (std::size_t i = 0; i < tests::effort(100000); ++i) {
    Doubt doubt;
    const SparseScratch scratch(doubt);
    WidePoint point = random_point(rng);
    // The point itself, or one that is off by all of the slack, or by some of it.
    const double off = rng.one_in(3) ? 0 : rng.one_in(2) ? 1 : rng.symmetric();
    const int bits = rng.between(8, 60);
    if (off != 0) point.slack = std::ldexp(1, -bits);
    const Sparse x = at(point) + at(point) * numbers::sparse(rng.one_in(2) ? off : -off, -bits);
    const int size = rng.between(1, 4);
    const Coefficients c = polynomial_near(x, size, rng);
    const int exact = value(c, size, x).sign();
    tally.add(WidePolynomial(c.data(), size).sign_at(point), exact);
    const auto leading = as<numbers::Leading<1>>(c);
    tally.add(WidePolynomial(leading.data(), size).sign_at(point), exact);
    REQUIRE(!doubt.raised());
    REQUIRE(tally.wrong == 0);
  }
  CHECK(tally.certain > tally.uncertain / 4);
  CHECK(tally.uncertain > tally.certain / 40);
}

TEST_CASE("coefficients with the error of their leading digits leave the sign open where it is") {
  tests::Rng rng(72);
  Tally tally;
  for (std::size_t i = 0; i < tests::effort(40000); ++i) {
    Doubt doubt;
    const SparseScratch scratch(doubt);
    // Differences that take the leading digits away.
    Coefficients c;
    std::array<numbers::Leading<1>, 4> leading;
    for (std::size_t k = 0; k < 4; ++k) {
      const Sparse a = random_coefficient(rng, 200), b = a + random_coefficient(rng, 200),
                   d = random_coefficient(rng, 90);
      c[k] = (a - b) * d;
      leading[k] = (numbers::Leading<1>(a) - numbers::Leading<1>(b)) * numbers::Leading<1>(d);
    }
    const WidePoint point = random_point(rng);
    tally.add(WidePolynomial(leading.data(), 4).sign_at(point), value(c, 4, at(point)).sign());
    REQUIRE(!doubt.raised());
    REQUIRE(tally.wrong == 0);
  }
  CHECK(tally.certain > tally.uncertain / 10);
  CHECK(tally.uncertain > tally.certain / 40);
}

TEST_CASE("Bernstein coefficients in wide doubles have the right signs") {
  tests::Rng rng(73);
  Tally tally;
  for (std::size_t i = 0; i < tests::effort(40000); ++i) {
    Doubt doubt;
    const SparseScratch scratch(doubt);
    const WidePoint high = random_point(rng);
    std::optional<WidePoint> low = random_point(rng);
    if (rng.one_in(3) || (at(high) - at(*low)).sign() <= 0) low.reset();
    const Sparse x = low ? at(*low) : Sparse(), y = at(high);
    Coefficients c = polynomial_near(low && rng.one_in(2) ? x : y, 4, rng);
    if (low && !c[1].is_zero() && rng.one_in(4)) {  // what is too small for a window decides
      c[0] = numbers::sparse(rng.symmetric(), x.bits() + c[1].bits() + rng.between(-3, 3));
      c[1] = c[0].sign() * c[1].sign() > 0 ? -c[1] : c[1];
    }
    const auto blossoms = [&] {
      std::array<Sparse, 4> values;
      for (std::size_t k = 0; k < 4; ++k) {
        const Sparse &a = k < 3 ? x : y, &b = k < 2 ? x : y, &d = k < 1 ? x : y;
        values[k] = Sparse(3) * (c[0] + c[3] * a * b * d) + c[1] * (a + b + d) + c[2] * (a * b + a * d + b * d);
      }
      return values;
    };
    if (rng.one_in(2)) {  // one of them almost vanishes
      const Sparse off = blossoms()[static_cast<std::size_t>(rng.between(0, 3))];
      const Sparse more = numbers::sparse(rng.symmetric(), off.is_zero() ? 0 : off.bits() - rng.between(38, 58));
      for (Sparse& coefficient : c) coefficient = coefficient * Sparse(3);
      c[0] = c[0] - off + more;
    }
    const auto exact = blossoms();
    const auto signs = WidePolynomial(c.data(), 4).bernstein_signs(low, high);
    REQUIRE(!doubt.raised());
    for (std::size_t k = 0; k < 4; ++k) tally.add(signs[k], exact[k].sign());
    REQUIRE(tally.wrong == 0);
  }
  CHECK(tally.certain > tally.uncertain);
  CHECK(tally.uncertain > tally.certain / 40);
}

TEST_CASE("a bracket in wide doubles has a root") {
  tests::Rng rng(74);
  int found = 0, changes = 0;
  for (std::size_t i = 0; i < tests::effort(40000); ++i) {
    Doubt doubt;
    const SparseScratch scratch(doubt);
    const WidePoint root = random_point(rng), high;
    const int size = rng.between(2, 4);
    const Coefficients c = polynomial_near(at(root), size, rng);
    std::optional<WidePoint> low;
    if (rng.one_in(2)) low = {0.5, root.exponent - rng.between(2, 60), 0};
    const int first = value(c, size, low ? at(*low) : Sparse()).sign(), last = value(c, size, Sparse(1)).sign();
    if (first * last >= 0) continue;
    ++changes;
    const auto bracket = WidePolynomial(c.data(), size).bracket(low, high, first);
    if (!bracket) continue;
    ++found;
    const Sparse a = numbers::sparse(bracket->low, bracket->exponent),
                 b = numbers::sparse(bracket->high, bracket->exponent);
    REQUIRE(value(c, size, a).sign() == first);
    REQUIRE(value(c, size, b).sign() == last);
    REQUIRE((b - a).bits() <= b.bits() - 30);
    // The whole bracket is within the slack of its point.
    const WidePoint middle = bracket->point();
    const Sparse m = at(middle), off = m * numbers::sparse(middle.slack);
    REQUIRE((m - off - a).sign() <= 0);
    REQUIRE((m + off - b).sign() >= 0);
    REQUIRE(!doubt.raised());
  }
  CHECK(found * 10 > changes * 7);
}
