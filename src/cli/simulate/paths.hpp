// The files that a simulation's run reads and writes, known before it runs.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "cli/simulate/simulate.hpp"

namespace touchstone::cli {

/// Below --out and --queries.
inline const std::filesystem::path kFrameFolder = "frames";
inline constexpr const char* kFrameIndex = "frames.vtk.series";
inline constexpr const char* kEnergies = "energies";  ///< .csv and .svg
/// "candidates.csv", and "candidates-0x1p-7.csv" for pairs that keep a distance.
std::string candidates_name(double separation);
std::string frame_name(std::uint64_t step);

/// @throws Error when two outputs are the same file, an output would replace an input, or an output is a file where
/// another needs a folder
void check_paths(const SimulateOptions& options);

}  // namespace touchstone::cli
