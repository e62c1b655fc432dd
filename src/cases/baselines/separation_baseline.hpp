// Other people's ways to find the first time at which two elements are within a distance of each other, written afresh
// to compare with. The solver calls none of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "baselines/baseline.hpp"

namespace touchstone::baselines {

/// One way to answer a query with a separation, in the Euclidean metric.
struct SeparationBaseline {
  std::string_view name;   ///< as written in reports and on the command line
  std::string_view about;  ///< one line: the idea, and what is known to fail
  Tolerance tolerance = Tolerance::none;
  double usual_tolerance = 0;  ///< what its users commonly choose; 0 where it has none

  /// The first time in [0, t_max] at which the distance is at most `separation`. Bounded work and no crash for any
  /// finite query of any kind, 0 <= t_max <= 1, a finite separation >= 0 and any tolerance; the caller's floating-point
  /// environment must be the default one.
  Result (*solve)(const Query& query, double separation, double t_max, double tolerance) = nullptr;
};

/// `thick_advancement` and `thick_polynomial`.
const std::vector<SeparationBaseline>& separation_methods();

/// The method of that name, or null.
const SeparationBaseline* find_separation_method(std::string_view name);

/// Additive continuous collision detection with a minimum separation: M. Li, D. M. Kaufman, C. Jiang, "Codimensional
/// incremental potential contact", ACM TOG 40 (2021), algorithm 1. Steps of gap / (bound on the relative speed), until
/// the gap to the separation is below `tolerance` times the gap at the start. So its time is early, and elements that
/// come that near are phantoms. A step that rounding moves past the contact, or past t_max, loses the contact. After
/// kAdvancementSteps steps it claims a contact at the time that it has reached.
Result solve_thick_advancement(const Query& query, double separation, double t_max, double tolerance);

/// Roots of (n . r)^2 - d^2 |n|^2, of degree 6, and of the polynomials of edges and corners, of degree 4 and 2, in
/// plain doubles, each with the test that the closest points lie in the elements: as for the thickened elements of D.
/// Harmon, E. Vouga, B. Smith, R. Tamstorf, E. Grinspun, "Asynchronous contact mechanics", ACM TOG 28 (2009). It has
/// fixed slacks in place of a tolerance. A square of a determinant has twice its rounding error, so that a small
/// separation drowns in it. A double root, where the elements graze the separation, is found when rounding does not
/// lift it from zero.
Result solve_thick_polynomial(const Query& query, double separation, double t_max, double tolerance);

}  // namespace touchstone::baselines
