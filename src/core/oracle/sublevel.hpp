// The times at which the distance D of two elements is at most a given level, and the closest points where D is the
// level. Both metrics say the same things about it: polynomials that divide time, and candidates for a closest pair.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "oracle/difference.hpp"
#include "oracle/moment.hpp"

namespace touchstone::oracle {

/// A point B + (s / unit) (X - B) + (t / unit) (Y - B) of a face of the difference polygon. It counts at a moment at
/// which `unit` is not zero, `positive` are positive and `nonnegative` are not negative, each times the sign of `unit`.
struct Candidate {
  const DifferenceFace* face;
  Polynomial unit;
  Polynomial s;
  Polynomial t;
  std::vector<Polynomial> positive;
  std::vector<Polynomial> nonnegative;
  Polynomial below;  ///< times the sign of `unit`, not negative when the point's distance is at most the level
};

/// The set of times at which D is at most the level.
struct Sublevel {
  /// Between neighbouring roots of these, D is always below the level, always equal to it or always above it.
  /// Polynomials that are identically zero are passed over.
  std::vector<Polynomial> dividing;

  /// Those of the Euclidean metric count when they are the closest point. Those of the largest-axis metric count when
  /// they are a corner of the part of the polygon that is within the level, so that none counts when D is above it.
  std::vector<Candidate> candidates;
};

/// For the Euclidean metric. The level is that of the squared distance. The polygon's positions are multiplied by the
/// scale at each time, which is positive in [0, 1]; the level is not.
Sublevel euclidean_sublevel(const DifferencePolygon& polygon, const Rational& level, const Polynomial& scale);

/// For the largest-axis metric.
Sublevel max_sublevel(const DifferencePolygon& polygon, const Rational& level, const Polynomial& scale);

/// Whether a candidate counts at a moment.
bool counts(const Candidate& candidate, const Moment& at);

/// Whether D is at most the level at a moment.
bool is_within(const Sublevel& sublevel, const Moment& at);

}  // namespace touchstone::oracle
