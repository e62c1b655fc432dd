// Sparse numbers, the bounds on their leading digits, and their roots, against exact ones.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "numbers/near_root.hpp"
#include "numbers/real_root.hpp"
#include "numbers/sparse_root.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using numbers::Doubt;
using numbers::Exact;
using numbers::Polynomial;
using numbers::Sparse;
using numbers::SparseScratch;

namespace {

/// One number in both types.
struct Both {
  Sparse sparse;
  Exact exact = Exact(0);

  friend Both operator+(const Both& a, const Both& b) { return {a.sparse + b.sparse, a.exact + b.exact}; }
  friend Both operator-(const Both& a, const Both& b) { return {a.sparse - b.sparse, a.exact - b.exact}; }
  friend Both operator*(const Both& a, const Both& b) { return {a.sparse * b.sparse, a.exact * b.exact}; }
};

Both term(double significand, int exponent) {
  return {Sparse::scaled(significand, -exponent), Exact(significand) * numbers::power_of_two(exponent)};
}

/// A sum of a few terms, whose exponents come from a pool as those of a query do.
Both random_number(tests::Rng& rng, const std::array<int, 4>& pool) {
  Both sum;
  for (int i = rng.between(0, 5); i > 0; --i) {
    const double significand = rng.one_in(3) ? rng.symmetric() : rng.between(-4, 4);
    sum = sum + term(significand, rng.pick(pool));
  }
  return sum;
}

std::array<int, 4> random_pool(tests::Rng& rng) {
  const int reach = rng.one_in(2) ? 900 : rng.one_in(2) ? 60 : 130;
  std::array<int, 4> pool{};
  for (int& exponent : pool) exponent = rng.between(-reach, reach);
  return pool;
}

/// Takes the leading bits off both until nothing is left.
bool equal(const Both& x) {
  const SparseScratch::Rewind rewind;
  Both rest = x;
  constexpr int kMostParts = 400;
  for (int i = 0; i < kMostParts; ++i) {
    const numbers::Approximation a = approximate(rest.sparse), b = numbers::approximate(rest.exact);
    if (sign_of(rest.sparse) != sign_of(rest.exact)) return false;
    if (rest.sparse.is_zero()) return true;
    const double other = std::ldexp(b.significand, static_cast<int>(b.exponent - a.exponent));
    if (!(std::fabs(a.significand - other) <= 0x1p-51)) return false;
    rest = rest - term(a.significand, static_cast<int>(a.exponent));
  }
  return false;
}

/// Whether the bound on the error of `part` holds for its true value.
template <int Digits>
bool holds(const numbers::Leading<Digits>& part, const Sparse& value) {
  const Sparse error = part.value - value, bound = Sparse::scaled(1, -part.error);
  const bool within = sign_of(error - bound) <= 0 && sign_of(error + bound) >= 0;
  return (error.is_zero() || within) && (part.sign() == 0 || part.sign() == sign_of(value));
}

template <int Degree>
struct BothPolynomials {
  Polynomial<Sparse, Degree> sparse;
  Polynomial<Exact, Degree> exact;
};

template <int Degree>
BothPolynomials<Degree> as_polynomials(const std::array<Both, 4>& c) {
  BothPolynomials<Degree> p;
  for (int i = 0; i <= Degree; ++i) {
    p.sparse[i] = c[static_cast<std::size_t>(i)].sparse;
    p.exact[i] = c[static_cast<std::size_t>(i)].exact;
  }
  return p;
}

/// c times (d t - n).
std::array<Both, 4> times_factor(const std::array<Both, 4>& c, const Both& n, const Both& d) {
  std::array<Both, 4> product;
  for (std::size_t i = 0; i < 4; ++i) product[i] = i > 0 ? d * c[i - 1] - n * c[i] : Both() - n * c[i];
  return product;
}

/// A factor with its root in [0, 1], mostly: near 0, near 1 or at a fraction, all exact or almost.
void random_factor(tests::Rng& rng, const std::array<int, 4>& pool, Both& n, Both& d) {
  const Both small = term(1, -std::abs(rng.pick(pool)));
  const int denominator = rng.between(1, 6);
  d = term(denominator, 0);
  n = term(rng.between(0, denominator), 0);
  if (rng.one_in(2)) n = n + (rng.one_in(2) ? small : Both() - small);
}

/// Products of factors, almost such products, or any coefficients.
std::array<Both, 4> random_coefficients(int degree, tests::Rng& rng, const std::array<int, 4>& pool) {
  std::array<Both, 4> c;
  const int style = rng.between(0, 3);
  if (style == 0) {
    for (int i = 0; i <= degree; ++i) c[static_cast<std::size_t>(i)] = random_number(rng, pool);
    return c;
  }
  c[0] = term(1, 0);
  Both n, d;
  for (int i = 0; i < degree; ++i) {
    if (i == 0 || !rng.one_in(5)) random_factor(rng, pool, n, d);  // the same once more
    c = times_factor(c, n, d);
  }
  if (style == 1) {
    Both& changed = c[static_cast<std::size_t>(rng.between(0, degree))];
    changed = changed + term(rng.between(-1, 1), -2 * std::abs(rng.pick(pool)));
  }
  return c;
}

struct RootReport {
  int roots = 0, doubts = 0, wrong = 0, polynomials = 0, quotients = 0;
};

template <int Degree>
void compare_roots(tests::Rng& rng, RootReport& report) {
  const std::array<int, 4> pool = random_pool(rng);
  Doubt doubt;
  const SparseScratch scratch(doubt);
  const auto coefficients = random_coefficients(Degree, rng, pool);
  const auto p = as_polynomials<Degree>(coefficients);
  if (is_zero(p.sparse)) return;
  ++report.polynomials;
  const double limit = rng.one_in(3) ? rng.unit() : 1;
  const numbers::SparseRoots roots(p.sparse, limit, doubt);
  if (doubt.raised()) {
    ++report.doubts;
    return;
  }
  const numbers::RootList expected = numbers::isolate_roots(p.exact, Exact(limit));
  if (roots.size() != expected.size()) {
    ++report.wrong;
    return;
  }
  const auto q = as_polynomials<2>(random_coefficients(2, rng, pool));
  for (int i = 0; i < roots.size() && !doubt.raised(); ++i) {
    ++report.roots;
    const int signs[] = {roots[i].sign_at(q.sparse), roots[i].sign_after(q.sparse), roots[i].sign_before(q.sparse)};
    const int order = i > 0 ? roots[i].compare(roots[i - 1]) : 1;
    const double lower = roots[i].lower(), upper = roots[i].upper();
    if (doubt.raised()) {
      ++report.doubts;
      return;
    }
    const int exact_signs[] = {expected[i].sign_at(q.exact), expected[i].sign_after(q.exact),
                               expected[i].sign_before(q.exact)};
    const bool same = lower == expected[i].lower() && upper == expected[i].upper() &&
                      roots[i].multiplicity() == expected[i].multiplicity() && signs[0] == exact_signs[0] &&
                      signs[1] == exact_signs[1] && signs[2] == exact_signs[2] && order == 1;
    report.wrong += !same;
    const auto d = as_polynomials<2>(random_coefficients(2, rng, pool));
    const int sign = expected[i].sign_at(d.exact);
    if (sign == 0 || sign * exact_signs[0] < 0 || sign * expected[i].sign_at(d.exact - q.exact) < 0) continue;
    const double quotient = roots[i].quotient(q.sparse, d.sparse);
    if (doubt.raised()) return;
    ++report.quotients;
    report.wrong += !(std::fabs(quotient - expected[i].quotient(q.exact, d.exact)) <= 0x1p-50);
    if constexpr (Degree == 2) {  // (d + 2^k p) / 2 d is 1/2 at the root alone
      const Sparse factor = Sparse::scaled(1, -rng.between(0, 120));
      Polynomial<Sparse, 2> beside = d.sparse;
      for (int k = 0; k <= 2; ++k) beside[k] = d.sparse[k] + p.sparse[k] * factor;
      const double half = roots[i].quotient(beside, d.sparse + d.sparse);
      if (doubt.raised()) return;
      report.wrong += !(std::fabs(half - 0.5) <= 0x1p-50);
    }
  }
}

}  // namespace

TEST_CASE("sparse numbers are exact") {
  tests::Rng rng(51);
  for (std::size_t i = 0; i < tests::effort(40000); ++i) {
    Doubt doubt;
    const SparseScratch scratch(doubt);
    const std::array<int, 4> pool = random_pool(rng);
    const Both a = random_number(rng, pool), b = random_number(rng, pool), c = random_number(rng, pool);
    REQUIRE(equal(a + b));
    REQUIRE(equal(a - b));
    REQUIRE(equal(a * b));
    REQUIRE(equal(a * b - b * a));
    REQUIRE(equal((a + b) * (a - b)));
    REQUIRE(equal({multiply_add(a.sparse, b.sparse, c.sparse), a.exact * b.exact + c.exact}));
    const Both square = a * b * (a * b);
    REQUIRE(equal(square));
    if (!square.sparse.is_zero()) {
      const Sparse bound = Sparse::scaled(1, -square.sparse.bits());
      REQUIRE(sign_of(bound - square.sparse) > 0);
      REQUIRE(sign_of(bound - square.sparse * Sparse(8)) < 0);
    }
    REQUIRE(!doubt.raised());
  }
}

TEST_CASE("leading digits are within their error") {
  tests::Rng rng(52);
  using Part = numbers::Leading<2>;
  int uncertain = 0, certain = 0;
  for (std::size_t i = 0; i < tests::effort(40000); ++i) {
    Doubt doubt;
    const SparseScratch scratch(doubt);
    const std::array<int, 4> pool = random_pool(rng);
    Sparse value = random_number(rng, pool).sparse;
    Part part(value);
    for (int step = 0; step < 4; ++step) {
      const Sparse x = random_number(rng, pool).sparse, y = random_number(rng, pool).sparse;
      switch (rng.between(0, 3)) {
        case 0: part = part + Part(x), value = value + x; break;
        case 1: part = part - Part(x), value = value - x; break;
        case 2: part = part * Part(x), value = value * x; break;
        default: part = multiply_add(part, Part(x), Part(y)), value = multiply_add(value, x, y); break;
      }
      REQUIRE(holds(part, value));
      REQUIRE((value.is_zero() || part.most_bits() >= value.bits() - 2));
      (part.sign() != 0 ? certain : uncertain) += 1;
    }
    const Sparse close = value + Sparse::scaled(rng.symmetric(), 40 - rng.pick(pool));  // the leading digits cancel
    REQUIRE(holds(Part(close) - Part(value), close - value));
    REQUIRE(holds(part - Part(close), value - close));
  }
  CHECK(certain > uncertain);
  CHECK(uncertain > 0);
}

TEST_CASE("sparse roots are those of real_root") {
  tests::Rng rng(53);
  RootReport report;
  for (std::size_t i = 0; i < tests::effort(60000); ++i) {
    compare_roots<1>(rng, report);
    compare_roots<2>(rng, report);
    compare_roots<3>(rng, report);
  }
  std::printf("%d polynomials, %d roots, %d in doubt, %d wrong\n", report.polynomials, report.roots, report.doubts,
              report.wrong);
  CHECK(report.wrong == 0);
  CHECK(report.roots > report.polynomials / 3);
  CHECK(report.doubts * 50 < report.polynomials);
  CHECK(report.quotients * 20 > report.roots);
}

TEST_CASE("double roots at doubles leave no doubt") {
  // (t - r)^2 (6 t - k), with r a double and the third root before it, at it, after it or outside [0, 1].
  const double doubles[] = {0x1p-1, 0x3p-3, 0x1p-900, 1 - 0x1p-40};
  int before = 0, after = 0;
  for (const double r : doubles) {
    for (int k = -6; k <= 12; ++k) {
      Doubt doubt;
      const SparseScratch scratch(doubt);
      std::array<Both, 4> c = {term(k % 2 == 0 ? 1 : -1, 700)};
      for (int i = 0; i < 2; ++i) c = times_factor(c, term(r, 0), term(1, 0));
      const auto p = as_polynomials<3>(times_factor(c, term(k, 0), term(6, 0)));
      const numbers::SparseRoots roots(p.sparse, 1, doubt);
      const numbers::RootList expected = numbers::isolate_roots(p.exact, Exact(1));
      REQUIRE(!doubt.raised());
      REQUIRE(roots.size() == expected.size());
      for (int i = 0; i < roots.size(); ++i) {
        REQUIRE(roots[i].lower() == expected[i].lower());
        REQUIRE(roots[i].upper() == expected[i].upper());
        REQUIRE(roots[i].multiplicity() == expected[i].multiplicity());
      }
      if (roots.size() == 2) ++(roots[0].multiplicity() == 2 ? after : before);
    }
  }
  CHECK(before > 0);
  CHECK(after > 0);
}

TEST_CASE("negatives stay within the memory, wherever it ends") {
  // A digit of -2^59 has no negative: that is 2^60 - 2^59, two digits. All sizes of what is in use cover both ends.
  constexpr int kDigits = 20, kLeast = 1200, kMost = 7040;
  int raised = 0;
  for (int used = kLeast; used < kMost; ++used) {
    Doubt doubt;
    const SparseScratch scratch(doubt);
    Sparse x, other;
    for (int i = 0; i < kDigits; ++i) x = x + Sparse::scaled(-1, -(59 + 120 * i));
    for (int i = 0; i < used; ++i) other = Sparse(1);
    const Sparse negative = -x;
    if (doubt.raised()) {
      ++raised;
    } else {
      REQUIRE((negative + x).is_zero());
      REQUIRE(sign_of(negative) == 1);
    }
  }
  CHECK(raised > 0);
}

TEST_CASE("work without end raises the doubt") {
  Doubt doubt;
  const SparseScratch scratch(doubt);
  Sparse x(3);
  for (int i = 1; i < 60; ++i) x = x + Sparse::scaled(5, 100 * i);
  for (int i = 0; i < 30 && !doubt.raised(); ++i) x = x * x;
  CHECK(doubt.raised());
}

TEST_CASE("many products raise the doubt, whatever memory they take") {
  Doubt doubt;
  const SparseScratch scratch(doubt);
  const Sparse x = Sparse::scaled(3, -900) + Sparse::scaled(1, 900);  // two digits
  constexpr int kMost = 10000;                                        // 40,000 of digits
  const auto square = [&] {
    const SparseScratch::Rewind rewind;
    return (x * x).sign();
  };
  for (int i = 0; i < kMost; ++i) REQUIRE(square() == 1);
  CHECK(!doubt.raised());
  CHECK(square() == 0);
  CHECK(doubt.raised());
}
