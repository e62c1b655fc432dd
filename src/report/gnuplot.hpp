// Runs gnuplot, where it is installed.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace touchstone::report {

/// Where PATH finds it, as an absolute path.
std::optional<std::string> find_gnuplot();

/// Runs one script in `folder`, by name and without a shell: `gnuplot -d SCRIPT`, -d so that nobody's own settings
/// change the plot. Nothing that gnuplot prints is shown. @throws Error when it does not end well, with its last words
void run_gnuplot(const std::string& gnuplot, const std::string& folder, const std::string& script);

}  // namespace touchstone::report
