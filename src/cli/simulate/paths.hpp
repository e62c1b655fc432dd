// Which files a simulation's run reads and writes, known before it runs.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "cli/simulate/simulate.hpp"

namespace touchstone::cli {

/// Below --out and --queries.
inline const std::filesystem::path kFrameFolder = "frames";
inline constexpr const char* kFrameIndex = "frames.vtk.series";
inline constexpr const char* kEnergies = "energies";  ///< .csv, .gp, .svg and .png
inline constexpr const char* kCandidates = "candidates.csv";
std::string frame_name(std::uint64_t step);

/// @throws Error when two outputs share a file, an output would take the place of an input, or one is a folder to
/// another
void check_paths(const SimulateOptions& options);

}  // namespace touchstone::cli
