// Everything that asks CGAL's algebraic kernel; the one source that includes it.
// SPDX-License-Identifier: MIT
#include "oracle/moment.hpp"

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/Gmpq.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>

namespace touchstone::oracle {
namespace {

using Kernel = CGAL::Algebraic_kernel_d_1<Integer>;
using Real = Kernel::Algebraic_real_1;
using Rational = Kernel::Bound;

constexpr int kFirstPrecision = 64;   // bits of the first bracket of a time; a double needs 53, a weight a few more
constexpr int kWeightPrecision = 56;  // a quotient within 2^-56 leaves room for its rounding to a double

/// Whether the Bernstein coefficients over [0, 1] have one strict sign: the polynomial is a convex combination of
/// them there, so it has no root. Degree at most 3, raised to 3; each coefficient is times 3.
bool has_one_sign_over_the_step(const Polynomial& p) {
  const int degree = p.degree();
  const Integer zero(0);
  const Integer& p0 = p[0];
  const Integer& p1 = degree >= 1 ? p[1] : zero;
  const Integer& p2 = degree >= 2 ? p[2] : zero;
  const Integer& p3 = degree >= 3 ? p[3] : zero;
  const CGAL::Sign first = CGAL::sign(p0);
  return first != CGAL::ZERO && CGAL::sign(Integer(p0 + p1 + p2 + p3)) == first &&
         CGAL::sign(Integer(3 * p0 + p1)) == first && CGAL::sign(Integer(3 * p0 + 2 * p1 + p2)) == first;
}

/// A value known to within an error.
struct Measured {
  Rational value;
  Rational error;
};

/// p over the bracket [low, high], |low|, |high| <= 2: by the mean value theorem p differs from p(low) by at most
/// (high - low) times the largest |p'| <= sum of k |p_k| 2^(k-1).
Measured measure(const Polynomial& p, const std::pair<Rational, Rational>& bracket) {
  Integer slope(0);
  for (int k = p.degree(); k >= 1; --k) slope = 2 * slope + k * CGAL::abs(p[k]);
  return {p.evaluate(bracket.first), (bracket.second - bracket.first) * Rational(slope)};
}

/// Distances between doubles >= 0 are distances between their bit patterns.
double from_bits(std::uint64_t bits) { return std::bit_cast<double>(bits); }

}  // namespace

struct Moment::Impl {
  Real time;

  /// An interval around the time, at most 2^-bits long, not necessarily isolating; both ends equal when it is known
  /// to be rational.
  std::pair<Rational, Rational> bracket(int bits) const { return Kernel().approximate_absolute_1_object()(time, bits); }
};

namespace {

Moment make_moment(const Real& time) { return Moment(std::make_shared<const Moment::Impl>(Moment::Impl{time})); }

bool is_within(const Real& time, const Rational& t_max) {
  return time.compare(Rational(0)) != CGAL::SMALLER && time.compare(t_max) != CGAL::LARGER;
}

}  // namespace

Moment::Moment(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

CGAL::Sign Moment::sign(const Polynomial& polynomial) const {
  return Kernel().sign_at_1_object()(polynomial, impl_->time);
}

double Moment::ratio(const Polynomial& numerator, const Polynomial& denominator) const {
  const Rational tolerance = Rational(1) / CGAL::ipower(Rational(2), kWeightPrecision);
  for (int bits = kFirstPrecision;; bits *= 2) {
    const auto around = impl_->bracket(bits);
    const Measured n = measure(numerator, around);
    const Measured d = measure(denominator, around);
    const Rational size = CGAL::abs(d.value);
    if (size <= d.error) continue;
    // With n = n0 + e, d = d0 + f: n/d - n0/d0 = (e d0 - n0 f) / (d d0).
    const Rational error = n.error * size + CGAL::abs(n.value) * d.error;
    if (error > tolerance * (size - d.error) * size) continue;
    const Rational quotient = n.value / d.value;
    return std::clamp(::mpq_get_d(quotient.mpq()), 0.0, 1.0);  // truncates: less than 2^-53 off
  }
}

std::pair<double, double> Moment::enclosing_doubles() const {
  const auto around = impl_->bracket(kFirstPrecision);
  const Polynomial polynomial = impl_->time.polynomial();
  const CGAL::Sign sign_before = polynomial.sign_at(around.first);
  const auto compare_with = [&](const Rational& time) {
    if (around.first == around.second) return CGAL::compare(around.first, time);
    if (time <= around.first) return CGAL::LARGER;
    if (around.second <= time) return CGAL::SMALLER;
    const CGAL::Sign there = polynomial.sign_at(time);
    return there == CGAL::ZERO ? CGAL::EQUAL : there == sign_before ? CGAL::LARGER : CGAL::SMALLER;
  };
  std::uint64_t below = 0;                                      // bits of a double <= the time
  std::uint64_t above = std::bit_cast<std::uint64_t>(1.0) + 1;  // bits of one that is greater
  while (above - below > 1) {
    const std::uint64_t middle = below + (above - below) / 2;
    (compare_with(Rational(from_bits(middle))) == CGAL::SMALLER ? above : below) = middle;
  }
  const bool is_double = compare_with(Rational(from_bits(below))) == CGAL::EQUAL;
  return {from_bits(below), from_bits(is_double ? below : above)};
}

std::vector<Root> roots_within(const Polynomial& polynomial, double t_max) {
  std::vector<Root> roots;
  if (has_one_sign_over_the_step(polynomial)) return roots;
  std::vector<std::pair<Real, int>> all;
  Kernel().solve_1_object()(polynomial, std::back_inserter(all));
  for (const auto& [time, multiplicity] : all) {
    if (is_within(time, Rational(t_max))) roots.push_back({make_moment(time), multiplicity});
  }
  return roots;
}

std::vector<Moment> times_dividing(double t_max, const std::vector<Polynomial>& polynomials) {
  std::vector<Polynomial> distinct;  // many of them are multiples of each other when the plane of motion is fixed
  for (const auto& polynomial : polynomials) {
    if (polynomial.is_zero() || has_one_sign_over_the_step(polynomial)) continue;
    const Polynomial canonical = CGAL::canonicalize(polynomial);
    if (std::find(distinct.begin(), distinct.end(), canonical) == distinct.end()) distinct.push_back(canonical);
  }
  std::vector<Real> times = {Real(Rational(0)), Real(Rational(t_max))};
  for (const auto& polynomial : distinct) {
    std::vector<std::pair<Real, int>> all;
    Kernel().solve_1_object()(polynomial, std::back_inserter(all));
    for (const auto& root : all) {
      if (is_within(root.first, Rational(t_max))) times.push_back(root.first);
    }
  }
  const auto compare = Kernel().compare_1_object();
  std::sort(times.begin(), times.end(), [&](const Real& a, const Real& b) { return compare(a, b) == CGAL::SMALLER; });
  times.erase(std::unique(times.begin(), times.end(),
                          [&](const Real& a, const Real& b) { return compare(a, b) == CGAL::EQUAL; }),
              times.end());
  std::vector<Moment> moments;
  for (const auto& time : times) moments.push_back(make_moment(time));
  return moments;
}

Moment between(const Moment& earlier, const Moment& later) {
  // The kernel's own Bound_between_1 needs MPFI or LEDA.
  for (int bits = kFirstPrecision;; bits *= 2) {
    const Rational low = earlier.impl().bracket(bits).second;
    const Rational high = later.impl().bracket(bits).first;
    if (low < high) return make_moment(Real((low + high) / Rational(2)));
  }
}

}  // namespace touchstone::oracle
