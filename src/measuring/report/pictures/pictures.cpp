// SPDX-License-Identifier: MIT
#include "report/pictures/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "io/write_whole.hpp"
#include "report/text.hpp"

namespace touchstone::report {
namespace {

constexpr const char* kTimeAxis = "mean run time [us per query]";

/// Results of one set, by method and tolerance, as a chart of an error against the run time.
view::Chart error_chart(const SetResults& set, const std::string& title, const std::string& axis,
                        const ValueOf& value) {
  view::Chart chart{title, {kTimeAxis, true}, {axis, true}, {}};
  for (const Result& result : set.results) {
    const auto error = result.asked > 0 && result.mean > 0 ? value(result) : std::nullopt;
    if (!error) continue;
    view::ChartSeries look = look_of(result.contestant);
    if (chart.series.empty() || chart.series.back().name != look.name) chart.series.push_back(std::move(look));
    const bool subset = result.asked != set.set.size();
    const std::string of = subset ? fmt::format(" ({})", asked_text(result, set.set)) : "";
    chart.series.back().points.push_back({result.mean, error, result.contestant.tolerance_text() + of, {}, {}, subset});
  }
  return chart;
}

/// The share of wrong answers of one sort, in per cent.
ValueOf percent_of(double (Result::*fraction)() const noexcept) {
  return [fraction](const Result& result) { return 100 * (result.*fraction)(); };
}

/// A time error, where there is one.
ValueOf ulps_of(std::int64_t TimeError::*size) {
  return [size](const Result& result) -> std::optional<double> {
    if (!result.time_error) return std::nullopt;
    return static_cast<double>((*result.time_error).*size);
  };
}

std::string subtitle(const SetResults& set) {
  return fmt::format("{} queries, {} contacts; numbers at points: tolerances; faint: asked a part; dashed: no error",
                     set.set.size(), set.set.contacts());
}

Picture overview_picture(const SetResults& set) {
  return {kOverviewPicture,
          view::chart_file("Error against run time: " + set.set.name, subtitle(set),
                           {error_chart(set, "Wrong answers: missed, phantom or late", "% of the queries",
                                        percent_of(&Result::wrong_fraction)),
                            error_chart(set, "Greatest time error", "ulps", ulps_of(&TimeError::greatest_size))})};
}

Picture error_picture(const SetResults& set) {
  return {
      error_picture_name(set),
      view::chart_file("Error against run time: " + set.set.name, subtitle(set),
                       {error_chart(set, "Missed contacts", "% of the contacts", percent_of(&Result::missed_fraction)),
                        error_chart(set, "Phantom contacts", "% of the queries without contact",
                                    percent_of(&Result::phantom_fraction)),
                        error_chart(set, "Late times", "% of the contacts", percent_of(&Result::late_fraction)),
                        error_chart(set, "Time error, median magnitude", "ulps", ulps_of(&TimeError::median_size))})};
}

Picture percentile_picture(const SetResults& set) {
  view::Chart chart{"Run time of a query", {"share of the queries that take no longer"}, {"us", true}, {}};
  chart.x.names.assign(kPercentileNames.begin(), kPercentileNames.end());
  for (const Result& result : set.results) {
    if (result.asked == 0 || !result.contestant.is_usual()) continue;
    view::ChartSeries series = look_of(result.contestant);
    series.name = result.contestant.label();
    for (std::size_t i = 0; i < kPercentileNames.size(); ++i)
      series.points.push_back({static_cast<double>(i), result.percentiles[i]});
    chart.series.push_back(std::move(series));
  }
  return {percentile_picture_name(set), view::chart_file("Run time percentiles: " + set.set.name, "", {chart})};
}

Picture scale_picture(const Report& report) {
  const view::Chart chart{"Mean run time", {"coordinates times 2 to the power of"}, {"us per query", true}, {}};
  return {kScalePicture,
          view::chart_file("Run time against the scale of the coordinates", "",
                           {chart_of_settings(report.scales, chart, [](const Result& r) { return r.mean; })})};
}

}  // namespace

std::string picture_name(const std::string& before, const SetResults& set) {
  std::string name = before + set.set.name;
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

std::string error_picture_name(const SetResults& set) { return picture_name("error-", set); }
std::string percentile_picture_name(const SetResults& set) { return picture_name("percentiles-", set); }

std::vector<Picture> pictures(const Report& report) {
  std::vector<Picture> all{overview_picture(report.sets.front())};
  for (const SetResults& set : report.sets) {
    all.push_back(error_picture(set));
    all.push_back(percentile_picture(set));
  }
  all.push_back(scale_picture(report));
  return all;
}

view::ChartSeries look_of(const Contestant& contestant) {
  struct Look {
    const char* method;
    int colour, shape;
    bool hollow;
  };
  static constexpr std::array<Look, 14> kLooks{{{"paper", 2, 1, false},
                                                {"closed_form", 5, 2, false},
                                                {"newton", 3, 3, false},
                                                {"interval", 1, 4, false},
                                                {"conservative_advancement", 4, 0, false},
                                                {"thick_advancement", 4, 0, true},
                                                {"thick_polynomial", 2, 1, true},
                                                {"redon", 1, 4, true},
                                                {"curved_advancement", 4, 3, true},
                                                {"waypoints", 1, 4, true},
                                                {"body_advancement", 4, 3, true},
                                                {"exact_only", 7, 0, true},
                                                {"touchstone_cgal", 6, 1, true},
                                                {"touchstone", 0, 0, false}}};
  view::ChartSeries series;
  series.name = contestant.name;
  series.own = contestant.is_touchstone();
  const auto look =
      std::find_if(kLooks.begin(), kLooks.end(), [&](const Look& each) { return contestant.name == each.method; });
  series.colour = look == kLooks.end() ? 5 : look->colour;
  series.shape = look == kLooks.end() ? 1 : look->shape;
  series.hollow = look == kLooks.end() || look->hollow;
  return series;
}

view::Chart chart_of_settings(const std::vector<SetResults>& settings, view::Chart chart, const ValueOf& value) {
  for (std::size_t i = 0; i < settings.front().results.size(); ++i) {
    view::ChartSeries series = look_of(settings.front().results[i].contestant);
    series.name = settings.front().results[i].contestant.label();
    for (const SetResults& setting : settings) {
      const Result& result = setting.results[i];
      if (result.asked > 0) series.points.push_back({static_cast<double>(setting.exponent), value(result)});
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

void write_pictures(const std::vector<Picture>& pictures, const std::filesystem::path& folder) {
  for (const Picture& picture : pictures) io::write_whole((folder / (picture.name + ".svg")).string(), picture.svg);
}

}  // namespace touchstone::report
