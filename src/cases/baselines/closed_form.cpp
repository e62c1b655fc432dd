// The cubic in closed form, with the care that doubles allow.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "baselines/first_touch.hpp"

// The degree is decided by comparing the coefficients with their own rounding noise. No large term is divided by a
// small one. S is the sum without cancellation, and T = -Q / S. A double root is sought where V is stationary. A root
// at an end of the step is sought where V is nearly zero there. Newton steps polish the roots of the formulas.
namespace touchstone::baselines {
namespace {

// Slack of the inside tests: a few thousand ulps, as much as weights of well-shaped elements lose to rounding.
constexpr double kSlack = 1e-12;

// A root at most this far outside [0, t_max] counts as a root at its end.
constexpr double kTimeSlack = 1e-14;

// If the leading coefficient is smaller than this fraction of the others, the two roots near [0, 1] are those of the
// quadratic, to first order. The formulas of the cubic would lose them in the difference of two numbers near b / a.
constexpr double kSmallLeading = 1e-6;

double polished(const Cubic& p, double t) {
  for (int step = 0; step < 4; ++step) {
    const double next = t - value(p, t) / slope(p, t);
    if (!std::isfinite(next) || std::fabs(value(p, next)) >= std::fabs(value(p, t))) break;
    t = next;
  }
  return t;
}

class Roots {
 public:
  Roots(const Cubic& p, double t_max, Times& times) : p_(p), t_max_(t_max), times_(times) {}

  void add(double t) {
    t = polished(p_, t);
    if (t >= -kTimeSlack && t <= t_max_ + kTimeSlack) times_.add(std::clamp(t, 0.0, t_max_));
  }

  /// A double root, or one at an end of the step, that rounding may have lost.
  void add_where_noise(double t, double noise) {
    if (t >= 0 && t <= t_max_ && std::fabs(value(p_, t)) <= noise) times_.add(t);
  }

 private:
  const Cubic& p_;
  double t_max_;
  Times& times_;
};

/// Equations (20) to (22), for t^3 + b t^2 + c t + d.
void add_cubic_roots(double b, double c, double d, Roots& roots) {
  const double shift = b / 3;
  const double Q = c / 3 - shift * shift;
  const double R = (shift * c - d) / 2 - shift * shift * shift;
  const double G = Q * Q * Q + R * R;
  if (G < 0) {
    const double radius = 2 * std::sqrt(-Q);
    const double theta = std::atan2(std::sqrt(-G), R);
    constexpr double kTurn = 6.283185307179586;
    for (int k = 0; k < 3; ++k) roots.add(radius * std::cos((theta + k * kTurn) / 3) - shift);
    return;
  }
  const double S = std::copysign(std::cbrt(std::fabs(R) + std::sqrt(G)), R);
  roots.add(S == 0 ? -shift : S - Q / S - shift);  // a second root is double then, and V is stationary there
}

void closed_form_roots(const Cubic& polynomial, double t_max, double, Times& times) {
  Cubic p = polynomial;
  for (std::size_t i = 0; i <= 3; ++i) {
    if (is_noise(p, i)) p.c[i] = 0;
  }
  const auto& [d, c, b, a] = p.c;
  const double noise = kZero * (p.size[0] + p.size[1] + p.size[2] + p.size[3]);
  if (one_sided(p.c, noise)) return;

  Roots roots(p, t_max, times);
  if (std::fabs(a) > kSmallLeading * std::max({std::fabs(b), std::fabs(c), std::fabs(d)})) {
    add_cubic_roots(b / a, c / a, d / a, roots);
  } else {
    const QuadraticRoots near = quadratic_roots(b, c, d);
    for (std::size_t i = 0; i < near.count; ++i) roots.add(near.t[i]);
  }
  const QuadraticRoots stationary = quadratic_roots(3 * a, 2 * b, c);
  for (std::size_t i = 0; i < stationary.count; ++i) roots.add_where_noise(stationary.t[i], noise);
  roots.add_where_noise(0, noise);
  roots.add_where_noise(t_max, noise);
}

}  // namespace

Result solve_closed_form(const Query& query, double t_max, double) {
  return first_touch(query, t_max, closed_form_roots, 0.0, kSlack);
}

}  // namespace touchstone::baselines
