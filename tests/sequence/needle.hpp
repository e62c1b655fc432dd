// A sequence of OBJ files: a needle falls on a flat cloth. Where and when it meets the cloth is known without a solver.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "io/temporary_folder.hpp"

namespace touchstone::tests {

/// The cloth: side * side vertices at z = 0, one unit apart, and two triangles for each cell. The needle: a triangle
/// whose tip is above the middle of the first triangle of cell (1, 1), with the height `tip`.
///
/// Vertex i * side + j + 1 of the file is at (i, j, 0); the tip is the vertex after those. The first triangle of cell
/// (1, 1) is face 2 * (side - 1) + 3, with the vertices side + 2, side + 3 and 2 * side + 2.
inline std::string needle_frame(std::size_t side, double tip) {
  std::string text = "# a needle and a cloth\no cloth\n";
  char line[120];
  const auto vertex = [&](double x, double y, double z) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", x, y, z);
    text += line;
  };
  const auto face = [&](std::size_t a, std::size_t b, std::size_t c) {
    std::snprintf(line, sizeof line, "f %zu %zu %zu\n", a, b, c);
    text += line;
  };
  for (std::size_t i = 0; i < side; ++i) {
    for (std::size_t j = 0; j < side; ++j) vertex(static_cast<double>(i), static_cast<double>(j), 0);
  }
  for (std::size_t i = 0; i + 1 < side; ++i) {
    for (std::size_t j = 0; j + 1 < side; ++j) {
      const std::size_t corner = i * side + j + 1;
      face(corner, corner + 1, corner + side);
      face(corner + 1, corner + side + 1, corner + side);
    }
  }
  text += "o needle\n";
  const std::size_t first = side * side + 1;
  vertex(1.25, 1.25, tip);
  vertex(1.25 + 0x1p-8, 1.25, tip + 8);
  vertex(1.25, 1.25 + 0x1p-8, tip + 8);
  face(first, first + 1, first + 2);
  return text;
}

/// The tip falls by a quarter a frame, from 0.625: so it meets the cloth at t = 0.5 of step 2 -> 3.
inline double falling_tip(std::size_t frame) { return 0.625 - 0.25 * static_cast<double>(frame); }

/// The needle rises, and meets nothing.
inline double rising_tip(std::size_t frame) { return 0.625 + 0.25 * static_cast<double>(frame); }

/// Writes NAME-0.obj to NAME-(count - 1).obj. @returns their paths, in order
inline std::vector<std::string> write_needles(const TemporaryFolder& folder, const std::string& name, std::size_t side,
                                              std::size_t count, double (*tip)(std::size_t)) {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < count; ++i) {
    files.push_back(folder.write(name + "-" + std::to_string(i) + ".obj", needle_frame(side, tip(i))));
  }
  return files;
}

}  // namespace touchstone::tests
