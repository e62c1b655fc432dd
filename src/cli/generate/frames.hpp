// The frames of moving scenes, as sequences of OBJ files.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/generate/generate.hpp"

namespace touchstone::cli {

/// Writes a folder of frames for each scene. @returns the exit status
int write_frames(const GenerateOptions& options);

}  // namespace touchstone::cli
