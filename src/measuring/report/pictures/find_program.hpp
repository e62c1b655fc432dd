// Programs that others start.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace touchstone::report {

/// The program of this name that PATH finds, as an absolute path.
std::optional<std::string> find_program(const std::string& name);

}  // namespace touchstone::report
