// The page of a simulation's run.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/output_file.hpp"
#include "sim/simulation.hpp"
#include "view/animation.hpp"

namespace touchstone::cli {

/// Takes the frames, contacts and crossings of a run as it goes.
class SimulationAnimation {
 public:
  /// The simulation is at the first frame, and lives as long as this. @throws Error for more vertices than a page holds
  explicit SimulationAnimation(const sim::Simulation& simulation);

  /// The simulation has made a step.
  void step(const std::vector<sim::SubstepRecord>& records);

  /// @param summary  text of several lines  @returns the size in bytes
  std::uint64_t write(io::OutputFile& file, const std::string& title, const std::string& summary) const;

 private:
  void add_frame(const std::vector<sim::SubstepRecord>& records);
  void add_contacts(const sim::SubstepRecord& record);
  void add_crossing(const sim::Crossing& crossing);
  view::AnimationPair elements(const sim::Pair& pair) const;
  std::vector<double> positions() const;

  /// The names of a pair, and lines with the exact coordinates of its corners now.
  struct Words {
    std::string names, corners;
  };
  Words words_of(const sim::Pair& pair) const;

  const sim::Simulation* simulation_;
  view::Animation animation_;
  std::vector<char> told_;  ///< by pair: the list has it
  std::size_t crossings_ = 0;
};

}  // namespace touchstone::cli
