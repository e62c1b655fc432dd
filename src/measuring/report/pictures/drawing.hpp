// The files of a report: texts, each written as a whole, and plots, drawn when gnuplot is installed.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/pictures/plots.hpp"

namespace touchstone::report {

/// Makes the folder and its missing parents. @throws FileError
void make_folder(const std::filesystem::path& folder);

/// Writes all of the text; when that fails, the old file stays. @throws FileError
void write_whole(const std::filesystem::path& path, const std::string& text);

/// Writes NAME.gp of every plot into `folder`, which exists, and draws NAME.svg and NAME.png, which appear when they
/// are complete. `pulse` is called with the fraction that is done, and may throw to end the drawing.
/// @returns a line for the user when there is no gnuplot to draw with, or else nothing
/// @throws Error when something cannot be written, or gnuplot fails
std::string write_plots(const std::vector<Plot>& plots, const std::filesystem::path& folder,
                        const std::function<void(double fraction)>& pulse);

}  // namespace touchstone::report
