// What `touchstone bodies` writes: the verdict, the steps that are not free, lines of JSON, and poses of free steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/bodies.hpp>

#include "cli/bodies/bodies.hpp"
#include "cli/bodies/body_files.hpp"
#include "cli/bodies/pose_file.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {

/// "0.1 -> 0.2": the step that begins at this time.
std::string step_label(const RecordedPoses& poses, std::size_t step);

class BodyResults {
 public:
  /// Opens the files, so that one that cannot be written is found before the run. @throws FileError
  BodyResults(const BodiesRunOptions& options, BodyFiles& files, const RecordedPoses& poses);

  /// The least distance at the next recorded time. Those of a step's ends come before the step.
  void add_clearance(const BodyDistance& found);

  /// How many bodies turn in a step as only the signs of their recorded quaternions say.
  struct Turns {
    std::size_t longer = 0;  ///< the longer one of two turns
    std::size_t half = 0;    ///< one of two turns by 180 degrees
  };

  /// The next step. Its first contact is all that counts without --free-step.
  void add(const FreeBodyStep& step, const Turns& turns);

  /// The next step, of turns at a constant rate.
  void add(const BodyScrewAnswer& found, const Turns& turns);

  /// What was found, and all that it leaves out: a line.
  std::string verdict() const;

  /// Writes the verdict and what belongs to it. @param more  lines for its end  @returns whether every step is free
  bool finish(const std::string& more);

 private:
  void write_poses(const FreeBodyStep& step);
  /// @param first     what the verdict says where the step is the first that is not free, before the time
  /// @param fraction  that time, in the step
  template <class Found>
  void count(const Found& found, const Turns& turns, const char* first, double fraction);

  std::string lines_of(const FirstBodyContact& found) const;
  std::string lines_of(const BodyScrewAnswer& found) const;
  std::string start_lines(const std::vector<BodyIntersection>& found, const std::string& indent) const;

  std::string json_of(const FirstBodyContact& found, const Turns& turns) const;
  std::string json_of(const BodyScrewAnswer& found, const Turns& turns) const;
  template <class Found>
  std::string json_head(const Found& found, const Turns& turns) const;
  std::vector<std::string> left_out() const;

  std::vector<sequence::RestContact> named(const std::vector<BodyIntersection>& found) const;

  const BodiesRunOptions& options_;
  BodyFiles& files_;
  const RecordedPoses& poses_;
  io::OutputFile console_;
  std::optional<io::OutputFile> free_step_;

  std::vector<double> clearances_;  ///< by time
  std::string nearest_;             ///< what is said of the least of them in the verdict
  std::size_t steps_ = 0, free_ = 0, open_ = 0;
  std::size_t shown_ = 0;  ///< of the steps that are not free
  std::string lines_;      ///< of those
  std::string first_;      ///< what is said of the first of them in the verdict
  Turns turns_;
  std::size_t excluded_ = 0;                 ///< pairs of bodies
  std::size_t in_open_ = 0, cancelled_ = 0;  ///< the most of a start, as in FirstBodyContact
};

}  // namespace touchstone::cli
