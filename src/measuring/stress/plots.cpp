// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "stress/stress.hpp"

namespace touchstone::stress {
namespace {

using report::Result;
using report::SetResults;

/// A fraction of fewer queries is mostly chance.
constexpr std::size_t kFewest = 20;

/// One panel: `value` of every method against the setting, at the settings where it has a value.
template <class Value>
std::string panel(const Table& table, const std::string& prefix, const Value& value) {
  std::string data, drawn;
  for (std::size_t i = 0; i < table.settings.front().results.size(); ++i) {
    const auto& contestant = table.settings.front().results[i].contestant;
    if (table.settings.front().results[i].asked == 0) continue;
    const std::string name = fmt::format("${}{}", prefix, i);
    data += name + " << END\n";
    for (const SetResults& setting : table.settings) {
      const std::optional<double> y = value(setting.results[i]);
      data += y ? fmt::format("{} {:.6g}\n", setting.exponent, *y) : fmt::format("{} NaN\n", setting.exponent);
    }
    data += "END\n";
    drawn +=
        fmt::format("{}{} using 1:2 with linespoints {} ps 1.1 lw 2 title \"{}\" noenhanced",
                    drawn.empty() ? "plot " : ", \\\n     ", name, report::style(contestant.name), contestant.label());
  }
  return data + drawn + "\n";
}

report::Plot plot(const Table& table) {
  const std::string& name = table.settings.front().set.name;
  std::string body = fmt::format(
      "set multiplot layout 1,2 margins 0.055,0.765,0.12,0.84 spacing 0.075 title \"Stability: {}\" font ',14'\n",
      name);
  body += fmt::format("set xlabel '{}, 2 to the power of'\nset grid xtics ytics lc rgb '#E4E4E4' lt 1\n",
                      table.dial->varies);
  body += "set title 'Wrong answers (missed, phantom or late)'\nset ylabel 'share of the queries [%]'\n";
  body += "set yrange [-3:103]\nset key off\n";
  body += panel(table, "wrong", [](const Result& result) -> std::optional<double> {
    if (result.asked < kFewest) return std::nullopt;
    return 100 * result.wrong_fraction();
  });
  body += "set title 'Run time'\nset ylabel 'mean run time [us per query]'\nset logscale y\nset format y '%g'\n";
  body += "set autoscale y\nset key at screen 0.995, screen 0.6 right center Left reverse samplen 2 width -2\n";
  body += panel(table, "time", [](const Result& result) -> std::optional<double> { return result.mean; });
  return report::drawn_twice(plot_name(table), 1300, 520, body + "unset multiplot\n");
}

}  // namespace

std::string plot_name(const Table& table) {
  std::string name = table.settings.front().set.name;
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

std::vector<report::Plot> plots(const Stress& stress) {
  std::vector<report::Plot> all;
  for (const Table& table : stress.tables) all.push_back(plot(table));
  return all;
}

}  // namespace touchstone::stress
