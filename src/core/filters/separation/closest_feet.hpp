// The closest points of two elements near the time when they come within a separation, as doubles tell them and as
// numbers with their bounds prove them. The elements may move along straight lines or along curves.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/separation.hpp>

#include "filters/question.hpp"
#include "filters/separation/feet.hpp"

namespace touchstone::filters {

using numbers::Bounded;
using numbers::BoundedPair;

/// Which points are the closest ones, as doubles tell.
struct Hint {
  Parameters p = {0, 0};
  Free free = Free::none;
  SignedFacet facet;    ///< in the metric max
  double distance = 0;  ///< in the lengths of the iterate
};

/// Writes that the elements are within the separation at t = 0.
/// @param course  the sign of the distance's slope
inline void name_start(int course, Answer& answer) noexcept {
  answer.nature = Nature::sustained;
  answer.trend = course < 0 ? Trend::approaching : course > 0 ? Trend::leaving : Trend::constant;
  answer.toi = answer.toi_upper = 0;
  answer.starts_within = true;
}

class ClosestFeet {
 public:
  /// @param distance  the separation's, in the lengths of the differences
  ClosestFeet(Kind kind, Metric metric, double distance) noexcept
      : kind_(kind), domain_(domain_of(kind)), metric_(metric), distance_(distance) {}

  /// From r, u and w.
  Hint hint_at(const StepAt& iterate) const noexcept;

  /// @param own_level  for the metric max: the closest points at their own distance in place of the separation
  template <class N, class Factor>
  Feet<N> feet(const Hint& hint, const PointDifferences<N, Factor>& x, bool own_level) const noexcept {
    if (metric_ == Metric::euclidean) return feet_of(domain_, hint.free, hint.p, x);
    using Value = ValueOf<N>;
    if (own_level) return feet_of<N>(domain_, hint.facet, x, nullptr);
    const LevelOf<Value> level = {value_of(x.scale) * exact_number<Value>(distance_), exact_number<Value>(1)};
    return feet_of(domain_, hint.facet, x, &level);
  }

  /// It has the sign of the distance minus the level, and is their difference, or that of their squares, times the
  /// measure.
  template <class N>
  N excess_over(const Feet<N>& feet, const N& level) const noexcept {
    return feet.gap - (metric_ == Metric::euclidean ? level * level : level) * feet.measure;
  }
  /// The same over the separation.
  template <class N, class Factor>
  N excess(const Feet<N>& feet, const Factor& scale) const noexcept {
    return excess_over(feet, scale * exact_number<N>(distance_));
  }

  /// Writes the contact's closest points. False where they are not known within 2^-51.
  bool name(const Hint& hint, const Feet<BoundedPair>& feet, Answer& answer) const noexcept;

  /// The contact of elements that seem to be within the separation at t = 0; uncertain where they may not be, or where
  /// other points may be as near.
  /// @param around, precise  their differences at t = 0
  /// @param still            whether they certainly do not move against each other
  template <class JetFactor, class PairFactor>
  Outcome starts_within(const Hint& hint, const PointDifferences<Jet, JetFactor>& around,
                        const PointDifferences<BoundedPair, PairFactor>& precise, bool still,
                        Answer& answer) const noexcept {
    const Feet<BoundedPair> exactly = feet(hint, precise, true);
    if (excess(exactly, precise.scale).sign() >= 0) return Outcome::uncertain;
    const Feet<Jet> closest = feet(hint, around, true);
    if (!certainly_closest(closest)) return Outcome::uncertain;
    // The distance, or its square, without the scale: gap / whole.
    const Jet whole =
        metric_ == Metric::euclidean ? around.scale * around.scale * closest.measure : around.scale * closest.measure;
    const int course = (closest.gap.slope * whole.value - closest.gap.value * whole.slope).sign();
    if (course == 0 && !still) return Outcome::uncertain;
    if (!name(hint, exactly, answer)) return Outcome::uncertain;
    name_start(course, answer);
    return Outcome::contact;
  }

 private:
  Kind kind_;
  Domain domain_;
  Metric metric_;
  double distance_;
};

}  // namespace touchstone::filters
