// The output of a run: frames for ParaView, tables of its steps, and lines for people.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/followed.hpp"
#include "sim/simulation.hpp"

namespace touchstone::sim {

/// A frame as a legacy VTK file: points with their velocities, edges as lines, faces as polygons, and particles that
/// collide and are in no edge as vertices.
std::string vtk_frame(const Simulation& simulation);

/// A frame file of a series, and its time in s.
struct SeriesFrame {
  std::string name;
  double time = 0;
};

/// The index by which ParaView opens frames as a series with their times: NAME.vtk.series.
std::string vtk_series(const std::vector<SeriesFrame>& frames);

/// The columns of the proof of a substep. Those about separations are there only when an element has a radius.
std::string proof_header(const Simulation& simulation);
std::string proof_row(const Simulation& simulation, const SubstepRecord& record);

/// @param follow  whose position is in the last columns
std::string energy_header(const std::optional<Followed>& follow);
/// @param records  of the step that led to the state of the simulation; none at the start
std::string energy_row(const Simulation& simulation, const std::vector<SubstepRecord>& records,
                       const std::optional<Followed>& follow);

/// "step 12, 0.2034 s: edge 3-4 and edge 10-11 at (0.1, -0.2, 1.5) (crossing)".
std::string crossing_for_person(const Simulation& simulation, const Crossing& crossing);

/// The passes of the scene with the reasons, one a line.
std::string explain(const Simulation& simulation);

}  // namespace touchstone::sim
