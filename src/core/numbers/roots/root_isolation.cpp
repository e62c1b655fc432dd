// Isolation of the roots of a polynomial in [0, limit]. Up to degree 3 most calls end at the sign variations of
// the Bernstein coefficients (Descartes' rule: none, or exactly one root); the rest is decided by discriminants.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <gmpxx.h>

#include "numbers/integers/gmp_conversions.hpp"
#include "numbers/roots/bisection.hpp"
#include "numbers/roots/real_root.hpp"

namespace touchstone::numbers {
namespace {

/// Signs of the Bernstein coefficients over [0, limit] of a polynomial of degree 1, 2 or 3.
struct BernsteinSigns {
  std::array<int, 4> sign{};
  int size;
  int variations = 0;

  BernsteinSigns(Coefficients p, const Exact& limit) : size(p.size) {
    // With c_i scaled by limit^i the interval is [0, 1], and coefficient k is sum_i binomial(k, i) / binomial(n, i)
    // c_i.
    std::array<Exact, 4> c;
    Exact power(1);
    for (int i = 0; i < size; ++i) {
      c[static_cast<std::size_t>(i)] = p.c[i] * power;
      power = power * limit;
    }
    sign[0] = sign_of(c[0]);
    if (size == 2) sign[1] = sign_of(c[0] + c[1]);
    if (size == 3) {
      sign[1] = sign_of(Exact(2) * c[0] + c[1]);
      sign[2] = sign_of(c[0] + c[1] + c[2]);
    }
    if (size == 4) {
      sign[1] = sign_of(Exact(3) * c[0] + c[1]);
      sign[2] = sign_of(Exact(3) * c[0] + Exact(2) * c[1] + c[2]);
      sign[3] = sign_of(c[0] + c[1] + c[2] + c[3]);
    }
    int previous = sign[0];
    for (int i = 1; i < size; ++i) {
      const int s = sign[static_cast<std::size_t>(i)];
      if (s == 0) continue;
      variations += previous != 0 && s != previous;
      previous = s;
    }
  }
};

int sign_at_point(Coefficients p, const Exact& t) { return sign_of(evaluate(p, t)); }

mpf_class to_float(const Exact& x, mp_bitcnt_t bits) { return mpf_class(to_rational(x), bits); }

/// x rounded towards zero to `bits` bits after the binary point.
Exact truncated(mpf_class x, mp_bitcnt_t bits) {
  mpf_mul_2exp(x.get_mpf_t(), x.get_mpf_t(), bits);
  return exact_from_integer(mpz_class(x)) * power_of_two(-static_cast<long>(bits));
}

// Approximations that improve with `bits`, without an error bound. Their users check them exactly, and ask again for
// more bits where the check fails. The first ones are in doubles.
constexpr mp_bitcnt_t kInDoubles = 32;

Exact from_double(double x) { return Exact(std::isfinite(x) ? x : 0.0); }

Exact approximate_vertex(Coefficients quadratic, mp_bitcnt_t bits) {
  if (bits == kInDoubles) {
    const auto& c = scaled_to_doubles(quadratic).c;
    return from_double(c[1] / (-2 * c[2]));
  }
  const mpf_class vertex = to_float(quadratic.c[1], bits) / to_float(Exact(-2) * quadratic.c[2], bits);
  return truncated(vertex, bits);
}

/// The root of p' on the given side (-1: left, 1: right) of the cubic's inflection, for a positive discriminant of p'.
Exact approximate_critical_point(Coefficients cubic, int side, mp_bitcnt_t bits) {
  if (bits == kInDoubles) {
    const auto& c = scaled_to_doubles(cubic).c;
    const double a3 = 3 * c[3];
    const double r = (a3 > 0 ? side : -side) * std::sqrt(c[2] * c[2] - a3 * c[1]);
    return from_double((c[2] <= 0) == (r > 0) ? (r - c[2]) / a3 : c[1] / (-c[2] - r));
  }
  const Exact& b = cubic.c[2];
  const Exact three_a = Exact(3) * cubic.c[3];
  const mpf_class root = sqrt(to_float(b * b - three_a * cubic.c[1], bits));
  // t = (-b + r) / 3a = c / (-b - r), with r = side * root for a > 0: take the form without cancellation.
  const mpf_class r = sign_of(three_a) * side > 0 ? root : mpf_class(-root);
  const mpf_class minus_b = to_float(-b, bits);
  const bool same_sign = sgn(minus_b) == 0 || sgn(minus_b) == sgn(r);
  const mpf_class point = same_sign ? mpf_class((minus_b + r) / to_float(three_a, bits))
                                    : mpf_class(to_float(cubic.c[1], bits) / (minus_b - r));
  return truncated(point, bits);
}

/// Collects the roots in the open interval (0, limit) of a polynomial whose leading coefficient and whose values at
/// both ends are not zero.
class OpenInterval {
 public:
  OpenInterval(Coefficients p, const Exact& limit, RootList& roots) : p_(p), limit_(limit), roots_(roots) {}

  void isolate() {
    if (p_.size < 2) return;
    if (p_.size > 4) return isolate_by_bisection(p_, limit_, roots_);
    const BernsteinSigns bernstein(p_, limit_);
    if (bernstein.variations == 0) return;
    if (p_.size == 2) {
      roots_.push(RealRoot::rational(-p_.c[0], p_.c[1], 1));
    } else if (bernstein.variations == 1) {
      push_between(Exact(0), limit_);
    } else if (p_.size == 3) {
      isolate_quadratic();
    } else {
      isolate_cubic(bernstein.variations);
    }
  }

 private:
  // Two variations: p has the leading coefficient's sign at both ends, and its vertex lies inside.
  void isolate_quadratic() {
    const int discriminant = sign_of(p_.c[1] * p_.c[1] - Exact(4) * p_.c[0] * p_.c[2]);
    if (discriminant < 0) return;
    if (discriminant == 0) {
      roots_.push(RealRoot::rational(-p_.c[1], Exact(2) * p_.c[2], 2));
      return;
    }
    const int expected = -sign_of(p_.c[2]);
    for (mp_bitcnt_t bits = kInDoubles;; bits *= 2) {
      const Exact separator = approximate_vertex(p_, bits);
      if (!inside(separator) || sign_at_point(p_, separator) != expected) continue;
      push_between(Exact(0), separator);
      push_between(separator, limit_);
      return;
    }
  }

  void isolate_cubic(int variations) {
    const Exact &d = p_.c[0], &c = p_.c[1], &b = p_.c[2], &a = p_.c[3];
    const Exact b2_3ac = b * b - Exact(3) * a * c;
    const Exact ad9_bc = Exact(9) * a * d - b * c;
    const Exact c2_3bd = c * c - Exact(3) * b * d;
    // The discriminant is (4 (b^2 - 3ac)(c^2 - 3bd) - (bc - 9ad)^2) / 3.
    const int discriminant = sign_of(Exact(4) * b2_3ac * c2_3bd - ad9_bc * ad9_bc);
    if (discriminant <
        0) {  // one real root; inside iff p's sign differs at the ends, which is an odd number of variations
      if (variations % 2 == 1) push_between(Exact(0), limit_);
    } else if (discriminant == 0) {
      push_repeated(b2_3ac, ad9_bc);
    } else {
      push_three();
    }
  }

  // A repeated root of a cubic, and the one beside it, are rational.
  void push_repeated(const Exact& b2_3ac, const Exact& ad9_bc) {
    const Exact &d = p_.c[0], &c = p_.c[1], &b = p_.c[2], &a = p_.c[3];
    if (is_zero(b2_3ac)) {
      push_rational_inside(-b, Exact(3) * a, 3);
      return;
    }
    const Exact double_numerator = ad9_bc;
    const Exact double_denominator = Exact(2) * b2_3ac;
    const Exact single_numerator = Exact(4) * a * b * c - Exact(9) * a * a * d - b * b * b;
    const Exact single_denominator = a * b2_3ac;
    // b^2 - 3ac > 0 (it is (a (double - single))^2), so the denominators' signs are known.
    const bool single_first = sign_of(single_numerator * double_denominator - double_numerator * single_denominator) *
                                  sign_of(single_denominator) <
                              0;
    if (single_first) push_rational_inside(single_numerator, single_denominator, 1);
    push_rational_inside(double_numerator, double_denominator, 2);
    if (!single_first) push_rational_inside(single_numerator, single_denominator, 1);
  }

  // Three simple real roots x1 < x2 < x3. A point between x1 and x2 is recognised by lying left of the inflection with
  // p of the sign of its leading coefficient; one between x2 and x3 by mirror image. Such points exist around p's
  // critical points; they matter where a critical point lies inside (0, limit).
  void push_three() {
    const Exact minus_b = -p_.c[2];
    const Exact three_a = Exact(3) * p_.c[3];
    const int orientation = sign_of(three_a);
    const auto side_of_inflection = [&](const Exact& t) { return orientation * sign_of(t * three_a - minus_b); };
    const std::array<Exact, 3> derivative = {p_.c[1], Exact(2) * p_.c[2], three_a};
    const auto slope_sign = [&](const Exact& t) { return orientation * sign_at_point({derivative.data(), 3}, t); };

    Exact low(0);
    for (const int side : {-1, 1}) {
      // The critical point is > 0 iff: left one, slope > 0 at 0 left of the inflection; right one, not (slope >= 0
      // right of it).
      const int side0 = side_of_inflection(Exact(0));
      const int side_limit = side_of_inflection(limit_);
      const bool after_zero =
          side < 0 ? side0 < 0 && slope_sign(Exact(0)) > 0 : !(side0 >= 0 && slope_sign(Exact(0)) >= 0);
      const bool before_limit =
          side < 0 ? !(side_limit <= 0 && slope_sign(limit_) >= 0) : side_limit > 0 && slope_sign(limit_) > 0;
      if (!after_zero || !before_limit) continue;
      const int expected = side < 0 ? orientation : -orientation;
      for (mp_bitcnt_t bits = kInDoubles;; bits *= 2) {
        const Exact separator = approximate_critical_point(p_, side, bits);
        if (!inside(separator) || side_of_inflection(separator) != side || sign_at_point(p_, separator) != expected)
          continue;
        push_if_inside(low, separator);
        low = separator;
        break;
      }
    }
    push_if_inside(low, limit_);
  }

  bool inside(const Exact& t) const { return sign_of(t) > 0 && t < limit_; }

  void push_rational_inside(const Exact& numerator, const Exact& denominator, int multiplicity) {
    const int s = sign_of(denominator);
    if (s * sign_of(numerator) > 0 && s * sign_of(numerator - limit_ * denominator) < 0) {
      roots_.push(RealRoot::rational(numerator, denominator, multiplicity));
    }
  }

  void push_if_inside(const Exact& low, const Exact& high) {
    if (sign_at_point(p_, low) != sign_at_point(p_, high)) push_between(low, high);
  }

  void push_between(const Exact& low, const Exact& high) {
    roots_.push(RealRoot::isolated(p_, low, high, sign_at_point(p_, low)));
  }

  Coefficients p_;
  const Exact& limit_;
  RootList& roots_;
};

}  // namespace

RootList isolate_roots(Coefficients p, const Exact& limit) {
  int size = p.size;
  while (size > 0 && is_zero(p.c[size - 1])) --size;
  RootList roots;

  // Divide out the roots at 0 and, for a limit of its own, at the limit.
  int first = 0;
  while (first < size && is_zero(p.c[first])) ++first;
  if (first > 0) roots.push(RealRoot::rational(Exact(0), Exact(1), first));
  if (is_zero(limit)) return roots;
  size -= first;
  ExactList c(p.c + first, size);
  int at_limit = 0;
  while (size > 1 && sign_at_point({c.begin(), size}, limit) == 0) {
    for (int i = size - 2; i > 0; --i) {  // synthetic division by (t - limit)
      c[static_cast<std::size_t>(i)] = c[static_cast<std::size_t>(i)] + limit * c[static_cast<std::size_t>(i + 1)];
    }
    for (int i = 0; i < size - 1; ++i) c[static_cast<std::size_t>(i)] = c[static_cast<std::size_t>(i + 1)];
    --size;
    ++at_limit;
  }
  OpenInterval({c.begin(), size}, limit, roots).isolate();
  if (at_limit > 0) roots.push(RealRoot::rational(limit, Exact(1), at_limit));
  return roots;
}

}  // namespace touchstone::numbers
