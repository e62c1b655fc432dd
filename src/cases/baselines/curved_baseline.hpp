// Other people's ways to find the first contact of elements that turn or move on curves, written afresh to compare
// with. The solver calls none of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <touchstone/curved_query.hpp>

#include "baselines/baseline.hpp"

namespace touchstone::baselines {

/// One way to answer a curved query.
struct CurvedBaseline {
  std::string_view name;   ///< as written in reports and on the command line
  std::string_view about;  ///< one line: the idea, and what is known to fail
  Tolerance tolerance = Tolerance::none;
  double usual_tolerance = 0;  ///< what its users commonly choose

  /// Whether it takes queries of this kind.
  bool (*supports)(Kind) = nullptr;

  /// The first contact for t in [0, t_max]. Bounded work and no crash for any valid query, 0 <= t_max <= 1 and any
  /// tolerance; the caller's floating-point environment must be the default one.
  /// @throws InvalidQuery  for a kind that it does not support
  Result (*solve)(const CurvedQuery& query, double t_max, double tolerance) = nullptr;
};

/// `redon` and `curved_advancement`.
const std::vector<CurvedBaseline>& curved_methods();

/// The method of that name, or null.
const CurvedBaseline* find_curved_method(std::string_view name);

/// The interval method: S. Redon, A. Kheddar, S. Coquillart, "Fast continuous collision detection between rigid
/// bodies", Computer Graphics Forum 21 (2002). An interval of time is halved, the earlier half first, as long as
/// interval arithmetic neither excludes a zero of V nor puts the meeting point of the lines, or of line and plane,
/// outside an element. When it is no longer than `tolerance`, the meeting point at its middle is computed in doubles.
/// Inside both elements, within kRedonSlack of their size, it is a contact at the interval's start. The motion is the
/// query's own, not the paper's screw. As in common implementations, interval arithmetic is in plain doubles, not
/// rounded outwards. Parallel edges and flat faces have no meeting point, so that such contacts are missed, and so are
/// grazing ones that rounding lifts from zero. A V that comes near zero is a phantom. After kRedonIntervals intervals,
/// it claims a contact at the earliest time that is left: a V that vanishes identically comes to that.
/// Edge-edge and vertex-face.
Result solve_redon(const CurvedQuery& query, double t_max, double tolerance);

/// Conservative advancement: B. Mirtich, "Impulse-based dynamic simulation of rigid body systems" (1996), with motion
/// bounds as in X. Zhang, M. Lee, Y. J. Kim, "Interactive continuous collision detection for non-convex polyhedra", The
/// Visual Computer 22 (2006). Steps of distance / (bound on the relative speed) until the distance is at most
/// `tolerance`. The bound for two bodies is |difference of their velocities| + angular speed times radius of each, the
/// angular speed being the greatest of the step. Elements within the tolerance that do not touch later are a phantom. A
/// step that rounding moves past the contact, or past t_max, loses it. After kCurvedAdvancementSteps steps it claims a
/// contact at the time that it has reached. Edge-edge and vertex-face.
Result solve_curved_advancement(const CurvedQuery& query, double t_max, double tolerance);

/// See solve_redon: the fraction of an element by which a meeting point may lie outside of it.
constexpr double kRedonSlack = 1e-6;

/// See solve_redon.
constexpr int kRedonIntervals = 1 << 16;

/// See solve_curved_advancement.
constexpr int kCurvedAdvancementSteps = 1000;

}  // namespace touchstone::baselines
