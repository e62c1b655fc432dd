// A piece of a rigid motion, as straight motion with a bound on how far a body's points leave it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

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
  /// @param reach   no point of the body is farther from its origin, or from `about`
  /// @param off     no point of the body is farther than this from where the motion has it
  /// @param about   a point of the body's frame that is taken for its origin: all places are off by the place of this
  ///                point beside the origin, as turn_together explains
  Arc(const RigidMotion& motion, double from, double to, double reach, double off = 0, const Vec3& about = {}) noexcept;

  /// A point of the body at both ends, rounded.
  struct Ends {
    Vec3 start, end;
  };
  Ends ends_of(const Vec3& point) const noexcept;

  /// A little more than the distance of a point of the body from the origin that is taken.
  double reach_of(const Vec3& point) const noexcept;

  /// At all times a point that is within `reach` of the origin that is taken is no farther from the straight motion
  /// between its `ends_of`, at the same time.
  double deviation(double reach) const noexcept { return per_reach_ * reach + error_; }

  /// How far a point of the body may be off straight motion, but for roundings: half for half of the duration, or less.
  double bulge() const noexcept { return bulge_ * reach_ + off_; }

  /// A moving box that holds the points in a box of the body's own frame at all times, wider by a margin >= 0.
  /// @param reach  reach_of(box), or more
  broad_phase::BoundsByAxis around(const broad_phase::Box& box, double reach, double margin) const noexcept;

 private:
  using AtBothEnds = broad_phase::BoundsByAxis::AtBothEnds;
  std::array<std::array<AtBothEnds, 3>, 3> turn_;
  std::array<AtBothEnds, 3> position_;
  Vec3 about_;
  double reach_, off_, bulge_ = 2, per_reach_ = 0, error_ = 0;
  double rounding_ = 0;  // of a position
};

/// The arcs of two bodies that turn together, about an origin that is far beside their widths: as seen from a frame
/// that moves with both. Places on these arcs are not those of the bodies, but differences of places of two points,
/// one of each body, are within the arcs' bounds. They are narrower than those of the arcs about the bodies' own
/// origins.
/// @param a, b          valid motions
/// @param box_a, box_b  hold all points of the bodies, in their own frames
/// @return nothing where the bodies do not turn together as far as this bound can tell
std::optional<std::array<Arc, 2>> turn_together(const RigidMotion& a, const broad_phase::Box& box_a,
                                                const RigidMotion& b, const broad_phase::Box& box_b, double from,
                                                double to) noexcept;

}  // namespace touchstone::rigid
