// The plots as gnuplot scripts that carry their data with them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/report.hpp"

namespace touchstone::report {

/// A script that writes NAME.svg and NAME.png into the working folder.
struct Plot {
  std::string name;
  std::string script;
  std::vector<std::string> reads = {};  ///< files beside the script
};

inline constexpr const char* kOverviewPlot = "error-against-time";
inline constexpr const char* kLevelPlot = "levels";
inline constexpr const char* kScalePlot = "scale";
std::string error_plot_name(const SetResults& set);       ///< "error-simulation-edge-edge"
std::string percentile_plot_name(const SetResults& set);  ///< "percentiles-simulation-edge-edge"

/// The fractions missed, phantom and late and the time error, each against the mean run time.
Plot error_plot(const SetResults& set);

/// The overview picture: wrong answers and the greatest time error on one set.
Plot overview_plot(const SetResults& set);

/// All plots of a report.
std::vector<Plot> plots(const Report& report);

/// `body` drawn twice, as SVG and as PNG, on a canvas of the given size in pixels.
Plot drawn_twice(const std::string& name, int width, int height, const std::string& body);

/// Colour and shape of one method, the same in every plot: "lc rgb '#0072B2' pt 5".
std::string style(const std::string& method);

}  // namespace touchstone::report
