// The files that a simulation's run writes.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/shared/new_folders.hpp"
#include "cli/shared/proofs/motion_proofs.hpp"
#include "cli/simulate/energies_picture.hpp"
#include "cli/simulate/simulate.hpp"
#include "cli/simulate/simulation_animation.hpp"
#include "io/output_file.hpp"
#include "sim/output_text.hpp"

namespace touchstone::cli {

/// Tables appear whole at the end, also after a run that failed. Frames appear as they are made.
class SimulateOutput {
 public:
  SimulateOutput(const SimulateOptions& options, sim::Simulation& simulation);

  void step(const std::vector<sim::SubstepRecord>& records);

  /// Writes all files. @param summary  of the run, for the page of --html: nothing in it is measured, so
  /// that two runs of a scene write the same page
  /// @throws Error for the first file that cannot be written, after the others
  void finish(const std::string& summary);

  /// The same for a run that ends early, up to the last step that was taken.
  void finish_early();

  /// The proofs of --prove and what they leave out, after finish(); empty without them.
  std::string proofs_summary() const;

  /// A line about the page of --html, after finish(); empty without it.
  std::string page_summary() const;

  /// Whether the proofs have no contact; true without them.
  bool proved_free() const { return !motion_ || motion_->contacts() == 0; }

  SimulateOutput(const SimulateOutput&) = delete;
  SimulateOutput& operator=(const SimulateOutput&) = delete;

 private:
  void write_frame();
  void write_query(const Query& query, double separation, const Answer& answer);

  const SimulateOptions* options_;
  sim::Simulation* simulation_;
  NewFolders folders_;
  std::filesystem::path frames_;
  std::vector<sim::SeriesFrame> written_;
  std::optional<MotionProofs> motion_;
  std::optional<io::OutputFile> page_;
  std::optional<SimulationAnimation> animation_;
  std::uint64_t page_size_ = 0;
  std::optional<io::OutputFile> proof_, frame_index_, checkpoint_;
  std::optional<io::OutputFile> picture_;  ///< energies.svg
  EnergiesPicture drawn_;
  std::vector<std::optional<io::OutputFile>> energies_;
  std::map<std::pair<Kind, double>, std::optional<io::OutputFile>> queries_;  // by kind and separation
  std::uint64_t steps_ = 0, since_frame_ = 0;
};

}  // namespace touchstone::cli
