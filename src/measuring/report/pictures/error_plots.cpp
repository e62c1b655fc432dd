// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "report/pictures/plots.hpp"

namespace touchstone::report {
namespace {

/// One panel of a picture: a value of every method against its mean run time.
struct Panel {
  std::string title;
  std::string axis;
  std::string format;
  double least_unit;  ///< the zero line is never above a tenth of it
  std::function<std::optional<double>(const Result&)> value;
};

/// The panels of one set's own picture: each error apart, and the usual time error.
std::vector<Panel> panels() {
  return {
      {"Missed contacts", "share of the contacts [%]", "%g", 100,
       [](const Result& r) { return 100 * r.missed_fraction(); }},
      {"Phantom contacts", "share of the queries without contact [%]", "%g", 100,
       [](const Result& r) { return 100 * r.phantom_fraction(); }},
      {"Late times", "share of the contacts [%]", "%g", 100, [](const Result& r) { return 100 * r.late_fraction(); }},
      {"Time error", "median magnitude [ulps]", "10^{%L}", 1,
       [](const Result& r) -> std::optional<double> {
         if (!r.time_error) return std::nullopt;
         return static_cast<double>(r.time_error->median_size);
       }},
  };
}

/// The panels of the overview picture: wrong answers of any sort, and the greatest time error.
std::vector<Panel> overview_panels() {
  return {
      {"Wrong answers: missed, phantom or late", "share of the queries [%]", "%g", 100,
       [](const Result& r) { return 100 * r.wrong_fraction(); }},
      {"Greatest time error", "magnitude [ulps]", "10^{%L}", 1,
       [](const Result& r) -> std::optional<double> {
         if (!r.time_error) return std::nullopt;
         return static_cast<double>(r.time_error->greatest_size);
       }},
  };
}

/// The position of zero on the logarithmic axis: a decade or more below the least value that is not zero.
double zero_line(const SetResults& set, const Panel& panel) {
  double least = panel.least_unit;
  for (const Result& result : set.results) {
    const auto value = result.asked > 0 ? panel.value(result) : std::nullopt;
    if (value && *value > 0) least = std::min(least, *value);
  }
  return std::pow(10, std::floor(std::log10(least)) - 1);
}

/// Names of the methods that were asked, each once, in order.
std::vector<std::string> methods_of(const SetResults& set) {
  std::vector<std::string> names;
  for (const Result& result : set.results) {
    const std::string& name = result.contestant.name;
    if (result.asked > 0 && (names.empty() || names.back() != name)) names.push_back(name);
  }
  return names;
}

/// The labels that a panel has so far, so that no two overlap.
class Labels {
 public:
  std::string at(double x, double y, const std::string& text) {
    constexpr double kWidth = 1.6, kHeight = 3;  // on logarithmic axes: as factors
    for (const auto& [other_x, other_y] : taken_) {
      const bool near_x = std::max(x, other_x) < kWidth * std::min(x, other_x);
      if (near_x && std::max(y, other_y) < kHeight * std::min(y, other_y)) return {};
    }
    if (!text.empty()) taken_.emplace_back(x, y);
    return text;
  }

 private:
  std::vector<std::pair<double, double>> taken_;
};

/// The points of one method as the lines "x y label" of a data block.
std::string points(const SetResults& set, const std::string& method, const Panel& panel, double zero, Labels& labels) {
  std::string text;
  for (const Result& result : set.results) {
    if (result.contestant.name != method || result.asked == 0) continue;
    const auto value = panel.value(result);
    if (!value) continue;
    const double y = *value > 0 ? *value : zero;
    text += fmt::format("{:.6g} {:.6g} \"{}\"\n", result.mean, y,
                        labels.at(result.mean, y, result.contestant.tolerance_text()));
  }
  return text;
}

double greatest(const SetResults& set, const Panel& panel) {
  double most = panel.least_unit;
  for (const Result& result : set.results) {
    if (result.asked > 0) most = std::max(most, panel.value(result).value_or(0));
  }
  return most;
}

std::string series_style(const std::string& method) {
  return fmt::format("with linespoints {} ps {} lw 1.5 dt 3", style(method), method == "touchstone" ? 1.9 : 1.3);
}

std::string panel_script(const SetResults& set, const Panel& panel, std::size_t number) {
  const double zero = zero_line(set, panel);
  std::string text, drawn;
  Labels labels;
  int block = 0;
  for (const std::string& method : methods_of(set)) {
    const std::string data = points(set, method, panel, zero, labels);
    if (data.empty()) continue;
    const std::string name = fmt::format("$panel{}_{}", number, block++);
    text += fmt::format("{} << END\n{}END\n", name, data);
    drawn +=
        fmt::format("{}{} using 1:2 {} notitle", drawn.empty() ? "plot " : ", \\\n     ", name, series_style(method));
    drawn += fmt::format(", \\\n     {} using 1:2:3 with labels offset 0,0.9 font ',9' tc rgb '#555555' notitle", name);
  }
  text += fmt::format("set title '{}'\nset ylabel '{}'\nset format y '{}'\n", panel.title, panel.axis, panel.format);
  text +=
      fmt::format("set yrange [{:.6g}:{:.6g}]\n", zero / 3, greatest(set, panel) * (panel.least_unit == 1 ? 50 : 3));
  text += fmt::format("set ytics auto\nset ytics add ('0' {:.6g}, '' {:.6g})\n", zero, zero / 10);
  text += fmt::format(
      "set arrow 1 from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead dt 2 lw 1 lc rgb "
      "'#777777' back\n",
      zero);
  if (!drawn.empty()) return text + drawn + "\n";
  return text + fmt::format(
                    "set label 2 'no contact, no time to compare' at graph 0.5, graph 0.5 center\n"
                    "plot {:.6g} notitle\nunset label 2\n",
                    zero / 100);
}

/// An empty panel as wide as the canvas: the legend of all other panels.
/// @param top  its upper end, as a fraction of the canvas  @param rows  the greatest number of rows
std::string legend(const SetResults& set, double top, int rows) {
  std::string text = fmt::format(
      "unset logscale\nunset border\nunset tics\nunset title\nunset xlabel\nunset ylabel\nunset arrow 1\nunset grid\n"
      "set lmargin at screen 0.01\nset rmargin at screen 0.99\nset bmargin at screen 0.005\nset tmargin at screen {}\n"
      "set xrange [0:1]\nset yrange [0:1]\nset key inside center center horizontal maxrows {} samplen 2 width 1\n",
      top, rows);
  std::string drawn;
  for (const std::string& method : methods_of(set)) {
    drawn += fmt::format("{}-1 {} title \"{}\" noenhanced", drawn.empty() ? "plot " : ", \\\n     ",
                         series_style(method), method);
  }
  return text + drawn + "\n";
}

}  // namespace

std::string error_plot_name(const SetResults& set) {
  std::string name = "error-" + set.set.name;
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

namespace {

/// Panels side by side and below each other, a legend under them all.
struct Layout {
  int width, height;  ///< of the canvas, pixels
  const char* grid;   ///< gnuplot's multiplot layout and margins
  double legend_top;  ///< fraction of the canvas
  int legend_rows;
};

Plot panels_plot(const std::string& name, const SetResults& set, const std::vector<Panel>& panels,
                 const Layout& layout) {
  std::string body = fmt::format(
      "set multiplot layout {} title \"Error against run time: {} ({} queries, {} contacts)\\n{{/*0.8 numbers at "
      "points: tolerances; dashed line: no error}}\" font ',14'\n"
      "set logscale xy\nset format x '%g'\nset xlabel 'mean run time [us per query]'\nset grid xtics ytics lc rgb "
      "'#E4E4E4' lt 1\nunset key\n",
      layout.grid, set.set.name, set.set.size(), set.set.contacts());
  double fastest = 1e300, slowest = 0;
  for (const Result& result : set.results) {
    if (result.asked == 0) continue;
    fastest = std::min(fastest, result.mean);
    slowest = std::max(slowest, result.mean);
  }
  body += fmt::format("set xrange [{:.6g}:{:.6g}]\n", fastest / 2, slowest * 2.5);
  for (std::size_t i = 0; i < panels.size(); ++i) body += panel_script(set, panels[i], i);
  body += legend(set, layout.legend_top, layout.legend_rows) + "unset multiplot\n";
  return drawn_twice(name, layout.width, layout.height, body);
}

}  // namespace

Plot error_plot(const SetResults& set) {
  return panels_plot(error_plot_name(set), set, panels(),
                     {1200, 900, "2,2 margins 0.08,0.985,0.12,0.9 spacing 0.09,0.13", 0.06, 1});
}

Plot overview_plot(const SetResults& set) {
  return panels_plot(kOverviewPlot, set, overview_panels(),
                     {1000, 470, "1,2 margins 0.095,0.985,0.25,0.8 spacing 0.105,0.1", 0.12, 2});
}

}  // namespace touchstone::report
