// Other people's ways to find the first contact, written afresh to compare with. The solver calls none of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

namespace touchstone::baselines {

/// The answer of a method to one query. No guarantee comes with it: each method's `about` names its known faults.
struct Result {
  bool contact = false;
  double toi = std::numeric_limits<double>::infinity();  ///< in [0, t_max]; +infinity without contact
};

/// The quantity that a method's tolerance measures.
enum class Tolerance : std::uint8_t {
  none,    ///< it has none, and ignores the argument
  length,  ///< a distance between the elements, in the unit of the coordinates
  share    ///< a dimensionless fraction: of the step for times, of an element for weights
};

/// One way to answer a query.
struct Method {
  std::string_view name;   ///< as written in reports and on the command line
  std::string_view about;  ///< one line: the idea, and what is known to fail
  Tolerance tolerance = Tolerance::none;
  double usual_tolerance = 0;  ///< what its users commonly choose; 0 where it has none

  /// Whether it takes queries of this kind.
  bool (*supports)(Kind) = nullptr;

  /// The first contact for t in [0, t_max]. Bounded work and no crash for any finite query, 0 <= t_max <= 1 and any
  /// tolerance; the caller's floating-point environment must be the default one.
  /// @throws InvalidQuery  for a kind that it does not support
  Result (*solve)(const Query& query, double t_max, double tolerance) = nullptr;

  bool has_tolerance() const noexcept { return tolerance != Tolerance::none; }
};

/// Every method of this layer: `paper`, `closed_form`, `newton`, `interval`, `conservative_advancement`.
const std::vector<Method>& methods();

/// The method of that name, or null.
const Method* find_method(std::string_view name);

/// The paper's sections 3.2 to 3.4 as printed: the cubic by Cardano's formulas, then two of the three equations (27).
/// Edge-edge, and vertex-face in the same spirit. Loses contacts wherever V vanishes identically, has a double root, or
/// the elements are parallel at contact, and those whose time or weights round to the wrong side of 0 or 1.
Result solve_paper(const Query& query, double t_max, double tolerance);

/// The same idea with the care that doubles allow: scaling, relative degree tests, polished roots, robust projections,
/// coplanar and degenerate cases. Fixed slacks in place of a tolerance: near misses within them are phantoms, contacts
/// that rounding moves beyond them are missed, and its toi may be late by some ulps.
Result solve_closed_form(const Query& query, double t_max, double tolerance);

/// V's roots by bracketed Newton steps between its critical points, to `tolerance` in time; inside tests with the same
/// fraction of slack. Near misses within it are phantoms. The position at a time that is off by the tolerance may be
/// off by more than that fraction of a short edge, so small fast elements are missed.
Result solve_newton(const Query& query, double t_max, double tolerance);

/// Bisection of (time, weights), earliest time first, keeping each box whose image may contain the origin, until an
/// image is smaller than `tolerance`: B. Wang, Z. Ferguson, T. Schneider, X. Jiang, M. Attene, D. Panozzo, "A
/// large-scale benchmark and an inclusion-based algorithm for continuous collision detection", ACM TOG 40 (2021).
/// Conservative: misses nothing and its toi is never late. Elements that pass within the tolerance are phantoms, and so
/// are all that are not settled after kIntervalSteps boxes.
Result solve_interval(const Query& query, double t_max, double tolerance);

/// Steps of distance / (bound on the relative speed) until the distance is at most `tolerance`: B. Mirtich,
/// "Impulse-based dynamic simulation of rigid body systems" (1996). Contact within the tolerance is a phantom where
/// none follows. A rounded step past the contact, or past t_max, loses it; after kAdvancementSteps steps it says
/// contact where it stands.
Result solve_conservative_advancement(const Query& query, double t_max, double tolerance);

/// Boxes that `interval` looks at before it gives up and says contact at the earliest time left.
constexpr int kIntervalSteps = 1 << 16;

/// Steps of `conservative_advancement` before it gives up and says contact at the time it has reached.
constexpr int kAdvancementSteps = 10000;

}  // namespace touchstone::baselines
