// The program as a function, without the set-up of the process around it.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::cli {

/// Runs the command that the arguments ask for. @returns the exit status: 0, 1 or 2, with the reason for a 2 on
/// standard error, in one line. @throws Interrupted
int run_program(int argc, const char* const* argv);

}  // namespace touchstone::cli
