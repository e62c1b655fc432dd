// The summary that a simulation's run ends with.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
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

/// Crossings, refused substeps, processor time, separations, and "N steps, 0 crossings". @param rate  steps a second
std::string simulation_for_person(const sim::Simulation& simulation, const StepTotals& totals, double rate);

}  // namespace touchstone::cli
