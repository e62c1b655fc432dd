// The command as the user typed it, for the files that say how to repeat them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace touchstone::cli {

/// Called once, before the words are parsed.
void remember_command(int argc, const char* const* argv);

/// "touchstone simulate hoop --html hoop.html", each word as a POSIX shell takes it.
const std::string& typed_command() noexcept;

}  // namespace touchstone::cli
