// The picture of a run's energies, and of its close pairs and contacts, over time.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "sim/simulation.hpp"

namespace touchstone::cli {

/// What pages and pictures plot of a step: energies at its end in joules, and numbers of pairs in it.
inline constexpr std::array<const char*, 6> kEnergyNames{"total", "kinetic", "stretch", "bend", "twist", "load"};
inline constexpr std::array<const char*, 3> kCountNames{"close", "contacts", "crossings"};
using StepValues = std::array<double, kEnergyNames.size() + kCountNames.size()>;
StepValues step_values(const sim::Simulation& simulation, const std::vector<sim::SubstepRecord>& records);

/// Takes the values of each step. Of more steps than a picture shows, every second one is left out, as often as needed;
/// the counts of those go to the next step.
class EnergiesPicture {
 public:
  /// The state is that of time, in seconds.
  void add(double time, const StepValues& values);

  /// The whole SVG file.
  std::string svg() const;

 private:
  struct Row {
    double time;
    StepValues values;
  };
  std::vector<Row> rows_;
  std::size_t stride_ = 1, since_ = 0;  ///< steps of a row; steps that the last row has
};

}  // namespace touchstone::cli
