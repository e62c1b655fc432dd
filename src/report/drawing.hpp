// Files of a report on the disk: texts as a whole, and plots, drawn where there is gnuplot.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/plots.hpp"

namespace touchstone::report {

/// Makes the folder, and those that lead to it. @throws FileError
void make_folder(const std::filesystem::path& folder);

/// All of the text or, when that fails, what was there before. @throws FileError
void write_whole(const std::filesystem::path& path, const std::string& text);

/// Writes NAME.gp of every plot into `folder`, which is there, and draws NAME.svg and NAME.png; those appear when they
/// are complete. `pulse` is called with the share that is done, and may throw to end it.
/// @returns a line for the user when there is no gnuplot to draw with, or else nothing
/// @throws Error when something cannot be written, or gnuplot fails
std::string write_plots(const std::vector<Plot>& plots, const std::filesystem::path& folder,
                        const std::function<void(double share)>& pulse);

}  // namespace touchstone::report
