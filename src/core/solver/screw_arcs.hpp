// A motion of constant rate, cut into rational arcs, and how far these can be from it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <touchstone/curved_query.hpp>

#include "geometry/vector.hpp"
#include "solver/contact_interval.hpp"

namespace touchstone::solver {

/// How far the position of a valid motion may be from the chord of an arc, at the same time; 0 on a straight line.
/// @param count  into how many arcs of equal duration the step is cut
double sag_of(const RigidMotion& motion, int count) noexcept;

/// The arcs of a valid query whose motions are of constant rate. There is a power of two of them, of equal duration.
class ScrewArcs {
 public:
  ScrewArcs(const CurvedQuery& query, int count);

  int count() const noexcept { return count_; }

  /// Arc i, over local times in [0, 1], as `solve` reads it.
  CurvedQuery arc(int i) const;

  /// No corner of the first element (0) or of the second (1) is farther than this from its place on the arcs.
  double deviation(std::size_t element) const noexcept;

  /// Where a corner is between two times in [0, 1], on the true motion.
  geometry::Vector<Interval> position(std::size_t corner, double from, double to) const;

 private:
  using Quaternion = std::array<double, 4>;

  /// The orientations of a body at the ends of the arcs, and how far they are from the true ones.
  struct Turn {
    std::vector<Quaternion> at;  // of length nearly 1
    std::vector<double> error;   // length of the difference
    double deviation = 0;        // a body point at the distance 1 from the origin is off by at most this
    double angle = 0;            // at least the whole angle by which the body turns
  };
  static Turn turn_of(const RigidMotion& motion, int count);

  double corner_deviation(std::size_t corner) const noexcept;
  double corner_speed(std::size_t corner) const noexcept;

  CurvedQuery query_;
  int count_;
  std::array<Turn, 4> turns_;
};

}  // namespace touchstone::solver
