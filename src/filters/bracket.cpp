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

/// n, f1 and f2 along the axis where n is largest, each times the sign of n there: what the side conditions compare.
struct SideValues {
  std::size_t axis;
  double sign;
  Bounded normal, first, second;
};

// At t, exact_to_one, the vectors u, w and r are off by at most 3 e times their bound: the rounded differences, two products
// and a sum. A component of a cross product of two of them has 2 monomials with 3 + 3 + 2 roundings: 16 e. Its slope in
// t is at most 2 (2 + 2) = 8 times the product of the bounds, since a coordinate changes by at most twice its bound over
// the step. So at any time within h it is off by at most (16 e + 8 h) times the product, and little more within kMargin of
// the step, where bounds and slopes grow by less than 2^-18 of themselves.
SideValues side_values(Kind kind, const Frame& f, const Magnitudes& m, double t, double h) noexcept {
  const Vector u = at(f.u0, f.u1, t);
  const Vector w = at(f.w0, f.w1, t);
  const Vector r = at(f.r0, f.r1, t);
  const Vector n = geometry::cross(u, w);
  std::size_t k = std::fabs(n[0]) > std::fabs(n[1]) ? 0 : 1;
  if (std::fabs(n[2]) > std::fabs(n[k])) k = 2;
  const double spread = 17 * kUnit + (8 + 0x1p-10) * h;
  const double sign = n[k] > 0 ? 1 : -1;
  const double second =
      kind == Kind::edge_edge ? geometry::cross_component(r, u, k) : geometry::cross_component(u, r, k);
  return {k,
          sign,
          {std::fabs(n[k]), spread * m.u * m.w},
          {sign * geometry::cross_component(r, w, k), spread * m.r * m.w},
          {sign * second, spread * m.r * m.u}};
}

/// Where the contact of the two lines, or of the point and the plane, lies at the roots within [t - h, t + h].
struct Sides {
  std::size_t axis;
  Side side;
};

Sides sides(const Query& query, const Frame& f, const Magnitudes& m, double t, double h) noexcept {
  const auto [k, sign_of_n, normal, first, second] = side_values(query.kind, f, m, t, h);
  if (!(normal.value > normal.error)) return {k, Side::unknown};
  // Each must be >= 0. `minus` counts its own rounding; the slack of 1 e in `spread` is for terms of e^2.
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

namespace {

/// What is known of a query on its way through this level.
struct Search {
  const Query& query;
  const Frame& frame;
  const Magnitudes& magnitudes;
  const BernsteinCubic& cubic;
  double t_max;
  Want want;
  ExactValue exact_value;
};

/// A decision, or that the roots could not be told apart from each other or from the ends of the range.
enum class Outcome : std::uint8_t { contact, no_contact, uncertain, not_isolated };

/// What one root says.
enum class RootOutcome : std::uint8_t { contact, none, too_late, uncertain, not_isolated };

RootOutcome decide_between(const Search& s, double p, double q, Answer& answer) {
  const BernsteinCubic::Root root = s.cubic.root_between(p, q);
  if (!root.certain) return RootOutcome::not_isolated;
  if (root.t - root.radius > s.t_max) return RootOutcome::too_late;
  if (root.t + root.radius < 0) return RootOutcome::none;
  const Magnitudes& m = s.magnitudes;
  const Sides where = sides(s.query, s.frame, m, root.t, root.radius);
  if (where.side == Side::outside) return RootOutcome::none;
  if (where.side == Side::unknown) return RootOutcome::uncertain;
  const bool inside = where.side == Side::inside;
  const bool in_time = root.t - root.radius > 0 && root.t + root.radius < s.t_max;
  if (s.want == Want::contact_only && inside && in_time) return RootOutcome::contact;
  const SimpleRoot simple = {root.t, root.radius, root.slope, s.cubic.slope_error(), s.cubic.curvature()};
  const ContactFrame contact_frame = {m.u, m.w, m.r, s.cubic.size(), where.axis};
  switch (refine_root(s.query, simple, contact_frame, inside, s.t_max, s.exact_value, answer)) {
    case RootVerdict::contact: return RootOutcome::contact;
    case RootVerdict::outside: return RootOutcome::none;
    case RootVerdict::too_late: return RootOutcome::too_late;
    case RootVerdict::uncertain: break;
  }
  return RootOutcome::uncertain;
}

/// Decides from the cubic's roots in [low, high], of which [0, 1] is a part.
Outcome decide_over(const Search& s, double low, double high, Answer& answer) {
  const auto whole = s.cubic.variations(low, high);
  if (whole == BernsteinCubic::Variations::none) return Outcome::no_contact;
  double split[4] = {low, high};
  const int segments = whole == BernsteinCubic::Variations::one ? 1 : s.cubic.split_points(low, high, split);
  for (int i = 0; i < segments; ++i) {
    if (split[i] > s.t_max) break;
    switch (segments == 1 ? whole : s.cubic.variations(split[i], split[i + 1])) {
      case BernsteinCubic::Variations::none: continue;
      case BernsteinCubic::Variations::uncertain: return Outcome::not_isolated;
      case BernsteinCubic::Variations::one: break;
    }
    switch (decide_between(s, split[i], split[i + 1], answer)) {
      case RootOutcome::contact: return Outcome::contact;
      case RootOutcome::none: continue;
      case RootOutcome::too_late: return Outcome::no_contact;
      case RootOutcome::uncertain: return Outcome::uncertain;
      case RootOutcome::not_isolated: return Outcome::not_isolated;
    }
  }
  return Outcome::no_contact;
}

}  // namespace

Decision bracket(const Query& query, const Frame& frame, const std::array<double, 4>& coefficients, double t_max,
                 Want want, ExactValue exact_value, Answer& answer) {
  const Magnitudes m = {largest(frame.u0, frame.u1), largest(frame.w0, frame.w1), largest(frame.r0, frame.r1)};
  if (!within_range(m)) return Decision::uncertain;
  const BernsteinCubic cubic(coefficients, m.u * m.w * m.r);
  const Search search = {query, frame, m, cubic, t_max, want, exact_value};
  Outcome outcome = decide_over(search, 0, 1, answer);
  if (outcome == Outcome::not_isolated) {
    // Perhaps a root at an end of the step; a little beyond it V has a certain sign.
    outcome = decide_over(search, -BernsteinCubic::kMargin, 1 + BernsteinCubic::kMargin, answer);
  }
  return outcome == Outcome::contact      ? Decision::contact
         : outcome == Outcome::no_contact ? Decision::no_contact
                                          : Decision::uncertain;
}

}  // namespace touchstone::filters
