// The walk to an entry in doubles, for either metric: directions that keep the elements apart, one piece of the step
// after the other. See entry.cpp for the method.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <touchstone/separation.hpp>

#include "filters/question.hpp"
#include "filters/separation/entry_step.hpp"

namespace touchstone::filters {

// Errors in doubles, e = 2^-53. Let N, R, U, W be the largest absolute coordinates of n and of the computed r, u, w
// over both ends, S = R + U + W. A dot product n . r: coordinates of r are off by e each, products by e, two sums by 2
// e: 4 e times 3 N R, likewise for u and w: 12 e N S for all three. Their sums r - s u - q w at a corner, at most 3 N
// S: two additions, 6 e N S. Between the ends, (1 - t) g0 + t g1: 3 roundings of at most 3 N S: 9 e N S. In all 27 e N
// S to first order. The rest covers a direction whose own coordinates are off by e, another 3 e N S, and second-order
// terms.
constexpr double kWalkError = 32 * kUnit;

// The same for a position between the ends: its coordinates are off by 4 e S, which makes 12 e N S more, and the sum of
// two such products by 3 e (3 N S) of each. Less than 48 e N S for each product.
constexpr double kTurnError = 48 * kUnit;

// The product d |n|: 3.5 e for the norm, 1 e for the product, and the sum with the error.
constexpr double kNormIncrease = 1 + 8 * kUnit;

/// The norm of a direction that a distance is to be multiplied by: n . c <= |c| |n| for every c.
inline double dual_norm(const Vector& n, Metric metric) noexcept {
  if (metric == Metric::euclidean) return std::sqrt(dot(n, n));
  return (std::fabs(n[0]) + std::fabs(n[1])) + std::fabs(n[2]);
}

/// A direction, and the least n . c over the corners as a function of time.
class Direction {
 public:
  Direction(const Step& step, const Vector& n, const Separation& separation) noexcept : domain_(step.domain) {
    for (int end = 0; end < 2; ++end) {
      r_[end] = dot(n, step.r[end]);
      u_[end] = dot(n, step.u[end]);
      w_[end] = dot(n, step.w[end]);
    }
    error_ = kWalkError * largest_of(n) * step.size;
    // The squares of a much shorter direction may underflow. No c that is as long as the separation is so short.
    const bool is_long = separation.metric != Metric::euclidean || largest_of(n) >= 0.5 * kLeastFraction * step.size;
    bound_ = is_long ? kNormIncrease * (separation.distance * dual_norm(n, separation.metric) + error_) : kNever;
  }

  /// The least n . c, off by at most `error`.
  double least_at(double t) const noexcept {
    const double s = 1 - t;
    return (s * r_[0] + t * r_[1]) - greatest_at_corners(domain_, s * u_[0] + t * u_[1], s * w_[0] + t * w_[1]);
  }
  /// Whether every n . c is certainly greater than d |n| at t.
  bool clear_at(double t) const noexcept { return least_at(t) > bound_; }

  /// About the last time after t up to which the direction keeps the elements apart; greater than 1 when it is none.
  double last_clear_after(double t) const noexcept {
    const double goal = bound_ + 4 * error_;
    double last = 2;
    const auto corner = [&](double s, double q) {
      const double start = (r_[0] - s * u_[0]) - q * w_[0];
      const double slope = (r_[1] - s * u_[1]) - q * w_[1] - start;
      const double value = start + t * slope;
      if (slope < 0) last = std::min(last, t + (value - goal) / -slope);
    };
    corner(0, 0);
    if (domain_ != Domain::point) corner(1, 0);
    if (domain_ == Domain::square || domain_ == Domain::triangle) corner(0, 1);
    if (domain_ == Domain::square) corner(1, 1);
    return last;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  Domain domain_;
  double r_[2], u_[2], w_[2];
  double error_, bound_;
};

/// The step at a time, in doubles.
struct StepAt {
  double t;
  Vector r, u, w;
  Vector n;      ///< about the direction that keeps the elements farthest apart
  double until;  ///< about the time until the entry; infinite when the distance does not fall
};

/// The iterate at t, without direction.
inline StepAt bare_iterate(const Step& step, double t) noexcept {
  return {
      t,  between(step.r[0], step.r[1], t),       between(step.u[0], step.u[1], t), between(step.w[0], step.w[1], t),
      {}, std::numeric_limits<double>::infinity()};
}

/// Whether a direction that turns from one iterate's to the other's keeps the elements apart between them, if each does
/// so at its own time.
inline bool turns_clear(const Step& step, const StepAt& a, const StepAt& b, const Separation& separation) noexcept {
  const double least = (dot(a.n, b.r) + dot(b.n, a.r)) -
                       greatest_at_corners(step.domain, dot(a.n, b.u) + dot(b.n, a.u), dot(a.n, b.w) + dot(b.n, a.w));
  const double norms = dual_norm(a.n, separation.metric) + dual_norm(b.n, separation.metric);
  const double error = kTurnError * (largest_of(a.n) + largest_of(b.n)) * step.size;
  return least > kNormIncrease * (separation.distance * norms + error);
}

/// Whether the elements are apart between an iterate, where its own direction may show it, and a later time, where n
/// does. n may be off by a rounding in each coordinate from a direction for which that is known.
inline bool stays_clear(const Step& step, const StepAt& from, double t, const Vector& n,
                        const Separation& separation) noexcept {
  if (Direction(step, n, separation).clear_at(from.t)) return true;
  StepAt there = bare_iterate(step, t);
  there.n = n;
  return Direction(step, from.n, separation).clear_at(from.t) && turns_clear(step, from, there, separation);
}

/// The start, with the time that Newton's method finds for the entry as `until`; infinite when it finds none in [0,
/// t_max]. Nothing is proved. Where one direction keeps the elements apart from the start to the entry, no walk is
/// needed.
template <class IterateAt>
StepAt jump(double t_max, const IterateAt& iterate_at) noexcept {
  constexpr int kMostSteps = 5;
  constexpr double kNear = 0x1p-24;  // another step of Newton's method is as good as doubles are
  StepAt start = iterate_at(0);
  double t = start.until;
  start.until = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps && t >= 0 && t <= t_max; ++i) {
    const double rest = iterate_at(t).until;
    t += rest;
    if (std::fabs(rest) < kNear) {
      start.until = t;
      break;
    }
  }
  return start;
}

/// How a walk ends.
enum class WalkEnd : std::uint8_t {
  clear,  ///< the elements are apart in all of [0, t_max]
  near,   ///< they are apart up to the iterate, and perhaps enter soon after it
  start,  ///< they are perhaps within the separation at t = 0, the iterate's time
  lost    ///< nothing is known
};

struct Walk {
  WalkEnd end;
  StepAt iterate;
};

/// Walks from t = 0 towards the entry.
/// @param iterate_at  gives the iterate at a time, with its direction
template <class IterateAt>
Walk walk(const Step& step, const Separation& separation, double t_max, const IterateAt& iterate_at) noexcept {
  constexpr int kMostPieces = 24;
  constexpr double kShortPiece = 0x1p-24;  // Newton's step from so near is as good as doubles are
  StepAt here = iterate_at(0);             // the elements are apart up to here
  for (int piece = 0; piece < kMostPieces; ++piece) {
    const Direction direction(step, here.n, separation);
    if (!direction.clear_at(here.t)) return {piece == 0 ? WalkEnd::start : WalkEnd::near, here};
    double next = direction.last_clear_after(here.t);
    const bool whole = next > t_max;
    if (whole) next = t_max;
    const bool clear = next > here.t && direction.clear_at(next);
    if (whole && clear) return {WalkEnd::clear, here};
    if (here.until < kShortPiece) return {WalkEnd::near, here};
    if (clear && next - here.t > 0.5 * here.until) {
      here = iterate_at(next);
      continue;
    }
    // Elements that turn: so must the direction.
    const StepAt there = iterate_at(std::min(here.t + 0.75 * here.until, t_max));
    if (there.t > here.t && Direction(step, there.n, separation).clear_at(there.t) &&
        turns_clear(step, here, there, separation)) {
      if (there.t == t_max) return {WalkEnd::clear, here};
      here = there;
    } else if (clear) {
      here = iterate_at(next);
    } else {
      return {WalkEnd::lost, here};
    }
  }
  return {WalkEnd::lost, here};
}

/// Decides by Newton's jump or, where that is not enough, by the walk.
/// @param iterate_at       as above
/// @param enter          the finding about an entry soon after an iterate, up to which the elements count as apart
/// @param starts_within  the finding about elements that are perhaps within the separation at the iterate's time, t = 0
template <class IterateAt, class Enter, class StartsWithin>
Outcome decide_by_walk(const Step& step, const Separation& separation, double t_max, const IterateAt& iterate_at,
                       const Enter& enter, const StartsWithin& starts_within) noexcept {
  if (!of_ordinary_size(step, separation.distance)) return Outcome::uncertain;
  const Outcome jumped = enter(jump(t_max, iterate_at));
  if (jumped != Outcome::uncertain) return jumped;
  const Walk walked = walk(step, separation, t_max, iterate_at);
  switch (walked.end) {
    case WalkEnd::clear: return Outcome::no_contact;
    case WalkEnd::near: return enter(walked.iterate);
    case WalkEnd::start: return starts_within(walked.iterate);
    case WalkEnd::lost: break;
  }
  return Outcome::uncertain;
}

}  // namespace touchstone::filters
