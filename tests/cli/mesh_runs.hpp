// Runs of touchstone mesh, and what they are about.
// SPDX-License-Identifier: MIT
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

namespace touchstone::tests {

inline Run mesh(std::vector<std::string> arguments, const RunOptions& options = {}) {
  arguments.insert(arguments.begin(), "mesh");
  return run_program(arguments, options);
}

inline std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// The last line.
inline std::string verdict(const Run& run) { return run.out.empty() ? std::string() : lines_of(run.out).back(); }

inline void check_refused(const Run& run, const std::string& part) {
  CAPTURE(run.err, part);
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(occurrences(run.err, part) == 1);
}

/// An array of doubles of the shape (frames, vertices, 3) as an .npy file of version 1: the positions of OBJ texts.
inline std::string npy_of(const std::vector<std::string>& frames, std::size_t vertices, int dimension = 3) {
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(frames.size()) + ", " +
                       std::to_string(vertices) + ", " + std::to_string(dimension) + "), }";
  header.append(118 - header.size() - 1, ' ').append("\n");
  std::string bytes = "\x93NUMPY";
  bytes.append({'\1', '\0', '\x76', '\0'}).append(header);
  for (const std::string& frame : frames) {
    std::istringstream lines(frame);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("v ")) continue;
      std::istringstream numbers(line.substr(2));
      for (double x; numbers >> x;) bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
    }
  }
  return bytes;
}

}  // namespace touchstone::tests
