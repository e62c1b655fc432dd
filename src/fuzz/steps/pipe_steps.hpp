// A program under test that is asked about whole steps over pipes: a line of JSON for each, and one as its reply.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <touchstone/fuzz.hpp>

#include "fuzz/processes/limits.hpp"

namespace touchstone::fuzz {

/// The line, with its line feed: {"vertices": 4, "x0": [[0, 0, 0], ...], "x1": [...], "edges": [[0, 1], ...],
/// "faces": [...], "points": [...], "separation": 0, "metric": "euclidean"}, and for groups of vertices "groups": [0,
/// 0, 1, ...], "ignored_groups": [[0, 0]]. The decimals read back as the same doubles. All edges are there, those of
/// faces too.
std::string step_line(const Mesh& mesh, const Positions& x0, const Positions& x1);

/// The reply of a line: an object with one or more of "free": 0.5, "first_contact": 0.25 or null, and "candidates":
/// [["edge-edge", 0, 3], ["vertex-face", 7, 1], ...]. Whether the elements exist is not asked: a number above all is
/// read as the greatest one. @throws NoReply  for a line that is none, with the reason
StepReply read_step_reply(std::string_view line);

/// The program of a command line, in a process that ends with the calling thread, on which alone the function may be
/// called. One that ends, hangs or says what is no reply is started again for the next step. The function throws
/// NoReply.
/// @throws Error  when the program cannot be started
StepSolver run_step_command(const std::string& command_line, const Limits& limits);

}  // namespace touchstone::fuzz
