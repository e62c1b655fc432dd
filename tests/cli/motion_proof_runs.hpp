// Runs of --prove about motions, and of the checker on what they write.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "cli/run_checker.hpp"
#include "io/sha256.hpp"
#include "support/catch.hpp"

namespace touchstone::tests {

/// What touchstone-check says about a folder of --prove.
inline Run check(const TemporaryFolder& folder, const std::string& name, std::vector<std::string> options = {}) {
  options.push_back(folder.path(name + "/proofs.txt"));
  return run_checker(options, {folder.path(name + "/motion.txt")});
}

inline std::size_t count_of(const std::vector<std::string>& lines, const std::string& line) {
  return static_cast<std::size_t>(std::count(lines.begin(), lines.end(), line));
}

/// Frame `frame` of a motion: the lines of its vertices.
inline std::vector<std::string> frame_of(const std::vector<std::string>& motion, std::size_t frame) {
  auto line = motion.begin();
  for (std::size_t i = 0; i <= frame; ++i) line = std::find(line, motion.end(), "frame") + 1;
  return {line, std::find(line, motion.end(), "frame")};
}

inline Run run(std::vector<std::string> arguments, const std::vector<std::string>& more,
               const RunOptions& options = {}) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments, options);
}

/// A folder's proofs are accepted, are about its motion, and have as many steps.
inline void check_folder(const TemporaryFolder& folder, const std::string& name, std::size_t steps,
                         const std::vector<std::string>& options = {}) {
  const std::string motion_text = folder.read(name + "/motion.txt"), proofs_text = folder.read(name + "/proofs.txt");
  const auto motion = lines_of(motion_text), proofs = lines_of(proofs_text);
  CHECK(count_of(motion, "frame") == steps + 1);
  CHECK(occurrences(proofs_text, "file mesh " + io::sha256(motion_text) + " motion.txt\n") == 1);
  CHECK(occurrences(proofs_text, "\nstep ") == steps);
  const Run checked = check(folder, name, options);
  CAPTURE(checked.out, checked.err);
  CHECK(checked.status == 0);
}

inline const std::string kFirstFrame = "; not asked: whether the first frame intersects itself";

}  // namespace touchstone::tests
