// Points on logarithmic axes as an SVG.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace touchstone::view {

/// Strings are text.
struct ScatterPoint {
  double x = 1, y = 0;  ///< x > 0; y = 0 is drawn on a line of its own, below all decades
  std::string label;    ///< beside the point, where there is room
  std::string told;     ///< when the pointer rests on it
  std::string row;      ///< the id of the table's row
  bool own = false;
};

struct ScatterAxes {
  std::string title, x, y;
};

/// The text does not depend on the machine's locale.
std::string scatter_svg(const std::vector<ScatterPoint>& points, const ScatterAxes& axes);

}  // namespace touchstone::view
