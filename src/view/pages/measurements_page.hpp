// The page of a comparison of methods: error against run time, and tables that sort.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/chart.hpp"
#include "view/pages/html.hpp"

namespace touchstone::view {

/// One method on one set. All strings are text.
struct MeasuredMethod {
  std::string label;                          ///< "newton 1e-6"
  ChartSeries look;                           ///< its points have this look; methods of one name have one line
  double time = 0;                            ///< on the horizontal axis, > 0
  std::vector<std::optional<double>> errors;  ///< one for each panel, >= 0; nothing where it has none

  /// A cell of the table, after the label's: what it sorts by, where that is not its text.
  struct Cell {
    std::string text;
    std::optional<double> value;
  };
  std::vector<Cell> cells;
  std::string subset = {};  ///< "184 of 600", where it was asked so many queries of the set
};

struct MeasuredSet {
  std::string name, about;
  std::vector<MeasuredMethod> methods;
};

/// One picture of every set: an error against the run time, both on logarithmic axes.
struct ErrorPanel {
  std::string title, axis;
};

struct Measurements {
  std::string title, subtitle, command;  ///< as Page has them
  std::string summary;
  std::string how_to_read;  ///< what the words mean, several lines, folded at first
  std::string time_axis;
  std::vector<ErrorPanel> panels;
  std::vector<std::string> columns;  ///< the names of the cells
  std::vector<MeasuredSet> sets;
};

Page measurements_page(const Measurements& measurements);

}  // namespace touchstone::view
