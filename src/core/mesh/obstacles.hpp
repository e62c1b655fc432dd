// The pairs that stand in the way of a step whose end is rounded, and the step that is left.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::mesh {

inline double next_below(double x) noexcept { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

/// The pairs that stand in the way of a step.
/// @tparam PathOf  the query of a pair on the path to the rounded end after a length: path_of(query of the whole step,
///                 length)
template <class Query, class PathOf>
class Obstacles {
 public:
  explicit Obstacles(PathOf path_of) : path_of_(std::move(path_of)) {}

  void add(const Query& query, const Separation& separation) { obstacles_.push_back({query, separation}); }

  /// Whether no obstacle is met on the path to the rounded end after this length. The last obstacle that was met is
  /// asked about first: it is often met again.
  bool let_pass(double length) {
    for (std::size_t i = 0; i < obstacles_.size(); ++i) {
      if (!is_met(obstacles_[i], length)) continue;
      std::swap(obstacles_[0], obstacles_[i]);
      return false;
    }
    return true;
  }

 private:
  struct Obstacle {
    Query query;  ///< the whole step
    Separation separation;
  };

  bool is_met(const Obstacle& obstacle, double length) const {
    SolveOptions options;
    options.separation = obstacle.separation;
    options.wanted = Wanted::contact;
    return solve(path_of_(obstacle.query, length), options).contact;
  }

  PathOf path_of_;
  std::vector<Obstacle> obstacles_;
};

/// A length <= `longest` that the obstacles let pass, and such that the next longer length that was tried is not let
/// pass. The greatest length of this sort is not sought: rounding lets lengths pass, and stops others, in no order.
template <class AnyObstacles>
double length_that_passes(AnyObstacles& obstacles, double longest) {
  if (obstacles.let_pass(longest)) return longest;
  double blocked = longest, step = longest - next_below(longest), free = 0;
  while (true) {  // it ends: at the latest where the rounded end is the start
    const double length = step < blocked / 2 ? blocked - step : blocked / 2;
    if (length == 0) return 0;
    if (obstacles.let_pass(length)) {
      free = length;
      break;
    }
    blocked = length;
    step *= 2;
  }
  while (true) {
    const double middle = free + (blocked - free) / 2;
    if (middle <= free || middle >= blocked) return free;
    (obstacles.let_pass(middle) ? free : blocked) = middle;
  }
}

/// What became of a length that the known obstacles let pass.
enum class Tried { free, blocked, no_room };

/// The length of a step that is free, or that moves nothing, when `tried` is no_room.
/// @param contact  the first contact of the whole step, with a toi
/// @param attempt  attempt(length): asks about all pairs, and adds those in the way to the obstacles
/// @param tried    becomes the last attempt's answer, free or no_room
template <class AnyObstacles, class Contact, class Attempt>
double shortened(AnyObstacles& obstacles, const Contact& contact, const Attempt& attempt, Tried& tried) {
  const double before = contact.toi < contact.toi_upper ? contact.toi : next_below(contact.toi);
  double longest = before;
  for (int attempts = 1;; ++attempts) {
    const double length = length_that_passes(obstacles, longest);
    tried = attempt(length);
    if (tried != Tried::blocked) return length;
    longest = length;
    constexpr int kPatience = 6;  // before more is given away at a time
    if (attempts >= kPatience) longest = std::max(longest / 2, before - 2 * (before - longest));
  }
}

}  // namespace touchstone::mesh
