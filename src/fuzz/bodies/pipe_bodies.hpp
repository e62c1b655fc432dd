// A program under test that is asked about steps of whole bodies over pipes: a line of JSON for each, and one as its
// reply.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/bodies/body_steps.hpp"
#include "fuzz/processes/limits.hpp"

namespace touchstone::fuzz {

/// The line, with its line feed: {"bodies": [{"points": [[0, 0, 0], ...], "faces": [[0, 1, 2], ...], "edges": [...],
/// "loose_points": [...]}, ...], "motions": [{"q0": [1, 0, 0, 0], "p0": [0, 0, 0], "q1": [...], "p1": [...]}, ...],
/// "body_pairs": [[0, 2]], "separation": 0, "metric": "euclidean"}, and "radii": [...] of a body that has radii. The
/// decimals read back as the same doubles. All edges are there, those of faces too.
std::string bodies_line(const Bodies& bodies, const std::vector<RigidMotion>& motions);

/// The reply of a line, as read_step_reply; an element is [body, number].
BodyStepReply read_body_reply(std::string_view line);

/// As run_step_command.
BodyStepSolver run_body_command(const std::string& command_line, const Limits& limits);

}  // namespace touchstone::fuzz
