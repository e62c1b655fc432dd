// SPDX-License-Identifier: MIT
#include "numbers/roots/located_root.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/integers/bounded_integers.hpp"

namespace touchstone::numbers {
namespace {

/// From t to a root of a cubic, by Laguerre's method: as near as a cubic gets with its three roots almost together, and
/// cubically convergent elsewhere. Newton's step where that is not real.
double laguerre_step(const BoundedPair* c, double t, double value, double slope) noexcept {
  const double half_bend = c[2].value.high + 3 * c[3].value.high * t;
  const double square = 4 * slope * slope - 12 * value * half_bend;
  return 3 * value / (slope + (square > 0 ? std::copysign(std::sqrt(square), slope) : 2 * slope));
}

/// A double near the one root of a polynomial in (low, high), from one inside by safeguarded iteration; only a hint. A
/// flat polynomial needs its value in double-doubles, `closely`, and small steps do not show that its root is near.
double hint(const BoundedPair* c, int size, double low, double high, int sign_low, double t, bool closely) noexcept {
  constexpr int kIterations = 60;
  const double enough = closely ? 0x1p-49 : 0x1p-36;
  for (int i = 0; i < kIterations; ++i) {
    double value = c[size - 1].value.high, terms = std::fabs(value);
    double slope = (size - 1) * value;
    for (int k = size - 2; k >= 0; --k) {
      value = value * t + c[k].value.high;
      terms = terms * t + std::fabs(c[k].value.high);
      if (k > 0) slope = slope * t + k * c[k].value.high;
    }
    if (closely) value = value_at(c, size, exact_pair(t)).value.high;
    if (!closely && std::fabs(value) <= kRounding * terms) break;  // noise
    ((value < 0) == (sign_low < 0) ? low : high) = t;
    double next = t - (size == 4 ? laguerre_step(c, t, value, slope) : value / slope);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool converged = std::fabs(next - t) <= enough * t;
    t = next;
    if (converged) break;
  }
  return t;
}

/// `locate` from a hint alone.
///
/// At t, a hint, p has the value v, off by at most e, and the slope s, off by at most f. In [-1, 2], p' changes by at
/// most `bend` times the way, bend = 2 |c2| + 12 |c3| >= |p''|. Let d = 2 (|v| + e) / |s|. If f + bend d <= |s| / 4,
/// then p' keeps its sign within d of t and is at least 3/4 |s|: on the way d, p changes by more than |v| + e, so that
/// exactly one root lies within d. It is the one in (low, high): t lies there; and where `high` is within d of t, p has
/// the sign at `high` that it takes after that root, when s has this sign. Likewise for `low`. The root is at
/// t - V / S, with V the true value and S a mean of p' on the way, off by at most q |s| for q = (f + bend d) / |s|.
/// With 1 / (1 - q) <= 1 + 2 q for q <= 1/2, the offset -v / s is off by at most (1 + 2 q) (e + q |v|) / |s| and its
/// own rounding; the rounding of v to a double counts in e. The factor is for the rounding of these lines. Where
/// f + bend w <= |s| / 2, p' keeps its sign within w of t, so that no other root is there; `reach` is w less d.
std::optional<Located> locate_from(double t, const BoundedPair* c, int size, int sign_low) noexcept {
  constexpr double kSlack = 1 + 0x1p-20;
  const Bounded v = rounded(value_at(c, size, exact_pair(t)));
  Bounded slope = {0, 0};
  for (int k = size - 1; k > 0; --k) {
    slope = slope * Bounded{t, 0} + Bounded{static_cast<double>(k), 0} * rounded(c[k]);
  }
  const auto magnitude = [&](int k) { return k < size ? std::fabs(c[k].value.high) : 0; };
  const double bend = kSlack * (2 * magnitude(2) + 12 * magnitude(3));
  const double steep = std::fabs(slope.value);
  const double distance = kSlack * 2 * (std::fabs(v.value) + v.error) / steep;
  const double q = kSlack * (slope.error + bend * distance) / steep;
  if (!(q <= 0.25 && distance <= 1 && slope.value * sign_low < 0)) return std::nullopt;
  const double offset = -v.value / slope.value;
  const double error =
      kSlack * ((1 + 2 * q) * (v.error + q * std::fabs(v.value)) / steep + kRounding * std::fabs(offset)) + kUnderflow;
  const double reach = bend > 0 ? std::min(1.0, (0.5 * steep - slope.error) / (kSlack * bend)) : 1.0;
  return Located{{two_sum(t, offset), error}, (reach - distance) / kSlack};
}

}  // namespace

double hint_of_first(const Polynomial<SmallInt, 3>& p) noexcept {
  BoundedPair c[4];
  for (int i = 0; i < 4; ++i) c[i] = exact_pair(to_double(p[i]));
  constexpr int kIterations = 8;
  double t = 0;
  for (int i = 0; i < kIterations; ++i) {
    const double c1 = c[1].value.high, c2 = c[2].value.high, c3 = c[3].value.high;
    const double value = ((c3 * t + c2) * t + c1) * t + c[0].value.high;
    const double step = laguerre_step(c, t, value, (3 * c3 * t + 2 * c2) * t + c1);
    t -= step;
    if (!(std::fabs(step) > 0x1p-24 * t)) break;
  }
  return t;
}

double hint_between(const BoundedPair* c, int size, double low, double high, int sign_low) noexcept {
  const double c0 = c[0].value.high, c1 = c[1].value.high;
  if (size == 2) return -c0 / c1;
  if (size == 3) {
    const double c2 = c[2].value.high;
    const double sum = -0.5 * (c1 + std::copysign(std::sqrt(std::max(0.0, c1 * c1 - 4 * c0 * c2)), c1));
    for (const double root : {sum / c2, c0 / sum}) {
      if (root > low && root < high) return root;
    }
  }
  return hint(c, size, low, high, sign_low, 0.5 * (low + high), false);
}

std::optional<Located> locate(const BoundedPair* c, int size, double low, double high, int sign_low,
                              double near) noexcept {
  constexpr double kGoodError = 0x1p-60;
  const auto located = locate_from(near, c, size, sign_low);
  if (located && located->near.error <= kGoodError * located->near.value.high) return located;
  const auto closer = locate_from(hint(c, size, low, high, sign_low, near, true), c, size, sign_low);
  return closer ? closer : located;
}

}  // namespace touchstone::numbers
