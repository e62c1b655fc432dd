// `touchstone simulate`: particles, springs and cables that collide, with a proof of each step.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/shared/command_line/command.hpp"
#include "contact/narrow_phase.hpp"
#include "scene/scene.hpp"
#include "sim/followed.hpp"

namespace touchstone::cli {

struct SimulateOptions {
  std::string scene;  ///< a shipped scene's name or a file; empty with `resume`
  std::optional<std::uint32_t> size;
  std::optional<std::uint64_t> steps;          ///< how many to make; nothing: to the scene's duration
  std::string out;                             ///< a folder for frames, tables and plots
  std::optional<double> time_step, tolerance;  ///< in place of the scene's
  std::optional<sim::Integrator> integrator;
  std::optional<sim::Followed> follow;  ///< whose positions are in the table of energies
  std::uint64_t frame_every = 2;        ///< steps
  std::string html;                     ///< the page to write; empty: none
  std::string proof, prove, energies, queries, checkpoint, resume, scene_out;
  bool explain = false;
  sim::NarrowPhase narrow_phase = sim::NarrowPhase::exact;
  int threads = 1;
};

int run_simulate(const SimulateOptions& options);
void add_simulate(CLI::App& program, Command& command);

}  // namespace touchstone::cli
