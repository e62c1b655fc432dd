// The speed and the memory of simulations, with every step proved.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::report {

/// The first steps of a shipped scene.
struct SceneRun {
  std::string scene;
  std::uint64_t size = 0;   ///< as requested
  std::uint64_t edges = 0;  ///< that can collide
  std::uint64_t steps = 0;
  std::uint64_t contacts = 0;   ///< found by the narrow phase; of bodies, those that are answered
  std::uint64_t crossings = 0;  ///< found by the proofs
  double seconds = 0;           ///< of processor time, for all steps
  double collision_fraction =
      0;  ///< fraction of the time: broad and narrow phase, response and proof, but not the solver of bodies' impulses
  std::optional<std::uint64_t> memory;  ///< bytes, of run_in_own_process; includes making the scene

  double seconds_per_step() const noexcept { return seconds / static_cast<double>(steps); }
};

/// One scene at several sizes, ascending, for the same span of time.
using SceneSeries = std::vector<SceneRun>;

/// p of time per step ~ edges^p between the smallest of the series and the largest.
double exponent(const SceneSeries& series);

struct SceneRuns {
  SceneRun hoop;
  SceneSeries cable_drop, whip, twist, link_chain;
};

/// Called before each step with the fraction of all work that is done.
using ScenePulse = std::function<void(double fraction)>;

/// Runs them one after another, each in a process of its own and on one thread. About a minute and a quarter, or a
/// second when quick.
SceneRuns run_scenes(bool quick, const ScenePulse& pulse);

/// simulation.csv: a header and a row for each run.
std::string scene_runs_csv(const SceneRuns& runs, bool quick);

/// The section of report.md.
std::string scene_runs_section(const SceneRuns& runs);

}  // namespace touchstone::report
