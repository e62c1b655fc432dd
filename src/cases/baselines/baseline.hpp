// Other people's ways to find the first contact, written afresh to compare with. The solver calls none of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

namespace touchstone::baselines {

/// A method's answer to one query. It has no guarantee: the method's `about` says where it is known to be wrong.
struct Result {
  bool contact = false;
  double toi = std::numeric_limits<double>::infinity();  ///< in [0, t_max]; +infinity without contact
};

/// The quantity that a method's tolerance measures.
enum class Tolerance : std::uint8_t {
  none,     ///< it has none, and ignores the argument
  length,   ///< a distance between the elements, in the unit of the coordinates
  fraction  ///< a dimensionless fraction: of the step for times, of an element for weights
};

/// The kinds whose corners must be coplanar to touch.
inline bool coplanar_kinds(Kind kind) { return kind == Kind::edge_edge || kind == Kind::vertex_face; }

/// One way to answer a query.
struct Baseline {
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
const std::vector<Baseline>& methods();

/// The method of that name, or null.
const Baseline* find_method(std::string_view name);

/// The paper's sections 3.2 to 3.4 as printed: the cubic by Cardano's formulas, then two of the three equations (27).
/// Edge-edge, and vertex-face in the same spirit. It loses contacts where V is identically zero or has a double root,
/// and where the elements are parallel at contact. It also loses contacts whose time or weights round to the wrong side
/// of 0 or 1.
Result solve_paper(const Query& query, double t_max, double tolerance);

/// The same idea with the care that doubles allow: scaling, relative degree tests, polished roots, robust projections,
/// coplanar and degenerate cases. It has fixed slacks in place of a tolerance. Near misses within them are phantoms.
/// Contacts that rounding moves beyond them are missed. Its toi may be late by some ulps.
Result solve_closed_form(const Query& query, double t_max, double tolerance);

/// V's roots by bracketed Newton steps between its critical points, to `tolerance` in time; the inside tests have the
/// same slack, as a fraction of the element. Near misses within it are phantoms. Where the time is off by the
/// tolerance, the position may be off by more than that fraction of a short edge. So small fast elements are missed.
Result solve_newton(const Query& query, double t_max, double tolerance);

/// Bisection of (time, weights), earliest time first, keeping each box whose image may contain the origin, until an
/// image is smaller than `tolerance`: B. Wang, Z. Ferguson, T. Schneider, X. Jiang, M. Attene, D. Panozzo, "A
/// large-scale benchmark and an inclusion-based algorithm for continuous collision detection", ACM TOG 40 (2021). It is
/// conservative: it misses no contact, and its toi is never late. Elements that pass within the tolerance are phantoms.
/// So are elements that are undecided after kIntervalSteps boxes.
Result solve_interval(const Query& query, double t_max, double tolerance);

/// Steps of distance / (bound on the relative speed) until the distance is at most `tolerance`: B. Mirtich,
/// "Impulse-based dynamic simulation of rigid body systems" (1996). Elements within the tolerance that do not touch
/// later are a phantom. A step that rounding moves past the contact, or past t_max, loses the contact. After
/// kAdvancementSteps steps it claims a contact at the time that it has reached.
Result solve_conservative_advancement(const Query& query, double t_max, double tolerance);

/// The number of boxes that `interval` examines before it claims a contact at the earliest time left.
constexpr int kIntervalSteps = 1 << 16;

/// The number of steps of `conservative_advancement` before it claims a contact at the time that it has reached.
constexpr int kAdvancementSteps = 10000;

}  // namespace touchstone::baselines
