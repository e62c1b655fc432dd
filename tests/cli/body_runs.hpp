// Runs of touchstone bodies.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/mesh_runs.hpp"

namespace touchstone::tests {

/// A box of these half widths about its origin.
inline std::string box_obj(double x, double y, double z) {
  std::string text;
  for (int corner = 0; corner < 8; ++corner) {
    text += "v";
    for (const auto& [half, bit] : {std::pair{x, 1}, {y, 2}, {z, 4}}) {
      text += " " + std::to_string((corner & bit) != 0 ? half : -half);
    }
    text += "\n";
  }
  return text +
         "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n";
}

inline constexpr const char* kHeader = "time,body,x,y,z,qw,qx,qy,qz\n";
inline constexpr const char* kTurned = "0.70710678118654757,0,0,0.70710678118654757";

/// A square bar that turns beside a wall, which its corner, sqrt(2) away, reaches at 45 degrees.
struct BarAndWall {
  TemporaryFolder folder;
  std::string bar = folder.write("bar.obj", box_obj(1, 1, 3)), wall = folder.write("wall.obj", box_obj(0.25, 8, 8));

  Run run(const std::string& poses, const std::vector<std::string>& more = {}) const {
    return run_program(with({"bodies", bar, wall, "--poses", folder.write("poses.csv", poses)}, more));
  }
  /// The bar turns by 90 degrees in the time from 0 to 2, and the wall rests at x.
  static std::string quarter_turn(const std::string& x) {
    return std::string(kHeader) + "0,bar,0,0,0,1,0,0,0\n2,bar,0,0,0," + kTurned + "\n0,wall," + x +
           ",0,0,1,0,0,0\n2,wall," + x + ",0,0,1,0,0,0\n";
  }
};

}  // namespace touchstone::tests
