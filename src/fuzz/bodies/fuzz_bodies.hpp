// The search for scenes of whole bodies about which a function is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/bodies/judge_bodies.hpp"

namespace touchstone::fuzz {

using BodyFinding = SceneFinding<families::BodyScene>;
using BodyFuzzOutcome = SceneOutcome<families::BodyScene>;

/// The names of families::kEveryBodyFamily.
std::vector<std::string_view> body_families();

/// A finding for a person: the failure, the bodies and their motions.
std::string to_string(const BodyFinding& finding);

/// Asks about scenes of every family in turn. The solver is called on several threads at a time.
BodyFuzzOutcome fuzz_bodies(const BodySolver& solver, const SceneSettings& settings, const SceneWatch& watch = {});

}  // namespace touchstone::fuzz
