// The pictures of a report: charts, each a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"
#include "view/chart.hpp"

namespace touchstone::report {

/// A picture, for a file NAME.svg.
struct Picture {
  std::string name;
  std::string svg;
};

inline constexpr const char* kOverviewPicture = "error-against-time";
inline constexpr const char* kScalePicture = "scale";
std::string error_picture_name(const SetResults& set);       ///< "error-simulation-edge-edge"
std::string percentile_picture_name(const SetResults& set);  ///< "percentiles-simulation-edge-edge"

/// All pictures of a report.
std::vector<Picture> pictures(const Report& report);

/// The name, colour and shape of a method, the same in every picture. It has no points.
view::ChartSeries look_of(const Contestant& contestant);

/// Results at several settings, as a chart against them.
/// @param value  a number of a result, or nothing where it has none
using ValueOf = std::function<std::optional<double>(const Result&)>;
view::Chart chart_of_settings(const std::vector<SetResults>& settings, view::Chart chart, const ValueOf& value);

/// `set.set.name` as part of a file's name. @param before  the part before it
std::string picture_name(const std::string& before, const SetResults& set);

/// Writes NAME.svg of each into `folder`, which exists. @throws FileError
void write_pictures(const std::vector<Picture>& pictures, const std::filesystem::path& folder);

}  // namespace touchstone::report
