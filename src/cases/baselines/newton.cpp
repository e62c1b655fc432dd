// Bracketed iteration in doubles, to a tolerance.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "baselines/first_touch.hpp"

// The critical points cut [0, t_max] into pieces on which V is monotone. Each piece with a change of sign holds one
// root, which Newton steps approach and bisection steps keep in its bracket.
namespace touchstone::baselines {
namespace {

// Bisection alone needs no more than this for any tolerance that doubles in [0, 1] can tell from 0.
constexpr int kSteps = 200;

/// The lower end of a bracket no wider than `tolerance`, unless its ends are neighbours, around the change of sign.
double bracketed_root(const Cubic& p, double low, double high, double tolerance) {
  const bool rising = value(p, low) < 0;
  double t = 0.5 * (low + high);
  for (int step = 0; step < kSteps && high - low > tolerance; ++step) {
    const double v = value(p, t);
    (v < 0) == rising ? low = t : high = t;
    // A step that goes half a tolerance past the root closes the bracket from the other side, too.
    const double newton = t - v / slope(p, t);
    const double past = newton > t ? newton + 0.5 * tolerance : newton - 0.5 * tolerance;
    const bool useful = step % 3 != 2 && past > low && past < high;
    t = useful ? past : 0.5 * (low + high);
    if (t <= low || t >= high) break;
  }
  return low;
}

void newton_roots(const Cubic& p, double t_max, double tolerance, Times& times) {
  const double flat =
      tolerance * std::max({std::fabs(p.c[0]), std::fabs(p.c[1]), std::fabs(p.c[2]), std::fabs(p.c[3])});
  if (flat == 0 && is_noise(p)) return;
  const QuadraticRoots critical = quadratic_roots(3 * p.c[3], 2 * p.c[2], p.c[1]);
  std::array<double, 4> ends{0, t_max, t_max, t_max};
  for (std::size_t i = 0; i < critical.count; ++i) {
    if (critical.t[i] > 0 && critical.t[i] < t_max) ends[i + 1] = critical.t[i];
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double at_end = value(p, ends[i]);
    if (std::fabs(at_end) <= flat) times.add(ends[i]);  // a double root, or one at an end of the step
    if (i + 1 < ends.size() && (at_end < 0) != (value(p, ends[i + 1]) < 0)) {
      times.add(bracketed_root(p, ends[i], ends[i + 1], tolerance));
    }
  }
}

}  // namespace

Result solve_newton(const Query& query, double t_max, double tolerance) {
  // In the frame's unit a point moves by less than 2 sqrt(3) relative to another one, so at a time that is right to a
  // quarter of the tolerance it is within the tolerance of its place.
  return first_touch(query, t_max, newton_roots, 0.25 * tolerance, tolerance);
}

}  // namespace touchstone::baselines
