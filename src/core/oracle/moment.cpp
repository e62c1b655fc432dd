// Everything that asks CGAL's algebraic kernel; the one source that includes it.
// SPDX-License-Identifier: MIT
#include "oracle/moment.hpp"

#include <CGAL/Algebraic_kernel_d_1.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>

#include "oracle/bracket.hpp"

namespace touchstone::oracle {

using Kernel = CGAL::Algebraic_kernel_d_1<Integer>;
using Real = Kernel::Algebraic_real_1;

struct Moment::Impl {
  Real time;
  mutable Bracket bracket;

  explicit Impl(const Real& real) : time(real), bracket(real.polynomial(), real.low(), real.high()) {}

  const Bracket& narrowed(unsigned bits) const {
    bracket.narrow(bits);
    return bracket;
  }
};

namespace {

constexpr unsigned kFirstPrecision = 64;  // bits of the first bracket of a time: a double needs 53, a weight a few more
constexpr int kWeightPrecision = 56;      // a quotient within 2^-56 leaves room for its rounding to a double

/// The coefficients of a positive multiple of p(low + (high - low) x), from the constant one up.
std::vector<Integer> coefficients_over(const Polynomial& p, const Rational& low, const Rational& high) {
  const std::size_t degree = static_cast<std::size_t>(p.degree());
  const Integer unit = low.denominator() * high.denominator();
  const Integer from = low.numerator() * high.denominator();
  const Integer length = high.numerator() * low.denominator() - from;
  std::vector<Integer> c(p.begin(), p.end());
  Integer scale(1);
  for (std::size_t i = degree; i-- > 0;) c[i] *= (scale *= unit);
  for (std::size_t i = 0; i < degree; ++i) {
    for (std::size_t j = degree; j-- > i;) c[j] += from * c[j + 1];
  }
  scale = Integer(1);
  for (std::size_t i = 1; i <= degree; ++i) c[i] *= (scale *= length);
  return c;
}

/// Whether the Bernstein coefficients over [low, high] have one strict sign: the polynomial is a convex combination of
/// them there, so it has no root. In degree n the coefficient j is the sum of j! (n - i)! / ((j - i)! n!) c_i over
/// i <= j, where c are the coefficients over the range. Here it is times n! / j!.
bool has_one_sign_over(const Polynomial& p, const Rational& low, const Rational& high) {
  const std::vector<Integer> c = coefficients_over(p, low, high);
  const CGAL::Sign first = CGAL::sign(c[0]);
  if (first == CGAL::ZERO) return false;
  const std::size_t degree = c.size() - 1;
  for (std::size_t j = 1; j <= degree; ++j) {
    Integer coefficient(0);
    for (std::size_t i = 0; i <= j; ++i) {
      Integer factor(1);  // (n - i)! / (j - i)!
      for (std::size_t k = j - i + 1; k <= degree - i; ++k) factor *= Integer(static_cast<long>(k));
      coefficient += factor * c[i];
    }
    if (CGAL::sign(coefficient) != first) return false;
  }
  return true;
}

using SharedImpl = std::shared_ptr<const Moment::Impl>;

SharedImpl make(const Real& time) { return std::make_shared<const Moment::Impl>(time); }
SharedImpl make(const Rational& time) { return make(Real(time)); }

/// Different times are told apart by their brackets, which narrow faster than the kernel's intervals.
CGAL::Comparison_result compare(const SharedImpl& a, const SharedImpl& b) {
  for (unsigned bits = kFirstPrecision;; bits *= 2) {
    const Bracket& first = a->narrowed(bits);
    const Bracket& second = b->narrowed(bits);
    if (second.is_exact()) return first.compare(second.low());
    if (first.is_exact()) return -second.compare(first.low());
    if (first.high() <= second.low()) return CGAL::SMALLER;
    if (second.high() <= first.low()) return CGAL::LARGER;
    // Equal times are a common root of their polynomials; where there is one, the kernel decides.
    const bool may_be_equal = bits == kFirstPrecision && Kernel().is_zero_at_1_object()(b->time.polynomial(), a->time);
    if (may_be_equal) return Kernel().compare_1_object()(a->time, b->time);
  }
}

}  // namespace

Moment::Moment(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

CGAL::Sign Moment::sign(const Polynomial& polynomial) const {
  if (polynomial.is_zero()) return CGAL::ZERO;
  const CGAL::Sign first = impl_->narrowed(kFirstPrecision).sign_throughout(polynomial);
  if (first != CGAL::ZERO || impl_->bracket.is_exact()) return first;
  // A common root is found by the kernel through the greatest common divisor. Its Sign_at_1 would go on from here by
  // halving, and breaks its own precondition when a half ends on the root.
  if (Kernel().is_zero_at_1_object()(polynomial, impl_->time)) return CGAL::ZERO;
  for (unsigned bits = 2 * kFirstPrecision;; bits *= 2) {
    const CGAL::Sign sign = impl_->narrowed(bits).sign_throughout(polynomial);
    if (sign != CGAL::ZERO) return sign;
  }
}

double Moment::ratio(const Polynomial& numerator, const Polynomial& denominator) const {
  const Rational tolerance = Rational(1) / CGAL::ipower(Rational(2), kWeightPrecision);
  for (unsigned bits = kFirstPrecision;; bits *= 2) {
    const Bracket& around = impl_->narrowed(bits);
    const auto [n, n_error] = around.value_and_error(numerator);
    const auto [d, d_error] = around.value_and_error(denominator);
    const Rational size = CGAL::abs(d);
    if (size <= d_error) continue;
    // (n + e) / (d + f) - n / d = (e d - n f) / (d (d + f))
    if (n_error * size + CGAL::abs(n) * d_error > tolerance * size * (size - d_error)) continue;
    const Rational quotient = n / d;
    return std::clamp(::mpq_get_d(quotient.mpq()), 0.0, 1.0);  // truncates: less than 2^-53 off
  }
}

std::pair<double, double> Moment::enclosing_doubles() const {
  const Bracket& around = impl_->narrowed(kFirstPrecision);
  // Doubles >= 0 are ordered like their bit patterns.
  const auto to_double = [](std::uint64_t bits) { return std::bit_cast<double>(bits); };
  std::uint64_t below = 0;                                      // of a double <= the time
  std::uint64_t above = std::bit_cast<std::uint64_t>(1.0) + 1;  // of one that is greater
  while (above - below > 1) {
    const std::uint64_t middle = below + (above - below) / 2;
    (around.compare(Rational(to_double(middle))) == CGAL::SMALLER ? above : below) = middle;
  }
  const bool is_double = around.compare(Rational(to_double(below))) == CGAL::EQUAL;
  return {to_double(below), to_double(is_double ? below : above)};
}

std::vector<Root> roots_within(const Polynomial& polynomial, double t_max) {
  std::vector<Root> roots;
  if (has_one_sign_over(polynomial, Rational(0), Rational(1))) return roots;
  std::vector<std::pair<Real, int>> all;
  Kernel().solve_1_object()(polynomial, std::back_inserter(all));
  for (const auto& [real, multiplicity] : all) {
    const SharedImpl time = make(real);
    if (time->bracket.compare(Rational(0)) == CGAL::SMALLER) continue;
    if (time->bracket.compare(Rational(t_max)) == CGAL::LARGER) break;
    roots.push_back({Moment(time), multiplicity});
  }
  return roots;
}

std::vector<Moment> times_dividing(double t_max, const std::vector<Polynomial>& polynomials) {
  return times_dividing(Rational(0), Rational(t_max), polynomials);
}

std::vector<Moment> times_dividing(const Rational& low, const Rational& high,
                                   const std::vector<Polynomial>& polynomials) {
  std::vector<Polynomial> distinct;  // many of them are multiples of each other when the plane of motion is fixed
  for (const auto& polynomial : polynomials) {
    if (polynomial.is_zero() || has_one_sign_over(polynomial, low, high)) continue;
    const Polynomial canonical = CGAL::canonicalize(polynomial);
    if (std::find(distinct.begin(), distinct.end(), canonical) == distinct.end()) distinct.push_back(canonical);
  }
  std::vector<SharedImpl> times;
  for (const auto& polynomial : distinct) {
    std::vector<std::pair<Real, int>> all;
    Kernel().solve_1_object()(polynomial, std::back_inserter(all));
    for (const auto& root : all) {
      const SharedImpl time = make(root.first);
      const bool inside = time->bracket.compare(low) == CGAL::LARGER && time->bracket.compare(high) == CGAL::SMALLER;
      if (inside) times.push_back(time);
    }
  }
  times.push_back(make(low));
  times.push_back(make(high));
  std::sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return compare(a, b) == CGAL::SMALLER; });
  const auto last = std::unique(times.begin(), times.end(),
                                [](const auto& a, const auto& b) { return compare(a, b) == CGAL::EQUAL; });
  return std::vector<Moment>(times.begin(), last);
}

Rational rational_between(const Moment& earlier, const Moment& later) {
  // The kernel's own Bound_between_1 needs MPFI or LEDA.
  for (unsigned bits = kFirstPrecision;; bits *= 2) {
    const Rational low = earlier.impl().narrowed(bits).high();
    const Rational high = later.impl().narrowed(bits).low();
    if (low < high) return Rational((low + high) / Rational(2));
  }
}

Moment between(const Moment& earlier, const Moment& later) { return Moment(make(rational_between(earlier, later))); }

}  // namespace touchstone::oracle
