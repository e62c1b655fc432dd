// SPDX-License-Identifier: MIT
#include "report/pictures/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace touchstone::report {
namespace {

Plot percentile_plot(const SetResults& set) {
  std::string text, drawn;
  int block = 0;
  for (const Result& result : set.results) {
    if (result.asked == 0 || !result.contestant.is_usual()) continue;
    const std::string name = fmt::format("$data{}", block++);
    text += name + " << END\n";
    for (std::size_t i = 0; i < kPercentileNames.size(); ++i)
      text += fmt::format("{} {:.6g}\n", i, result.percentiles[i]);
    text += "END\n";
    drawn += fmt::format("{}{} using 1:2 with linespoints {} ps 1.3 lw 2 title \"{}\" noenhanced",
                         drawn.empty() ? "plot " : ", \\\n     ", name, style(result.contestant.name),
                         result.contestant.label());
  }
  text += fmt::format("set title 'Run time percentiles: {}'\nset logscale y\nset format y '%g'\n", set.set.name);
  text += "set ylabel 'run time of a query [us]'\nset xlabel 'share of the queries that take no longer'\n";
  text += "set xrange [-0.3:4.3]\nset xtics (";
  for (std::size_t i = 0; i < kPercentileNames.size(); ++i) {
    const bool percent = std::string_view(kPercentileNames[i]).find('%') != std::string_view::npos;
    // gnuplot reads a tic's label as a format, in which a per cent sign is written twice.
    text += fmt::format("{}'{}{}' {}", i == 0 ? "" : ", ", kPercentileNames[i], percent ? "%" : "", i);
  }
  text +=
      ")\nset grid xtics ytics lc rgb '#E4E4E4' lt 1\nset key outside right center Left reverse samplen 2 width -2\n";
  return drawn_twice(percentile_plot_name(set), 1000, 560, text + drawn + "\n");
}

Plot scale_plot(const Report& report) {
  std::string text, drawn;
  for (std::size_t i = 0; i < report.scales.front().results.size(); ++i) {
    const Contestant& contestant = report.scales.front().results[i].contestant;
    const std::string name = fmt::format("$data{}", i);
    text += name + " << END\n";
    for (const SetResults& scale : report.scales) {
      if (scale.results[i].asked > 0) text += fmt::format("{} {:.6g}\n", scale.exponent, scale.results[i].mean);
    }
    text += "END\n";
    drawn += fmt::format("{}{} using 1:2 with linespoints {} ps 1.3 lw 2 title \"{}\" noenhanced",
                         drawn.empty() ? "plot " : ", \\\n     ", name, style(contestant.name), contestant.label());
  }
  text += "set title 'Run time against the scale of the coordinates'\nset logscale y\nset format y '%g'\n";
  text += "set ylabel 'mean run time [us per query]'\nset xlabel 'coordinates times 2 to the power of'\n";
  text += "set xtics -900, 300, 900\nset mxtics 3\nset xrange [-960:960]\n";
  text += "set grid xtics ytics lc rgb '#E4E4E4' lt 1\nset key outside right center Left reverse samplen 2 width -2\n";
  return drawn_twice(kScalePlot, 1000, 560, text + drawn + "\n");
}

Plot level_plot(const Report& report) {
  std::string text = "$data << END\n";
  for (const SetResults& set : report.sets) {
    for (const Result& result : set.results) {
      if (!result.contestant.is_touchstone()) continue;
      const auto percent = [&](std::size_t count) { return 100 * Result::fraction_of(count, result.asked); };
      text += fmt::format("\"{}\" {:.6g} {:.6g} {:.6g}\n", set.set.name, percent(result.levels.filter),
                          percent(result.levels.bracket), percent(result.levels.exact));
    }
  }
  text += "END\nset title 'Which level of touchstone decides'\nset ylabel 'share of the queries [%]'\n";
  text += "set style data histogram\nset style histogram clustered gap 1\nset style fill solid 0.9 noborder\n";
  text += "set logscale y\nset yrange [0.01:150]\nset format y '%g'\nset boxwidth 0.9\n";
  text += "set xtics rotate by -35 noenhanced\nset grid ytics lc rgb '#E4E4E4' lt 1\nset key outside right center\n";
  text +=
      "plot $data using 2:xtic(1) title 'filter' lc rgb '#56B4E9', $data using 3 title 'bracket' lc rgb '#E69F00', "
      "\\\n     $data using 4 title 'exact' lc rgb '#000000'\n";
  return drawn_twice(kLevelPlot, 1100, 560, text);
}

}  // namespace

std::string percentile_plot_name(const SetResults& set) {
  std::string name = "percentiles-" + set.set.name;
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

std::vector<Plot> plots(const Report& report) {
  std::vector<Plot> all;
  all.push_back(overview_plot(report.sets.front()));
  for (const SetResults& set : report.sets) {
    all.push_back(error_plot(set));
    all.push_back(percentile_plot(set));
  }
  all.push_back(level_plot(report));
  all.push_back(scale_plot(report));
  return all;
}

Plot drawn_twice(const std::string& name, int width, int height, const std::string& body) {
  const std::string svg =
      fmt::format("set terminal svg size {},{} dynamic background rgb 'white' font 'sans,12'\n", width, height);
  // Not every gnuplot has Cairo.
  const std::string png = fmt::format(
      "if (strstrt(GPVAL_TERMINALS, 'pngcairo')) {{ set terminal pngcairo size {0},{1} font 'sans,11' }} else {{ set "
      "terminal png size {0},{1} }}\n",
      width, height);
  Plot plot{name, "# Draws " + name + ".svg and " + name + ".png into the working folder: gnuplot " + name + ".gp\n"};
  plot.script += svg + "set output '" + name + ".svg'\n" + body + "set output\nreset\n";
  plot.script += png + "set output '" + name + ".png'\n" + body + "set output\n";
  return plot;
}

std::string style(const std::string& method) {
  struct Entry {
    const char* method;
    const char* style;
  };
  // Colours that the colour-blind can tell apart (Okabe and Ito), and a shape each.
  static constexpr std::array<Entry, 12> kStyles{{{"paper", "lc rgb '#D55E00' pt 5"},
                                                  {"closed_form", "lc rgb '#E69F00' pt 9"},
                                                  {"newton", "lc rgb '#009E73' pt 13"},
                                                  {"interval", "lc rgb '#0072B2' pt 11"},
                                                  {"conservative_advancement", "lc rgb '#CC79A7' pt 15"},
                                                  {"thick_advancement", "lc rgb '#CC79A7' pt 14"},
                                                  {"thick_polynomial", "lc rgb '#D55E00' pt 8"},
                                                  {"redon", "lc rgb '#0072B2' pt 10"},
                                                  {"curved_advancement", "lc rgb '#CC79A7' pt 12"},
                                                  {"exact_only", "lc rgb '#888888' pt 6"},
                                                  {"touchstone_cgal", "lc rgb '#56B4E9' pt 4"},
                                                  {"touchstone", "lc rgb '#000000' pt 7"}}};
  for (const Entry& entry : kStyles) {
    if (method == entry.method) return entry.style;
  }
  return "lc rgb '#F0E442' pt 4";
}

}  // namespace touchstone::report
