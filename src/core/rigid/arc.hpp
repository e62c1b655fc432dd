// A piece of a rigid motion, as straight motion with a bound on how far a body's points leave it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/curved_query.hpp>

#include "broad_phase/box.hpp"
#include "broad_phase/box_tree.hpp"

namespace touchstone::rigid {

/// A little more than the greatest distance of a point of the box from the origin.
double reach_of(const broad_phase::Box& box) noexcept;

/// The motion from one time to another one.
class Arc {
 public:
  /// @param motion  valid
  /// @param from    0 <= from <= to <= 1, multiples of 2^-20
  /// @param reach   no point of the body is farther from its origin
  /// @param off     no point of the body is farther than this from where the motion has it
  Arc(const RigidMotion& motion, double from, double to, double reach, double off = 0) noexcept;

  /// A point of the body at both ends, rounded.
  struct Ends {
    Vec3 start, end;
  };
  Ends ends_of(const Vec3& point) const noexcept;

  /// At all times a point that is within `reach` of the body's origin is no farther from the straight motion between
  /// its `ends_of`, at the same time.
  double deviation(double reach) const noexcept { return per_reach_ * reach + error_; }

  /// How far such a point may leave straight motion because the body turns: a fourth, about, for half of the duration.
  double bulge(double reach) const noexcept { return bulge_ * reach; }

  /// A moving box that holds the points in a box of the body's own frame at all times, wider by a margin >= 0.
  /// @param reach  reach_of(box), or more
  broad_phase::BoundsByAxis around(const broad_phase::Box& box, double reach, double margin) const noexcept;

 private:
  using AtBothEnds = broad_phase::BoundsByAxis::AtBothEnds;
  std::array<std::array<AtBothEnds, 3>, 3> turn_;
  std::array<AtBothEnds, 3> position_;
  double bulge_ = 2, per_reach_ = 0, error_ = 0;
  double rounding_ = 0;  // of a position
};

}  // namespace touchstone::rigid
