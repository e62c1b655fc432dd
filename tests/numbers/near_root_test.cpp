// Roots in double-doubles against exact ones: their number, times, multiplicities, order, and signs there.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gmpxx.h>

#include "numbers/integers/small_int.hpp"
#include "numbers/roots/near_root.hpp"
#include "numbers/roots/real_root.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using numbers::Doubt;
using numbers::Exact;
using numbers::FixedInt;
using numbers::NearRoots;
using numbers::Polynomial;
using numbers::RootList;
using numbers::SmallInt;

namespace {

using Integers = std::array<std::int64_t, 4>;

/// Small, large or with roots that are known, some of them together: what real input has, and what is hard.
Integers random_coefficients(int degree, tests::Rng& rng) {
  Integers c{};
  const int style = rng.between(0, 4);
  if (style <= 1) {
    const int greatest = style == 0 ? 8 : 1 << 20;
    for (int i = 0; i <= degree; ++i) c[static_cast<std::size_t>(i)] = rng.between(-greatest, greatest);
    return c;
  }
  c[0] = 1;
  for (int factor = 0; factor < degree; ++factor) {  // times d t - n
    const int d = rng.between(1, style == 2 ? 6 : 1000);
    const int n = rng.between(style == 2 ? 0 : -10, d);
    Integers product{};
    for (std::size_t i = 0; i < 4; ++i) product[i] = (i > 0 ? d * c[i - 1] : 0) - n * c[i];
    c = product;
  }
  if (style == 4) c[static_cast<std::size_t>(rng.between(0, degree))] += rng.between(-1, 1);
  return c;
}

template <int Limbs>
FixedInt<Limbs> fixed(std::int64_t value, int shift) {
  const auto product = FixedInt<1>::integer(value) * FixedInt<Limbs>::scaled(1, -shift);
  FixedInt<Limbs> result;
  for (int limb = 0; limb < Limbs; ++limb) result.set_limb(limb, product.limb(limb));
  return result;
}

template <int Limbs, int Degree>
Polynomial<FixedInt<Limbs>, Degree> fixed(const Integers& c, int shift = 0) {
  Polynomial<FixedInt<Limbs>, Degree> p;
  for (int i = 0; i <= Degree; ++i) p[i] = fixed<Limbs>(c[static_cast<std::size_t>(i)], shift);
  return p;
}

/// The types of coefficients that near roots take: FixedInt of any number of limbs, and SmallInt.
template <int Limbs>
struct Fixed {
  using Roots = NearRoots<Limbs>;
  static auto cubic(const Integers& c, int shift) { return fixed<3 * Limbs, 3>(c, shift); }
  static auto quadratic(const Integers& c) { return fixed<2 * Limbs, 2>(c); }
};
struct Small {
  using Roots = NearRoots<1>;
  template <int Degree>
  static Polynomial<SmallInt, Degree> polynomial(const Integers& c) {
    Polynomial<SmallInt, Degree> p;
    for (int i = 0; i <= Degree; ++i) p[i] = SmallInt::integer(c[static_cast<std::size_t>(i)]);
    return p;
  }
  static auto cubic(const Integers& c, int) { return polynomial<3>(c); }
  static auto quadratic(const Integers& c) { return polynomial<2>(c); }
};

struct Tally {
  long roots = 0, zeros = 0, doubts = 0;
};

/// Whether a doubt was raised; takes it back.
bool doubtful(Doubt& doubt, Tally& tally) {
  const bool raised = doubt.raised();
  tally.doubts += raised;
  doubt = Doubt();
  return raised;
}

template <class Type>
void check_polynomial(const Integers& c, int degree, int shift, double limit, tests::Rng& rng, Tally& tally) {
  Doubt doubt;
  const typename Type::Roots near(Type::cubic(c, shift), limit, doubt);
  if (doubtful(doubt, tally)) return;
  const RootList real = isolate_roots(to_exact(fixed<6, 3>(c, shift)), Exact(limit));
  INFO(c[0] << ", " << c[1] << ", " << c[2] << ", " << c[3] << " times 2^" << shift << " up to " << limit);
  REQUIRE(near.size() == real.size());
  for (int i = 0; i < near.size(); ++i) {
    ++tally.roots;
    REQUIRE(near[i].lower() == real[i].lower());
    REQUIRE(near[i].upper() == real[i].upper());
    REQUIRE(near[i].multiplicity() == real[i].multiplicity());
    for (int j = 0; j < 4; ++j) {
      // Some share roots: the polynomial itself, or its derivative at a repeated root.
      const Integers derivative = {c[1], 2 * c[2], 3 * c[3], 0};
      const Integers d = j == 0 && degree <= 2 ? c : j == 1 ? derivative : random_coefficients(2, rng);
      const auto q = Type::quadratic(d);
      const auto q_exact = to_exact(fixed<4, 2>(d));
      INFO("the sign of " << d[0] << ", " << d[1] << ", " << d[2] << " at root " << i);
      const int sign = near[i].sign_at(q);
      if (doubtful(doubt, tally)) continue;
      tally.zeros += sign == 0;
      REQUIRE(sign == real[i].sign_at(q_exact));
      const int after = near[i].sign_after(q), before = near[i].sign_before(q);
      if (doubtful(doubt, tally)) continue;
      REQUIRE(after == real[i].sign_after(q_exact));
      REQUIRE(before == real[i].sign_before(q_exact));
    }
  }
  Integers other = random_coefficients(2, rng);
  if (degree <= 2 && rng.one_in(2)) {
    for (std::size_t i = 0; i < 4; ++i) other[i] = 3 * c[i];
  }
  const auto o = Type::cubic(other, 0);
  if (is_zero(o)) return;
  const typename Type::Roots others(o, 1, doubt);
  if (doubtful(doubt, tally)) return;
  const RootList others_real = isolate_roots(to_exact(fixed<6, 3>(other)), Exact(1));
  for (int i = 0; i < near.size(); ++i) {
    for (int j = 0; j < others.size(); ++j) {
      const int order = near[i].compare(others[j]);
      if (!doubtful(doubt, tally)) REQUIRE(order == real[i].compare(others_real[j]));
    }
  }
}

}  // namespace

TEST_CASE("near roots and signs there are the exact ones") {
  tests::Rng rng(2026);
  Tally tally;
  const std::size_t polynomials = tests::effort(18000);
  for (std::size_t i = 0; i < polynomials; ++i) {
    const int degree = rng.between(1, 3);
    const Integers c = random_coefficients(degree, rng);
    if (c == Integers{}) continue;
    const int shift = rng.one_in(3) ? rng.between(0, 100) : 0;
    const double limit = rng.one_in(4) ? rng.between(0, 64) / 64.0 : 1;
    switch (i % 3) {
      case 0: check_polynomial<Small>(c, degree, 0, limit, rng, tally); break;
      case 1: check_polynomial<Fixed<1>>(c, degree, shift, limit, rng, tally); break;
      default: check_polynomial<Fixed<2>>(c, degree, shift, limit, rng, tally); break;
    }
  }
  std::printf("%ld roots, %ld signs of zero, %ld doubts\n", tally.roots, tally.zeros, tally.doubts);
  CHECK(static_cast<std::size_t>(tally.roots) > polynomials / 2);
  CHECK(static_cast<std::size_t>(tally.zeros) > polynomials / 10);
  CHECK(static_cast<std::size_t>(tally.doubts) * 500 < polynomials);
}

TEST_CASE("rational roots of polynomials of few bits, and what is almost one, are the exact ones") {
  const std::size_t count = tests::effort(20000);
  tests::Rng rng(29);
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) {
    const int degree = rng.between(2, 3);
    const int bits = rng.between(1, 12);
    Integers c = {1, 0, 0, 0};
    std::int64_t n = 0, d = 1;
    for (int factor = 0; factor < degree; ++factor) {  // times d t - n, often the same one
      if (factor == 0 || !rng.one_in(3)) {
        d = rng.between(1, 1 << bits);
        n = rng.one_in(6) ? rng.between(-2 << bits, 2 << bits) : rng.between(0, static_cast<int>(d));
      }
      Integers product{};
      for (std::size_t k = 0; k < 4; ++k) product[k] = (k > 0 ? d * c[k - 1] : 0) - n * c[k];
      c = product;
    }
    if (rng.one_in(3)) c[static_cast<std::size_t>(rng.between(0, degree))] += rng.between(-1, 1);
    const int factor = rng.between(1, 5);
    for (std::int64_t& coefficient : c) coefficient *= rng.one_in(2) ? factor : 1;  // some are no such product
    if (c == Integers{}) continue;
    check_polynomial<Small>(c, degree, 0, rng.one_in(4) ? 0.5 : 1, rng, tally);
  }
  std::printf("few bits: %ld roots, %ld signs that are zero, %ld doubts\n", tally.roots, tally.zeros, tally.doubts);
  CHECK(static_cast<std::size_t>(tally.roots) > count / 2);
  CHECK(static_cast<std::size_t>(tally.doubts) * 500 < count);
}

namespace {

template <int Limbs>
FixedInt<Limbs> fixed(const mpz_class& integer) {
  FixedInt<Limbs> magnitude;
  for (int limb = 0; limb < Limbs; ++limb) {
    magnitude.set_limb(limb, mpz_getlimbn(integer.get_mpz_t(), limb));
  }
  return sgn(integer) < 0 ? -magnitude : magnitude;
}

}  // namespace

TEST_CASE("signs that are almost zero, at roots that almost coincide, are the exact ones or in doubt") {
  // (2^k t - n)^2 = 2 s^2, perhaps times t + 1: the roots are (n +- s sqrt(2)) / 2^k. Each q vanishes at a root but for
  // the bits of sqrt(2) that it leaves out. With s^2 in place of 2 s^2 the roots are doubles.
  tests::Rng rng(2027);
  Tally tally;
  long signs = 0, weights = 0;
  const std::size_t polynomials = tests::effort(4000);
  for (std::size_t i = 0; i < polynomials; ++i) {
    const bool is_pair = rng.one_in(3);  // then each q has two roots that almost coincide with p's
    const int k = rng.between(20, 52), m = is_pair ? 124 - k - rng.between(0, 5) : rng.between(30, 180),
              s = rng.between(1, 9);
    const mpz_class power = mpz_class(1) << k;
    const mpz_class n = (power >> 8) + mpz_class(static_cast<unsigned long>(rng.bits() >> 2)) % (power - (power >> 7));
    const bool is_cubic = rng.one_in(2);
    const int square = (rng.one_in(4) ? 1 : 2) * s * s;
    const mpz_class c0 = n * n - square, c1 = -2 * power * n, c2 = power * power;
    Polynomial<FixedInt<6>, 3> p;
    p[0] = fixed<6>(c0);
    p[1] = fixed<6>(is_cubic ? mpz_class(c1 + c0) : c1);
    p[2] = fixed<6>(is_cubic ? mpz_class(c2 + c1) : c2);
    if (is_cubic) p[3] = fixed<6>(c2);
    Doubt doubt;
    const NearRoots<2> near(p, 1, doubt);
    if (doubtful(doubt, tally)) continue;
    const RootList real = isolate_roots(to_exact(p), Exact(1));
    REQUIRE(near.size() == real.size());
    const mpz_class bits = sqrt(mpz_class(9 * square) << (2 * m));
    for (int j = 0; j < near.size(); ++j) {
      INFO(p[0].limb(0) << "..., k = " << k << ", m = " << m << ", s = " << s << ", root " << j << " at "
                        << real[j].lower());
      REQUIRE(near[j].lower() == real[j].lower());
      REQUIRE(near[j].upper() == real[j].upper());
      for (const int side : {-1, 1}) {
        for (const int missing : {-1, 0, 1}) {
          // 3 (2^(k + m) t - 2^m n) -+ floor(3 2^m s sqrt(2)) + missing, perhaps times 1 + t.
          const mpz_class slope = 3 * (power << m), rest = -3 * (n << m) - side * bits + missing;
          Polynomial<FixedInt<4>, 2> q;
          q[0] = fixed<4>(rest);
          q[1] = fixed<4>(is_cubic ? mpz_class(slope + rest) : slope);
          if (is_cubic) q[2] = fixed<4>(slope);
          if (is_pair) {
            const mpz_class other = rest + rng.between(-2, 2);
            q[0] = fixed<4>(mpz_class(rest * other));
            q[1] = fixed<4>(mpz_class(slope * (rest + other)));
            q[2] = fixed<4>(mpz_class(slope * slope));
          }
          const int sign = near[j].sign_at(q);
          if (doubtful(doubt, tally)) continue;
          ++signs;
          REQUIRE(sign == real[j].sign_at(to_exact(q)));
        }
      }
      // 1 / (1 + t), but for factors that are small at the root.
      Polynomial<FixedInt<4>, 2> numerator, denominator;
      numerator[0] = fixed<4>(-n + 3 * s);
      numerator[1] = fixed<4>(power);
      denominator[0] = fixed<4>(-n + 3 * s);
      denominator[1] = fixed<4>(mpz_class(power - n + 3 * s));
      denominator[2] = fixed<4>(power);
      const double quotient = near[j].quotient(numerator, denominator);
      if (doubtful(doubt, tally)) continue;
      ++weights;
      REQUIRE(std::abs(quotient - real[j].quotient(numerator, denominator)) <= 0x1p-49);
    }
  }
  std::printf("%ld signs, %ld weights, %ld doubts\n", signs, weights, tally.doubts);
  CHECK(static_cast<std::size_t>(signs) > 8 * polynomials);
  CHECK(static_cast<std::size_t>(weights) > polynomials);
}

TEST_CASE("a cubic with two roots that almost coincide, or almost are real, has the exact number of roots") {
  // ((2^k t - n)^2 + e) (b t - c), whose first factor has a real root for e <= 0 only.
  tests::Rng rng(2030);
  long decided = 0, without = 0;
  const std::size_t polynomials = tests::effort(4000);
  for (std::size_t i = 0; i < polynomials; ++i) {
    const int k = rng.between(30, 60), e = rng.between(-4, 8), b = rng.between(1, 9), c = rng.between(-3, 12);
    const mpz_class power = mpz_class(1) << k;
    const mpz_class n = mpz_class(static_cast<unsigned long>(rng.bits() >> 2)) % power;
    const mpz_class q0 = n * n + e, q1 = -2 * power * n, q2 = power * power;
    Polynomial<FixedInt<6>, 3> p;
    p[0] = fixed<6>(mpz_class(-c * q0));
    p[1] = fixed<6>(mpz_class(b * q0 - c * q1));
    p[2] = fixed<6>(mpz_class(b * q1 - c * q2));
    p[3] = fixed<6>(mpz_class(b * q2));
    Doubt doubt;
    const NearRoots<2> near(p, 1, doubt);
    if (doubt.raised()) continue;
    ++decided;
    without += e > 0;
    const RootList real = isolate_roots(to_exact(p), Exact(1));
    INFO("k = " << k << ", n = " << n << ", e = " << e << ", b = " << b << ", c = " << c);
    REQUIRE(near.size() == real.size());
    for (int root = 0; root < near.size(); ++root) {
      REQUIRE(near[root].lower() == real[root].lower());
      REQUIRE(near[root].upper() == real[root].upper());
      REQUIRE(near[root].multiplicity() == real[root].multiplicity());
    }
  }
  std::printf("%ld decided, %ld without two of the roots\n", decided, without);
  CHECK(static_cast<std::size_t>(without) * 2 > polynomials);
}

TEST_CASE("three roots that almost coincide, one of them a double, are the exact ones") {
  // With s = 2^k t - n: m s (2^j s^2 + e), or the same plus 1, where no root is a double.
  tests::Rng rng(2028);
  Tally tally;
  long roots = 0, doubts = 0;
  const std::size_t polynomials = tests::effort(3000);
  for (std::size_t i = 0; i < polynomials; ++i) {
    const int k = rng.between(1, 7), j = rng.between(1, 100), m = rng.between(-3, 3), n = rng.between(1, (1 << k) - 1);
    const int e = rng.between(-9, 9), rest = rng.one_in(4) ? 1 : 0;
    if (m == 0) continue;
    const mpz_class d = mpz_class(1) << k, square = mpz_class(1) << j;
    const mpz_class c[] = {m * (-n * square * n * n - e * n) + rest, m * (3 * square * d * n * n + e * d),
                           m * (-3 * square * d * d * n), m * square * d * d * d};
    Polynomial<FixedInt<6>, 3> p;
    for (int term = 0; term < 4; ++term) p[term] = fixed<6>(c[term]);
    Doubt doubt;
    const NearRoots<2> near(p, 1, doubt);
    if (doubt.raised()) {
      doubts += rest == 0;
      continue;
    }
    const RootList real = isolate_roots(to_exact(p), Exact(1));
    INFO("k = " << k << ", j = " << j << ", m = " << m << ", n = " << n << ", e = " << e << ", rest " << rest);
    REQUIRE(near.size() == real.size());
    for (int root = 0; root < near.size(); ++root) {
      ++roots;
      REQUIRE(near[root].lower() == real[root].lower());
      REQUIRE(near[root].upper() == real[root].upper());
      REQUIRE(near[root].multiplicity() == real[root].multiplicity());
      for (int other = 0; other < near.size(); ++other) {
        const int order = near[root].compare(near[other]);
        if (!doubtful(doubt, tally)) REQUIRE(order == real[root].compare(real[other]));
      }
    }
  }
  std::printf("%ld roots, %ld doubts\n", roots, doubts);
  CHECK(static_cast<std::size_t>(roots) > polynomials);
  CHECK(static_cast<std::size_t>(doubts) * 10 < polynomials);
}

TEST_CASE("a quadratic that a cubic begins with does not vanish at the cubic's root") {
  // At t near 2^-12 it is -t^3, which doubles do not tell from zero.
  const Integers cubic = {-(std::int64_t{1} << 30), std::int64_t{1} << 42, 5, 1};
  Doubt doubt;
  const NearRoots<1> roots(Small::cubic(cubic, 0), 1, doubt);
  REQUIRE(roots.size() == 1);
  CHECK(roots[0].sign_at(Small::quadratic(cubic)) == -1);
  CHECK_FALSE(doubt.raised());
}

TEST_CASE("a near root just after 0 has the right neighbours") {
  // 2^k t - n and, with a root beside it, (2^k t - n) 2^j + 1.
  tests::Rng rng(2029);
  for (int i = 0; i < 1000; ++i) {
    const int k = rng.between(60, 180), n = rng.between(1, 9), j = rng.one_in(2) ? 0 : rng.between(1, 120);
    const mpz_class slope = mpz_class(1) << (k + j), rest = -(mpz_class(n) << j) + (j > 0 ? 1 : 0);
    Polynomial<FixedInt<6>, 3> p;
    p[0] = fixed<6>(rest);
    p[1] = fixed<6>(slope);
    Doubt doubt;
    const NearRoots<2> near(p, 1, doubt);
    INFO("k = " << k << ", n = " << n << ", j = " << j);
    REQUIRE_FALSE(doubt.raised());
    const RootList real = isolate_roots(to_exact(p), Exact(1));
    REQUIRE(near.size() == real.size());
    for (int root = 0; root < near.size(); ++root) {
      REQUIRE(near[root].lower() == real[root].lower());
      REQUIRE(near[root].upper() == real[root].upper());
    }
  }
}

TEST_CASE("a near root that is a double, or beside one, has the right neighbours") {
  Doubt doubt;
  // t - 1/2 and t - 1/2 - 2^-54, whose root lies half way to the next double.
  const NearRoots<1> half(Polynomial<FixedInt<3>, 3>{{fixed<3>(-1, 0), fixed<3>(2, 0)}}, 1, doubt);
  REQUIRE(half.size() == 1);
  CHECK(half[0].lower() == 0.5);
  CHECK(half[0].upper() == 0.5);
  const std::int64_t unit = std::int64_t{1} << 54;
  const Integers beside = {-(unit / 2 + 1), unit, 0, 0};
  const NearRoots<1> next(fixed<3, 3>(beside), 1, doubt);
  REQUIRE(next.size() == 1);
  CHECK(next[0].lower() == 0.5);
  CHECK(next[0].upper() == 0.5 + 0x1p-53);
  CHECK(next[0].compare(half[0]) > 0);
  CHECK(next[0].compare(0.5) > 0);
  CHECK_FALSE(doubt.raised());
}

TEST_CASE("fractions around the greatest integers that doubles hold have the right neighbours") {
  tests::Rng rng(2030);
  for (int i = 0; i < 3000; ++i) {
    // d t - n with d of 50 to 57 bits
    const std::int64_t greatest = std::int64_t{1} << rng.between(50, 57);
    const std::int64_t d = greatest - 1 - rng.between(0, 1000), n = d - 1 - rng.between(0, 1 << 30) * (d >> 31);
    const Integers c = {-n, d, 0, 0};
    INFO(n << " / " << d);
    Doubt doubt;
    const NearRoots<1> near(Small::cubic(c, 0), 1, doubt);
    const RootList real = isolate_roots(to_exact(fixed<6, 3>(c)), Exact(1));
    REQUIRE_FALSE(doubt.raised());
    REQUIRE(near.size() == real.size());
    for (int root = 0; root < near.size(); ++root) {
      REQUIRE(near[root].lower() == real[root].lower());
      REQUIRE(near[root].upper() == real[root].upper());
    }
  }
}

TEST_CASE("a quotient at a fraction of few bits is as good as is said") {
  // At 1 - 2^-k or 1/3, of coefficients up to the greatest that are small.
  tests::Rng rng(2031);
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::int64_t limit = std::int64_t{1}
                               << (rng.one_in(2) ? NearRoots<1>::Root::kMostSmallBits : rng.between(4, 43));
    const auto random = [&] {
      return limit - 1 - rng.between(0, static_cast<int>(std::min<std::int64_t>(limit / 4, 1 << 20)));
    };
    const Integers top = {random() / 2, random() / 4, random() / 8, 0}, bottom = {random(), random(), random(), 0};
    const std::int64_t d = rng.one_in(2) ? std::int64_t{1} << rng.between(8, 10) : 3, n = d == 3 ? 1 : d - 1;
    Doubt doubt;
    const NearRoots<1> near(Small::cubic({-n, d, 0, 0}, 0), 1, doubt);
    REQUIRE(near.size() == 1);
    const double quotient = near[0].quotient(Small::quadratic(top), Small::quadratic(bottom));
    const auto value = [&](const Integers& q) -> mpz_class {
      return mpz_class(q[0]) * (d * d) + mpz_class(q[1]) * (n * d) + mpz_class(q[2]) * (n * n);
    };
    const mpq_class error = mpq_class(quotient) - mpq_class(value(top), value(bottom));
    worst = std::max(worst, std::fabs(error.get_d()));
    REQUIRE_FALSE(doubt.raised());
  }
  CHECK(worst <= 0x1p-51);
}

TEST_CASE("a quotient of what almost vanishes at an irrational root is as good as is said, or in doubt") {
  // d t - n for the convergents n / d of sqrt(c / a), each over the next but two: both are tiny, of one sign and less
  // than 1 of each other. Doubles in pairs know them to few bits.
  tests::Rng rng(2032);
  double worst = 0;
  int known = 0, doubts = 0;
  for (int i = 0; i < 2000; ++i) {
    const int a = rng.between(3, 1000), c = rng.between(1, a - 1);
    if (mpz_perfect_square_p(mpz_class(a * c).get_mpz_t()) != 0) continue;  // the root is rational
    const mpf_class root = sqrt(mpf_class(c, 512) / a);
    std::vector<Integers> lines;  // -n + d t
    mpf_class rest = root;
    mpz_class n0 = 1, d0 = 0, n1 = 0, d1 = 1;  // the convergent 0 / 1, as the root is less than 1
    while (true) {
      lines.push_back({-n1.get_si(), d1.get_si(), 0, 0});
      rest = 1 / mpf_class(rest - floor(rest));
      const mpz_class term(floor(rest)), n2 = term * n1 + n0, d2 = term * d1 + d0;
      if (d2 >= mpz_class(1) << 43) break;
      n0 = n1, d0 = d1, n1 = n2, d1 = d2;
    }
    Doubt doubt;
    const NearRoots<1> near(Small::cubic({-c, 0, a, 0}, 0), 1, doubt);
    if (near.size() != 1 || doubt.raised()) continue;
    const auto value = [&](const Integers& line) -> mpf_class {
      return mpf_class(mpz_class(line[1]), 512) * root + mpf_class(mpz_class(line[0]), 512);
    };
    for (std::size_t k = 0; k + 2 < lines.size(); ++k) {
      const auto quotient = near[0].known_quotient(Small::quadratic(lines[k + 2]), Small::quadratic(lines[k]));
      ++(quotient ? known : doubts);
      if (!quotient) continue;
      const mpf_class error = mpf_class(*quotient, 512) - value(lines[k + 2]) / value(lines[k]);
      worst = std::max(worst, std::fabs(error.get_d()));
    }
  }
  CHECK(worst <= 0x1.6ap-51);  // 2^-50.5
  CHECK(known > 1000);
  CHECK(doubts > 1000);
  std::printf("%d quotients known, %d in doubt, worst error %g\n", known, doubts, worst);
}

TEST_CASE("a polynomial that is said to have no root up to a time has none") {
  tests::Rng rng(2032);
  int without = 0;
  for (int i = 0; i < 20000; ++i) {
    // (d t - n) (e t - m), whose first root is a border case of the range; sometimes a little more
    const std::int64_t d = rng.between(1, 1 << 20), n = rng.between(0, 1 << 20), e = rng.between(-9, 9),
                       m = rng.between(-9, 9);
    const Integers c = {n * m + (rng.one_in(2) ? rng.between(-1, 1) : 0), -(d * m + n * e), d * e, 0};
    const double root = static_cast<double>(n) / static_cast<double>(d);
    const double limit = root <= 1 && rng.one_in(2) ? root : rng.between(0, 64) / 64.0;
    const auto q = Small::quadratic(c);
    if (is_zero(q) || !certainly_without_root(q, limit)) continue;
    ++without;
    INFO(c[0] << ", " << c[1] << ", " << c[2] << " up to " << limit);
    REQUIRE(isolate_roots(to_exact(fixed<6, 3>(c)), Exact(limit)).size() == 0);
  }
  CHECK(without > 1000);
}

TEST_CASE("a multiple of a root's quadratic vanishes there, and what is almost one does not") {
  tests::Rng rng(2033);
  int zeros = 0;
  for (int i = 0; i < 3000; ++i) {
    const Integers c = {rng.between(-1000, 1000), rng.between(-1000, 1000), rng.between(-1000, 1000), 0};
    if (c == Integers{}) continue;
    Doubt doubt;
    const NearRoots<1> near(Small::cubic(c, 0), 1, doubt);
    const RootList real = isolate_roots(to_exact(fixed<6, 3>(c)), Exact(1));
    const std::int64_t factor = (std::int64_t{1} << 33) - rng.between(0, 1000);
    Integers multiple = {factor * c[0], factor * c[1], factor * c[2], 0};
    if (rng.one_in(2)) multiple[static_cast<std::size_t>(rng.between(0, 2))] += rng.between(-1, 1);
    for (int root = 0; root < near.size(); ++root) {
      const int sign = near[root].sign_at(Small::quadratic(multiple));
      INFO(c[0] << ", " << c[1] << ", " << c[2] << " against " << multiple[0] << ", " << multiple[1] << ", "
                << multiple[2]);
      REQUIRE_FALSE(doubt.raised());
      REQUIRE(sign == real[root].sign_at(to_exact(fixed<4, 2>(multiple))));
      zeros += sign == 0;
    }
  }
  CHECK(zeros > 500);
}

TEST_CASE("what the numbers of near roots do not hold raises a doubt") {
  Doubt doubt;
  (void)numbers::NearRoot<1>::at_double(0x1p-190, 1, doubt);
  CHECK_FALSE(doubt.raised());
  (void)numbers::NearRoot<1>::at_double(0x1p-191, 1, doubt);
  CHECK(doubt.raised());
}
