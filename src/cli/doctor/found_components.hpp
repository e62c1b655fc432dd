// What this program can use that is not in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/shared/build_facts.hpp"

namespace touchstone::cli {

/// Programs that commands start or that belong to their results, found now.
std::vector<BuildComponent> found_components();

}  // namespace touchstone::cli
