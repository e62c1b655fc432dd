// The search for steps of whole meshes about which a function is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/fuzz.hpp>

#include "families/step_scenes.hpp"
#include "fuzz/scenes/scene_search.hpp"

namespace touchstone::fuzz {

using StepFinding = SceneFinding<families::StepScene>;

/// The step of a name, as the options want it: they may take the separation and the groups away.
families::StepScene step_of(const SceneCase& name, const StepFuzzOptions& options);

/// The search of touchstone::fuzz_steps. The families of a case are those of families::step_families().
/// @param new_solver  the function under test, for each thread of the search
/// @param a_case      this case alone
/// @param watch       in place of the options' `stop`
/// @throws InvalidQuery  for options without meaning
SceneOutcome<families::StepScene> search_steps(const std::function<StepSolver()>& new_solver,
                                               const StepFuzzOptions& options, const std::optional<SceneCase>& a_case,
                                               const SceneWatch& watch);

/// As in StepFuzzReport.
std::vector<std::string> left_out_by(const StepFuzzOptions& options);

/// A finding as the library gives it.
StepFuzzFinding finding_of(const StepFinding& finding);

/// The answers of the library: free_step, first_contact and candidates.
StepReply library_reply(const Mesh& mesh, const Positions& x0, const Positions& x1);

}  // namespace touchstone::fuzz
