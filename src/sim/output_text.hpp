// What a run writes: frames for ParaView, and tables of its steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sim/simulation.hpp"

namespace touchstone::sim {

/// A frame as a legacy VTK file: points with their velocities, edges as lines and faces as polygons.
std::string vtk_frame(const Simulation& simulation);

struct Frame {
  std::string name;
  double time = 0;
};

/// The index by which ParaView opens frames as a series with their times: NAME.vtk.series.
std::string vtk_series(const std::vector<Frame>& frames);

std::string proof_header();
std::string proof_row(const StepRecord& record);

std::string energy_header();
/// @param records  of the step that led to the simulation's state; none at the start
std::string energy_row(const Simulation& simulation, const std::vector<StepRecord>& records);

/// "step 12, 0.2034 s: edge 3-4 and edge 10-11 at (0.1, -0.2, 1.5) (crossing)".
std::string crossing_for_person(const Simulation& simulation, const Crossing& crossing);

/// Which passes the scene got, and why; one a line.
std::string explain(const Simulation& simulation);

}  // namespace touchstone::sim
