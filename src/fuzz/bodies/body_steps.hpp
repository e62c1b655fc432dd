// The search for steps of whole bodies about which a program under test is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <touchstone/bodies.hpp>
#include <touchstone/fuzz.hpp>

#include "families/body_scenes.hpp"
#include "fuzz/scenes/scene_search.hpp"

namespace touchstone::fuzz {

/// StepReply, about bodies: contacts alone, not whether a body starts inside another one.
struct BodyStepReply {
  std::optional<double> free, first_contact;
  std::optional<std::vector<BodyPair>> candidates;
};

/// The function under test.
using BodyStepSolver = std::function<BodyStepReply(const Bodies&, const std::vector<RigidMotion>&)>;

/// The answers of the library: free_step, first_contact and candidates.
BodyStepReply library_step_reply(const Bodies& bodies, const std::vector<RigidMotion>& motions);

/// The step of a name, as the options want it: without separations there are no radii either, and without groups no
/// pairs of bodies that never collide.
families::BodyScene body_step_of(const SceneCase& name, const StepFuzzOptions& options);

/// Asks, and compares with exact_contacts.
/// @return nothing when all of it is right
/// @throws InvalidQuery, InvalidMesh  for a scene without meaning
std::optional<SceneFailure> judge_body_step(const families::BodyScene& scene, const BodyStepSolver& solver,
                                            const StepFuzzOptions& options);

/// The families of a case are body_families().
/// @param new_solver  the function under test, for each thread of the search
/// @param a_case      this case alone
/// @param watch       in place of the options' `stop`
/// @throws InvalidQuery  for options without meaning
SceneOutcome<families::BodyScene> search_body_steps(const std::function<BodyStepSolver()>& new_solver,
                                                    const StepFuzzOptions& options,
                                                    const std::optional<SceneCase>& a_case, const SceneWatch& watch);

}  // namespace touchstone::fuzz
