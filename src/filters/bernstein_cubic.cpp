// SPDX-License-Identifier: MIT
#include "filters/bernstein_cubic.hpp"

#include <algorithm>
#include <cmath>

#include "filters/coplanarity_form.hpp"

namespace touchstone::filters {
namespace {

// e = kUnit and P = size throughout. The given coefficients are off by at most 34 e P (b0, b3) and 122 e P (3 b1, 3 b2)
// but for what their bounds have in reserve, and in absolute value at most 4 P and 12 P (see coplanarity_form.hpp).
// Times are exact_to_one, so s = 1 - t is exact. For t in [-m, 1 + m], m = kMargin = 2^-20, |s| + |t| is at most
// 1 + 2 m, and sums weighted by products of three of s and t grow by less than 1 + 2^-17: each constant has more slack
// than that.

// Coefficients over a part of [0, 1], by interpolating b0, b1, b2, b3 three times. 3 b1 / 3: 122 / 3 + 4 < 45 e P. An
// interpolation (1 - x) a + x b passes each operand through 2 roundings, of values of at most 4 P: 8 e P a time.
constexpr double kPartBound = 70 * kUnit;

// The value (c0 s + c1 t) s^2 + (c2 s + c3 t) t^2: the coefficients' errors weigh
// 34 (s^3 + t^3) + 122 s t = 34 + 20 s t <= 39 e P; each monomial passes through 5 roundings, and their absolute values
// sum to at most 4 P: 20 e P.
constexpr double kValueBound = 60 * kUnit;

// The derivative's Bernstein coefficients 3 b1 - 3 b0, 3 b2 - 3 b1, 3 b3 - 3 b2, at most 24 P: off by 122 + 3 * 34 and
// the roundings 12 + 24, or by 2 * 122 + 24, at most 268 e P. Its value: at most 4 roundings of monomials that sum to
// at most 24 P, 96 e P more. The curvature is twice the difference of two of these coefficients, off by
// 2 (260 + 268 + 48) = 1152 e P. At most 2^-10 away this makes 1.2 e P of slope, which this constant includes.
constexpr double kSlopeBound = 366 * kUnit;

double between(double a, double b, double x) noexcept { return (1 - x) * a + x * b; }

/// Sign variations of coefficients that are off by at most `ends` (the first and the last) and `middle`.
BernsteinCubic::Variations variations_of(const std::array<double, 4>& b, double ends, double middle) noexcept {
  using Variations = BernsteinCubic::Variations;
  if (!(std::fabs(b[0]) > ends && std::fabs(b[3]) > ends)) return Variations::uncertain;
  const double second = flipped(b[1], b[0]);
  const double third = flipped(b[2], b[0]);
  if (flipped(b[3], b[0]) > 0) return second > middle && third > middle ? Variations::none : Variations::uncertain;
  // One variation whatever the uncertain signs are, unless the middle ones may change sign twice.
  return second > middle || third < -middle ? Variations::one : Variations::uncertain;
}

}  // namespace

BernsteinCubic::BernsteinCubic(const std::array<double, 4>& c, double size) noexcept
    : c_(c), size_(size), d0_(c[1] - 3 * c[0]), d1_(c[2] - c[1]), d2_(3 * c[3] - c[2]) {
  // V'' is linear in t between twice these differences, and beyond by at most 2 m times more.
  curvature_ = (2 + 0x1p-17) * std::max(std::fabs(d1_ - d0_), std::fabs(d2_ - d1_));
}

double BernsteinCubic::slope_error() const noexcept { return kSlopeBound * size_; }
double BernsteinCubic::value_error() const noexcept { return kValueBound * size_; }
double BernsteinCubic::part_error() const noexcept { return kPartBound * size_; }

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

std::array<double, 4> BernsteinCubic::part(double p, double q) const noexcept {
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
  if (p == 0 && q == 1) return variations_of(c_, kEndsBound * size_, kMiddleBound * size_);
  return variations_of(part(p, q), part_error(), part_error());
}

BernsteinCubic::Root BernsteinCubic::root_between(double p, double q) const noexcept {
  // Halley's method, kept inside by bisection; the code below certifies its result. `refine_root` takes one more step,
  // in double-double. The iteration ends where that step's error, a multiple of its length squared, is about 2^-70 t:
  // then it seldom matters for the side of a double on which the root lies.
  const double value_p = value(p);
  const double value_q = value(q);
  double low = p;
  double high = q;
  double s = 1 - (p + (q - p) * (value_p / (value_p - value_q)));  // the chord's zero
  double t = 1 - s;                                                // exact_to_one
  double v = value(s, t);
  double d = slope(s, t);
  constexpr int kIterations = 30;
  constexpr double kNearEnough = 0x1p-38;
  const double bound = value_error();  // below it a sign means nothing
  for (int i = 0; i < kIterations && std::fabs(v) > bound && !(std::fabs(v) <= kNearEnough * t * std::fabs(d)); ++i) {
    ((v < 0) == (value_p < 0) ? low : high) = t;
    const double half_curvature = (d1_ - d0_) + t * ((d2_ - d1_) - (d1_ - d0_));
    double next = t - v * d / (d * d - v * half_curvature);
    if (!(next > low && next < high)) next = 0.5 * low + 0.5 * high;
    s = 1 - next;
    t = 1 - s;
    v = value(s, t);
    d = slope(s, t);
  }
  const double error = std::fabs(v) + value_error();
  const double steepness = std::fabs(d);
  // A root lies within the radius: the slope is at least half of |d| there, and half of |d| times the radius reaches
  // beyond any value that V(t) may have. The factors have slack for the rounding of these lines.
  const double radius = 2.0625 * error / steepness;
  const bool certain = radius <= kGreatestRadius && curvature_ * radius + slope_error() <= 0.484375 * steepness &&
                       t - radius > p && t + radius < q;
  return {certain, t, radius, d};
}

}  // namespace touchstone::filters
