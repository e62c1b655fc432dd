// The summary that a simulation's run ends with.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/simulation.hpp"

namespace touchstone::cli {

/// Counts over all steps of a run.
struct StepTotals {
  std::uint64_t steps = 0, substeps = 0, gained = 0, first_order = 0, inaccurate = 0;
  std::uint64_t separated = 0;    ///< pairs with a separation that the proofs asked about
  double largest_separation = 0;  ///< of these, m

  void add(const std::vector<sim::SubstepRecord>& records);
};

/// Crossings, refused substeps, separations, what was checked, and "N steps, 0 crossings" with all that was left out.
/// @param run_times  lines that go in between: those of run_times_for_person, or nothing for a text that is the same for
/// every run of a scene
std::string simulation_for_person(const sim::Simulation& simulation, const StepTotals& totals,
                                  std::string_view run_times);

/// Processor time and steps a second, as they are measured. @param rate  steps a second
std::string run_times_for_person(const sim::Simulation& simulation, double rate);

}  // namespace touchstone::cli
