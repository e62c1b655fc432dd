// Charts as SVG: points and lines on axes, for pages and as files.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace touchstone::view {

/// Strings are text.
struct ChartPoint {
  double x = 0;
  std::optional<double> y;  ///< nothing, or no finite number: there is no point, and the line is broken
  std::string label = {};   ///< beside the point, where there is room
  std::string told = {};    ///< when the pointer rests on it
  std::string row = {};     ///< the id of the table's row, on a page
  bool faint = false;       ///< not to be compared with the others
};

/// The colours and shapes of points, which readers with any colour vision tell apart.
inline constexpr int kChartColours = 8;
inline constexpr int kChartShapes = 5;

/// Points of one sort, which have one look and one line of the legend.
struct ChartSeries {
  std::string name;
  int colour = 0;       ///< in [0, kChartColours)
  int shape = 0;        ///< in [0, kChartShapes): circle, square, triangle, diamond, triangle upside down
  bool hollow = false;  ///< the shape's outline alone
  bool own = false;     ///< large, over the others, and first to have its labels
  bool line = true;     ///< a line from each point to the next one
  bool marks = true;    ///< the shapes
  std::vector<ChartPoint> points;
};

struct ChartAxis {
  std::string label;
  bool logarithmic = false;             ///< y = 0 is then drawn on a line of its own, below all decades; x is > 0
  std::vector<std::string> names = {};  ///< of x = 0, 1, ..., in place of numbers
};

struct Chart {
  std::string title;
  ChartAxis x, y;
  std::vector<ChartSeries> series;
};

/// An element for a page with chart.css: all points, and the names of the series where there are several. The text does
/// not depend on the machine's locale.
std::string chart_svg(const Chart& chart);

/// A whole SVG file, light or dark as its reader prefers: a title, the charts in two columns, and below them the names
/// of the series, once where the first chart has them all. @param charts  one or more
std::string chart_file(const std::string& title, const std::string& subtitle, const std::vector<Chart>& charts);

}  // namespace touchstone::view
