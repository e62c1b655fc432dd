// The search for scenes of whole bodies about which a function is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/bodies/judge_bodies.hpp"

namespace touchstone::fuzz {

using BodyFinding = SceneFinding<families::BodyScene>;
using BodyFuzzOutcome = SceneOutcome<families::BodyScene>;

/// The names of families::kEveryBodyFamily.
std::vector<std::string_view> body_families();

/// Scenes of bodies for a search. @param make  of a case, whose families are body_families()
/// @param new_judge  for each thread
SceneSort<families::BodyScene> body_scenes(std::function<families::BodyScene(const SceneCase&)> make,
                                           std::function<SceneJudge<families::BodyScene>()> new_judge);

/// A finding for a person: the failure, the bodies, their motions and the name of the case.
std::string to_string(const BodyFinding& finding);

/// What the options leave out of the search, in words as of fuzz::left_out_by.
std::vector<std::string> left_out_of_bodies(const StepFuzzOptions& options);

/// Asks about scenes of every family in turn. The solver is called on several threads at a time.
BodyFuzzOutcome fuzz_bodies(const BodySolver& solver, const SceneSettings& settings, const SceneWatch& watch = {});

}  // namespace touchstone::fuzz
