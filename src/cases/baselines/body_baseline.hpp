// Other people's ways to find the first contact of whole bodies that turn, written afresh to compare with. The library
// calls none of them. They ask it about bodies at rest, which is exact: what they get wrong is due to the method alone.
// Their times are not those of a planner in doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <touchstone/bodies.hpp>

#include "baselines/baseline.hpp"

namespace touchstone::baselines {

/// Bodies and their motions, one for each.
struct MovingBodies {
  Bodies bodies;
  std::vector<RigidMotion> motions;
};

/// One way to answer a step.
struct BodyBaseline {
  std::string_view name;   ///< as written in reports
  std::string_view about;  ///< one line: the idea, and what is known to fail
  Tolerance tolerance = Tolerance::none;
  double usual_tolerance = 0;      ///< what its users commonly choose
  std::vector<double> tolerances;  ///< those to compare

  /// The first contact in the whole step. The caller's floating-point environment must be the default one.
  /// @throws InvalidQuery  as touchstone::first_contact
  Result (*solve)(const MovingBodies& step, double tolerance) = nullptr;
};

/// `waypoints` and `body_advancement`.
const std::vector<BodyBaseline>& body_methods();

/// What motion planners do: poses at the times 0, `tolerance`, 2 `tolerance`, ... and 1 are asked whether bodies
/// intersect. A contact is claimed at the last one before. Bodies that meet and part again in between are missed, and
/// what is found may be late.
Result solve_waypoints(const MovingBodies& step, double tolerance);

/// Conservative advancement: B. Mirtich, "Impulse-based dynamic simulation of rigid body systems" (1996), with motion
/// bounds as in X. Zhang, M. Lee, Y. J. Kim, "Interactive continuous collision detection for non-convex polyhedra", The
/// Visual Computer 22 (2006). Steps of distance / (bound on the relative speed) until the distance is at most
/// `tolerance`; see solve_curved_advancement. Bodies within the tolerance that do not touch later are a phantom.
Result solve_body_advancement(const MovingBodies& step, double tolerance);

/// The steps of solve_body_advancement before it claims a contact at the time that it has reached.
constexpr int kBodyAdvancementSteps = 1000;

}  // namespace touchstone::baselines
