// SPDX-License-Identifier: MIT
#include "filters/bracket.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "filters/bernstein_cubic.hpp"
#include "filters/refined_root.hpp"

namespace touchstone::filters {
namespace {

/// Bounds on the coordinates of the frame: U, W, R of the derivations.
struct Magnitudes {
  double u, w, r;
};

// With U, W and R between these no product of three, nor the low part of one, underflows or overflows to an effect: what
// is lost is at most 2^-1074 per product, 2^-500 of U W and 2^-300 of U W R.
constexpr double kLeast = 0x1p-250;
constexpr double kGreatest = 0x1p250;

bool within_range(const Magnitudes& m) noexcept {
  return std::min({m.u, m.w, m.r}) >= kLeast && std::max({m.u, m.w, m.r}) <= kGreatest;
}

Vector at(const Vector& start, const Vector& end, double t) noexcept {
  const double s = 1 - t;
  return {{s * start[0] + t * end[0], s * start[1] + t * end[1], s * start[2] + t * end[2]}};
}

/// A value that is off by at most `error`.
struct Bounded {
  double value;
  double error;
};

enum class Side : std::uint8_t {
  inside,
  outside,
  close,   ///< to a border: a closer look may tell
  unknown  ///< n may be zero
};

/// Where the contact of the two lines, or of the point and the plane, lies at the roots within [t - h, t + h].
// At t the vectors u, w and r are off by at most 4 e times their bound: s = 1 - t, two products, a sum and the rounded
// differences. A component of a cross product of two of them has 2 monomials with 4 + 4 + 2 roundings: 20 e. Its slope in
// t is at most 2 (2 + 2) = 8 times the product of the bounds, since a coordinate changes by at most twice its bound over
// the step. So at any time within h it is off by at most (21 e + 8.01 h) times the product, second-order terms included
// (h is at most 2^-10 where this is used).
struct Sides {
  std::size_t axis;
  Side side;
};

Sides sides(const Query& query, const Frame& f, const Magnitudes& m, double t, double h) noexcept {
  const Vector u = at(f.u0, f.u1, t);
  const Vector w = at(f.w0, f.w1, t);
  const Vector r = at(f.r0, f.r1, t);
  const Vector n = geometry::cross(u, w);
  std::size_t k = std::fabs(n[0]) > std::fabs(n[1]) ? 0 : 1;
  if (std::fabs(n[2]) > std::fabs(n[k])) k = 2;
  const double spread = 21 * kUnit + 8.01 * h;
  const double n_error = spread * m.u * m.w;
  if (!(std::fabs(n[k]) > n_error)) return {k, Side::unknown};
  const double sign = n[k] > 0 ? 1 : -1;
  const Bounded normal = {std::fabs(n[k]), n_error};
  const Bounded first = {sign * geometry::cross_component(r, w, k), spread * m.r * m.w};
  const Bounded second = {sign * (query.kind == Kind::edge_edge ? geometry::cross_component(r, u, k) : geometry::cross_component(u, r, k)),
                          spread * m.r * m.u};
  // Each must be >= 0; the differences' own rounding is covered by the slack of 1 e in `spread`.
  const auto minus = [](const Bounded& a, const Bounded& b) {
    return Bounded{a.value - b.value, a.error + b.error + kUnit * (std::fabs(a.value) + std::fabs(b.value))};
  };
  Bounded conditions[4] = {first, second, {}, {}};
  int count;
  if (query.kind == Kind::edge_edge) {
    conditions[2] = minus(normal, first);
    conditions[3] = minus(normal, second);
    count = 4;
  } else {
    conditions[2] = minus(minus(normal, first), second);
    count = 3;
  }
  Side side = Side::inside;
  for (int i = 0; i < count; ++i) {
    if (conditions[i].value < -conditions[i].error) return {k, Side::outside};
    if (!(conditions[i].value > conditions[i].error)) side = Side::close;
  }
  return {k, side};
}

}  // namespace

Decision bracket(const Query& query, const Frame& frame, const std::array<double, 4>& coefficients, double t_max,
                 Want want, ExactSign exact_sign, Answer& answer) {
  const Magnitudes m = {largest(frame.u0, frame.u1), largest(frame.w0, frame.w1), largest(frame.r0, frame.r1)};
  if (!within_range(m)) return Decision::uncertain;
  const BernsteinCubic cubic(coefficients, m.u * m.w * m.r);
  double split[4];
  const auto whole = cubic.variations(0, 1);
  if (whole == BernsteinCubic::Variations::none) return Decision::no_contact;
  const int segments = cubic.split_points(whole, split);
  for (int i = 0; i < segments; ++i) {
    if (split[i] > t_max) break;
    switch (segments == 1 ? whole : cubic.variations(split[i], split[i + 1])) {
      case BernsteinCubic::Variations::none: continue;
      case BernsteinCubic::Variations::uncertain: return Decision::uncertain;
      case BernsteinCubic::Variations::one: break;
    }
    const BernsteinCubic::Root root = cubic.root_between(split[i], split[i + 1]);
    if (!root.certain) return Decision::uncertain;
    if (root.t - root.radius > t_max) return Decision::no_contact;
    const Sides where = sides(query, frame, m, root.t, root.radius);
    if (where.side == Side::outside) continue;
    if (where.side == Side::unknown) return Decision::uncertain;
    const bool inside = where.side == Side::inside;
    if (want == Want::contact_only && inside && root.t + root.radius < t_max) return Decision::contact;
    const SimpleRoot simple = {root.t, root.radius, root.slope, cubic.slope_error(), cubic.curvature_bound()};
    const ContactFrame contact_frame = {m.u, m.w, m.r, cubic.size(), where.axis};
    switch (refine_root(query, simple, contact_frame, inside, t_max, exact_sign, answer)) {
      case RootVerdict::contact: return Decision::contact;
      case RootVerdict::outside: continue;
      case RootVerdict::too_late: return Decision::no_contact;
      case RootVerdict::uncertain: return Decision::uncertain;
    }
  }
  return Decision::no_contact;
}

}  // namespace touchstone::filters
