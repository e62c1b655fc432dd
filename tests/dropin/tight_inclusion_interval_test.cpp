// Dyadic numbers, intervals and tolerances of the drop-in for Tight-Inclusion, against rational numbers.
// SPDX-License-Identifier: MIT
#include <tight_inclusion/ccd.hpp>
#include <tight_inclusion/interval.hpp>
#include <tight_inclusion/interval_root_finder.hpp>

#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "support/catch.hpp"
#include "support/query_families.hpp"

using ticcd::Interval;
using ticcd::NumCCD;
using touchstone::InvalidQuery;
using touchstone::tests::Rng;

namespace {

mpq_class rational(const NumCCD& x) {
  mpz_class denominator = 1;
  denominator <<= x.denom_power;
  mpq_class value(mpz_class(std::to_string(x.numerator)), denominator);
  value.canonicalize();
  return value;
}

NumCCD random_number(Rng& rng) {
  const auto power = static_cast<std::uint8_t>(rng.one_in(8) ? rng.between(0, 255) : rng.between(0, 62));
  return {rng.bits() >> rng.between(0, 63), power};
}

}  // namespace

TEST_CASE("powers of two and odd parts") {
  CHECK(ticcd::power(5, 3) == 40);
  CHECK(ticcd::power(1, 63) == 0x8000000000000000u);
  CHECK(ticcd::power(0, 255) == 0);
  CHECK(ticcd::pow2(10) == 1024);
  CHECK_THROWS_AS(ticcd::power(2, 63), InvalidQuery);
  CHECK_THROWS_AS(ticcd::pow2(64), InvalidQuery);
  std::uint64_t odd = 7;
  CHECK(ticcd::reduction(96, odd) == 5);
  CHECK(odd == 3);
  CHECK(ticcd::reduction(0, odd) == 0);
  CHECK(odd == 0);
  CHECK(NumCCD(3, 5).denominator() == 32);
}

TEST_CASE("dyadic numbers are compared and added exactly") {
  Rng rng(3);
  int sums = 0;
  for (int i = 0; i < 20000; ++i) {
    const NumCCD a = random_number(rng);
    const NumCCD b = rng.one_in(4) ? NumCCD(a.numerator + rng.below(2), a.denom_power) : random_number(rng);
    const mpq_class x = rational(a), y = rational(b);
    CAPTURE(a.numerator, int(a.denom_power), b.numerator, int(b.denom_power));
    REQUIRE((a < b) == (x < y));
    REQUIRE((a <= b) == (x <= y));
    REQUIRE((a > b) == (x > y));
    REQUIRE((a >= b) == (x >= y));
    REQUIRE((a == b) == (x == y));
    REQUIRE((a != b) == (x != y));
    const mpz_class too_large("18446744073709551616");
    const bool one_denominator_fits = x.get_den() < too_large || y.get_den() < too_large;
    if (one_denominator_fits || x > 1 || y > 1) {
      REQUIRE(NumCCD::is_sum_leq_1(a, b) == (x + y <= 1));
    } else {
      REQUIRE_THROWS_AS(NumCCD::is_sum_leq_1(a, b), InvalidQuery);
    }
    const mpq_class sum = x + y;
    if (sum.get_num() < too_large) {
      REQUIRE(rational(a + b) == sum);
      ++sums;
    } else {
      REQUIRE_THROWS_AS(a + b, InvalidQuery);
    }
  }
  CHECK(sums > 1000);
  CHECK(NumCCD(2, 1) == NumCCD(1, 0));
  CHECK(NumCCD(3, 2) == 0.75);
  CHECK(NumCCD(3, 2) < 0.76);
  CHECK(NumCCD(3, 2) > 0.74);
}

TEST_CASE("a double in [0, 1] becomes the least multiple of 2^-62 that is not less") {
  Rng rng(5);
  for (int i = 0; i < 5000; ++i) {
    const double x = std::ldexp(rng.unit(), -rng.between(0, 70));
    const mpq_class found = rational(x);
    CAPTURE(x);
    REQUIRE(found >= mpq_class(x));
    REQUIRE(found < mpq_class(x) + mpq_class(0x1p-62));
    REQUIRE(rational(x) * mpq_class(0x1p62) == mpz_class(rational(x) * mpq_class(0x1p62)));
  }
  CHECK(NumCCD(0.0).value() == 0);
  CHECK(NumCCD(1.0).value() == 1);
  CHECK(NumCCD(0.625).numerator == 5);
  CHECK(int(NumCCD(0.625).denom_power) == 3);
  for (const double bad : {-0x1p-1074, 1 + 0x1p-52, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(NumCCD(bad), InvalidQuery);
  }
}

TEST_CASE("an interval is bisected in its middle") {
  Rng rng(7);
  Interval interval(NumCCD(0, 0), NumCCD(1, 0));
  for (int i = 0; i < 60; ++i) {
    const auto [lower, upper] = interval.bisect();
    REQUIRE(rational(lower.lower) == rational(interval.lower));
    REQUIRE(rational(upper.upper) == rational(interval.upper));
    REQUIRE(rational(lower.upper) == (rational(interval.lower) + rational(interval.upper)) / 2);
    REQUIRE(lower.upper == upper.lower);
    interval = rng.one_in(2) ? lower : upper;
  }
  const auto [ones, more] = Interval(NumCCD(1, 0), NumCCD(3, 0)).bisect();
  CHECK(ones.upper.value() == 2);
  CHECK(more.lower.value() == 2);

  const Interval middle(NumCCD(1, 2), NumCCD(3, 2));
  CHECK(middle.overlaps(0, 0.25));
  CHECK(middle.overlaps(0.75, 1));
  CHECK_FALSE(middle.overlaps(0, 0.2));
  CHECK_FALSE(middle.overlaps(0.8, 1));
  const ticcd::Array3 widths = ticcd::width({middle, Interval(NumCCD(0, 0), NumCCD(1, 0)), Interval(1.0, 1.0)});
  CHECK((widths == ticcd::Array3(0.5, 1, 0)).all());
}

TEST_CASE("tolerances divide by three times the greatest change of a coordinate") {
  using V = ticcd::Vector3;
  // Edge a has the length 4 along x and moves by 6 against edge b, whose length grows from 1 to 2 along y.
  const ticcd::Array3 edges = ticcd::compute_edge_edge_tolerances(V(0, 0, 0), V(4, 0, 0), V(0, 0, 9), V(0, 1, 9),
                                                                  V(0, 0, 6), V(4, 0, 6), V(0, 0, 9), V(0, 2, 9), 0.72);
  CHECK(edges[0] == 0.72 / 18);
  CHECK(edges[1] == 0.72 / 12);
  CHECK(edges[2] == 0.72 / 6);
  // The corner f1 + f2 - f0 of the face's parallelogram moves by 2 + 3, and the vertex by 1 in the other direction.
  const ticcd::Array3 face = ticcd::compute_vertex_face_tolerances(
      V(0, 0, 5), V(0, 0, 0), V(1, 0, 0), V(0, 8, 0), V(0, 0, 4), V(0, 0, 0), V(1, 0, 2), V(0, 8, 3), 0.72);
  CHECK(face[0] == 0.72 / 18);
  CHECK(face[1] == 0.72 / 6);
  CHECK(face[2] == 0.72 / 24);
  const V o(0, 0, 0);
  CHECK((ticcd::compute_edge_edge_tolerances(o, o, o, o, o, o, o, o) == std::numeric_limits<double>::infinity()).all());
}

TEST_CASE("a box of parameters as wide as the tolerances moves the difference by no more than the length asked for") {
  Rng rng(11);
  for (int i = 0; i < 2000; ++i) {
    std::vector<ticcd::Vector3> x(8);
    for (auto& corner : x) {
      for (int k = 0; k < 3; ++k) corner[k] = rng.symmetric();
    }
    const bool is_vertex_face = rng.one_in(2);
    const auto tolerances =
        is_vertex_face ? ticcd::compute_vertex_face_tolerances : ticcd::compute_edge_edge_tolerances;
    const auto f = is_vertex_face ? ticcd::function_f_vf<double> : ticcd::function_f_ee<double>;
    const double length = std::ldexp(1.0, -rng.between(4, 20));
    const ticcd::Array3 widths = tolerances(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], length);
    const double t = 0.5 * rng.unit(), u = 0.5 * rng.unit(), v = 0.5 * rng.unit();
    for (int k = 0; k < 3; ++k) {
      double least = 1e300, greatest = -1e300;
      for (int corner = 0; corner < 8; ++corner) {
        const double value =
            f(t + (corner & 1) * std::min(0.5, widths[0]), u + (corner >> 1 & 1) * std::min(0.5, widths[1]),
              v + (corner >> 2) * std::min(0.5, widths[2]), k, x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
      REQUIRE(greatest - least <= length * (1 + 1e-9));
    }
  }
}
