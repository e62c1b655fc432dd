// Runs gnuplot, if it is installed.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace touchstone::report {

/// The gnuplot that PATH finds, as an absolute path.
std::optional<std::string> find_gnuplot();

/// Runs one script in `folder`, by name and without a shell: `gnuplot -d SCRIPT`. -d keeps the user's own settings from
/// changing the plot. The output of gnuplot is not shown. @throws Error when it fails, with the last line of its output
void run_gnuplot(const std::string& gnuplot, const std::string& folder, const std::string& script);

}  // namespace touchstone::report
