// SPDX-License-Identifier: MIT
#include "numbers/roots/integer_polynomial.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "numbers/integers/exact_number.hpp"

namespace touchstone::numbers {
namespace {

void make_primitive(Integers& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  mpz_class divisor;
  for (const mpz_class& c : p) divisor = gcd(divisor, c);
  for (mpz_class& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
}

Integers derivative(const Integers& p) {
  Integers result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<unsigned long>(i));
  return result;
}

/// Divides by b, which is not zero, after a multiplication that keeps everything integer. Leaves a multiple of the
/// remainder in `a`; returns a multiple of the quotient.
Integers pseudo_divide(Integers& a, const Integers& b) {
  Integers quotient(a.size() < b.size() ? 0 : a.size() - b.size() + 1);
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    const mpz_class factor = a.back();
    for (mpz_class& c : a) c *= b.back();
    for (mpz_class& c : quotient) c *= b.back();
    quotient[shift] += factor;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= factor * b[i];
    while (!a.empty() && a.back() == 0) a.pop_back();
  }
  return quotient;
}

/// a / b, primitive. b divides a.
Integers exact_quotient(Integers a, const Integers& b) {
  Integers quotient = pseudo_divide(a, b);
  make_primitive(quotient);
  return quotient;
}

}  // namespace

Integers primitive_integers(Coefficients p) {
  // All times one power of two, that of the least exponent.
  int least = std::numeric_limits<int>::max();
  for (int i = 0; i < p.size; ++i) {
    if (!is_zero(p.c[i])) least = std::min(least, p.c[i].limb_exponent());
  }
  Integers result(static_cast<std::size_t>(p.size));
  std::vector<Exact::Limb> limbs;
  for (int i = 0; i < p.size; ++i) {
    const Exact& x = p.c[i];
    if (is_zero(x)) continue;
    limbs.assign(static_cast<std::size_t>(x.limb_exponent() - least), 0);
    for (int k = 0; k < x.limb_count(); ++k) limbs.push_back(x.limb(k));
    mpz_class& integer = result[static_cast<std::size_t>(i)];
    mpz_import(integer.get_mpz_t(), limbs.size(), -1, sizeof(Exact::Limb), 0, 0, limbs.data());
    if (x.sign() < 0) mpz_neg(integer.get_mpz_t(), integer.get_mpz_t());
  }
  make_primitive(result);
  return result;
}

Integers greatest_common_divisor(Integers a, Integers b) {
  while (!b.empty()) {
    pseudo_divide(a, b);
    make_primitive(a);
    a.swap(b);
  }
  return a;
}

Integers product(const Integers& a, const Integers& b) {
  if (a.empty() || b.empty()) return {};
  Integers result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

std::vector<Integers> factors_by_multiplicity(const Integers& p) {
  // common[i] has the roots of multiplicity m > i with multiplicity m - i; common[i] / common[i + 1] has each once.
  std::vector<Integers> simple;
  Integers common = p;
  while (common.size() > 1) {
    Integers next = greatest_common_divisor(common, derivative(common));
    simple.push_back(exact_quotient(common, next));
    common = std::move(next);
  }
  for (std::size_t i = 0; i + 1 < simple.size(); ++i) simple[i] = exact_quotient(simple[i], simple[i + 1]);
  return simple;
}

}  // namespace touchstone::numbers
