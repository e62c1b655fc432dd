// SPDX-License-Identifier: MIT
#include "filters/bernstein_cubic.hpp"

#include <algorithm>
#include <cmath>

#include "filters/coplanarity_form.hpp"

namespace touchstone::filters {
namespace {

// e = kUnit and P = size, as in step_cubic.hpp.

// Coefficients over a part of [0, 1], by interpolating b0, b1, b2, b3 three times. 3 b1 / 3: 122 / 3 + 4 < 45 e P. An
// interpolation (1 - x) a + x b passes each operand through 2 roundings, of values of at most 4 P: 8 e P a time.
constexpr double kRestrictionBound = 70 * kUnit;

double between(double a, double b, double x) noexcept { return (1 - x) * a + x * b; }

}  // namespace

double BernsteinCubic::restriction_error() const noexcept { return kRestrictionBound * size_; }

int BernsteinCubic::split_points(double low, double high, double (&split)[4]) const noexcept {
  split[0] = low;
  int count = 1;
  // The critical points: roots of d0 s^2 + 2 d1 s t + d2 t^2.
  const double a = d0_ - 2 * d1_ + d2_;
  const double half_b = d1_ - d0_;
  const double discriminant = half_b * half_b - a * d0_;
  if (discriminant > 0) {
    const double q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    double critical[2] = {q / a, d0_ / q};
    if (critical[1] < critical[0]) std::swap(critical[0], critical[1]);
    for (const double t : critical) {
      const double point = exact_to_one(t);
      if (point > split[count - 1] && point < high) split[count++] = point;
    }
  }
  if (count == 1) split[count++] = 0.5;  // monotone, but too curved for the coefficients to show it
  split[count] = high;
  return count;
}

std::array<double, 4> BernsteinCubic::restricted_to(double p, double q) const noexcept {
  const double b1 = c_[1] / 3;
  const double b2 = c_[2] / 3;
  const double at_p[3] = {between(c_[0], b1, p), between(b1, b2, p), between(b2, c_[3], p)};
  const double at_q[3] = {between(c_[0], b1, q), between(b1, b2, q), between(b2, c_[3], q)};
  const double pp[2] = {between(at_p[0], at_p[1], p), between(at_p[1], at_p[2], p)};
  const double pq[2] = {between(at_p[0], at_p[1], q), between(at_p[1], at_p[2], q)};
  const double qq[2] = {between(at_q[0], at_q[1], q), between(at_q[1], at_q[2], q)};
  return {between(pp[0], pp[1], p), between(pp[0], pp[1], q), between(pq[0], pq[1], q), between(qq[0], qq[1], q)};
}

BernsteinCubic::Variations BernsteinCubic::variations(double p, double q) const noexcept {
  const SignVariations<double> found =
      p == 0 && q == 1 ? step_variations()
                       : variations_of(restricted_to(p, q), restriction_error(), restriction_error());
  return found.none ? Variations::none : found.one ? Variations::one : Variations::uncertain;
}

}  // namespace touchstone::filters
