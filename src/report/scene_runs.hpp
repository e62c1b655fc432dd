// How fast scenes are simulated, every step proved.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace touchstone::report {

/// The first steps of a shipped scene.
struct SceneRun {
  std::string scene;
  std::uint64_t size = 0;   ///< what was asked for
  std::uint64_t edges = 0;  ///< that can collide
  std::uint64_t steps = 0;
  std::uint64_t contacts = 0;   ///< found by the narrow phase
  std::uint64_t crossings = 0;  ///< found by the proofs
  double seconds = 0;           ///< of processor time, for all steps
  double collision_share = 0;   ///< of it: broad and narrow phase, response and proof

  double seconds_per_step() const noexcept { return seconds / static_cast<double>(steps); }
};

struct SceneRuns {
  SceneRun hoop;
  std::vector<SceneRun> cable_drop;  ///< ascending in size

  /// p of time per step ~ edges^p between the smallest cable-drop and the largest.
  double exponent() const;
};

/// Runs them one after another on one thread; calls `pulse` before each step. Some ten seconds, or one when quick.
SceneRuns run_scenes(bool quick, const std::function<void()>& pulse);

/// simulation.csv: a header and a row for each run.
std::string scene_runs_csv(const SceneRuns& runs, bool quick);

/// The section of report.md.
std::string scene_runs_section(const SceneRuns& runs);

}  // namespace touchstone::report
