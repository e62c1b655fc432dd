// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include <touchstone/version.hpp>

#include "report/machine.hpp"
#include "report/text.hpp"
#include "stress/stress.hpp"

namespace touchstone::stress {
namespace {

using report::Result;
using report::SetResults;

/// A row for each method, a column for each setting.
template <class Cell>
std::string table_of(const Table& table, const Cell& cell) {
  std::string text = "| method |", rule = "|---|";
  for (const SetResults& setting : table.settings) {
    text += fmt::format(" 2^{} |", setting.exponent);
    rule += "---:|";
  }
  text += "\n" + rule + "\n";
  const std::size_t methods = table.settings.front().results.size();
  for (std::size_t i = 0; i < methods; ++i) {
    const Result& first = table.settings.front().results[i];
    if (first.asked == 0) continue;
    text += fmt::format("| {} |", first.contestant.label());
    for (const SetResults& setting : table.settings) text += fmt::format(" {} |", cell(setting.results[i]));
    text += "\n";
  }
  return text + "\n";
}

std::string wrong_cell(const Result& result) {
  if (result.wrong() == 0) return "0";
  return fmt::format("{}/{}/{}", result.missed, result.phantom, result.late);
}

std::string time_cell(const Result& result) {
  return result.time_error ? report::ulps(result.time_error->greatest_size) : std::string("-");
}

std::string level_table(const Table& table) {
  std::string text = "| level |", rule = "|---|", filter = "| filter |", bracket = "| bracket |", exact = "| exact |";
  for (const SetResults& setting : table.settings) {
    const Result& own = own_result(setting);
    const auto cell = [&](std::size_t count) {
      return fmt::format(" {} |", report::percent(Result::fraction_of(count, own.asked)));
    };
    text += fmt::format(" 2^{} |", setting.exponent);
    rule += "---:|";
    filter += cell(own.levels.filter);
    bracket += cell(own.levels.bracket);
    exact += cell(own.levels.exact);
  }
  return text + "\n" + rule + "\n" + filter + "\n" + bracket + "\n" + exact + "\n\n";
}

/// "1.3 times as long at 2^60 (run time goes with the dial to the power 0.006)"
std::string end_of_growth(double gentle, double end, int from, int to) {
  return fmt::format("{:.2g} times as long at 2^{} (run time goes with the dial to the power {:.2g})", end / gentle, to,
                     std::log2(end / gentle) / (to - from));
}

std::string growth_sentence(const Table& table) {
  const Growth g = growth(table);
  const int gentle = table.dial->gentle, low = table.settings.front().exponent, high = table.settings.back().exponent;
  std::string text = fmt::format("`touchstone` takes {:.3g} us a query at 2^{}", g.gentle, gentle);
  if (low != gentle) text += ", " + end_of_growth(g.gentle, g.low, gentle, low);
  if (high != gentle) text += ", " + end_of_growth(g.gentle, g.high, gentle, high);
  return text + fmt::format("; the slowest is 2^{} with {:.3g} us, {:.2g} times as long.", g.slowest_at, g.slowest,
                            g.slowest / g.gentle);
}

std::string section(const Table& table) {
  const report::QuerySet& set = table.settings.front().set;
  std::size_t contacts = 0, queries = 0;
  for (const SetResults& setting : table.settings) {
    contacts += setting.set.contacts();
    queries += setting.set.queries.size();
  }
  std::string text =
      fmt::format("## {}\n\n2^n is the {}. {}. {} queries at each setting; of all {}, {} with contact.\n\n", set.name,
                  table.dial->varies, set.about, set.queries.size(), queries, contacts);
  text += growth_sentence(table) + "\n\n";
  text += fmt::format("![Wrong answers and run time along {0}](plots/{1}.svg)\n\n", set.name, picture_name(table));
  text += "Wrong answers, missed/phantom/late:\n\n" + table_of(table, wrong_cell);
  text += "Greatest time error in ulps, of the contacts that were found:\n\n" + table_of(table, time_cell);
  text +=
      "Mean us a query:\n\n" + table_of(table, [](const Result& result) { return fmt::format("{:.3g}", result.mean); });
  std::string few;
  for (const SetResults& setting : table.settings) {
    for (const Result& result : setting.results) {
      if (result.asked == 0 || result.asked == setting.set.queries.size()) continue;
      few += fmt::format("{}{} at 2^{}: {}", few.empty() ? "" : "; ", result.contestant.label(), setting.exponent,
                         report::asked_text(result, setting.set));
    }
  }
  if (!few.empty()) text += "Too slow for all the queries, and asked the first ones only: " + few + ".\n\n";
  return text + "Which level of `touchstone` decides:\n\n" + level_table(table);
}

std::string summary(const Stress& stress) {
  std::size_t asked = 0, contacts = 0;
  for (const Table& table : stress.tables) {
    for (const SetResults& setting : table.settings) {
      asked += own_result(setting).asked;
      contacts += own_result(setting).contacts;
    }
  }
  std::string text = fmt::format(
      "`touchstone` is wrong on {} of {} queries ({} with contact), and of the contacts it finds every time is the "
      "exact "
      "one{}. The oracle was asked {} of them and differs from the judge on {}.\n\n",
      own_errors(stress), asked, contacts, own_errors(stress) == 0 ? "" : " BUT THOSE", stress.oracle_asked,
      stress.oracle_differs.size());
  for (const std::string& query : stress.oracle_differs) text += "- " + query + "\n";
  return text;
}

std::string overview(const Stress& stress) {
  std::string text =
      "Queries that each method answers wrongly (missed, phantom or late), over all settings of a dial; and how much "
      "longer `touchstone` takes at the slowest setting than at the gentle one:\n\n| dial |";
  std::string rule = "|---|";
  for (const auto& contestant : stress.contestants) {
    text += fmt::format(" {} |", contestant.label());
    rule += "---:|";
  }
  text += " slowest / gentle |\n" + rule + "---:|\n";
  for (const Table& table : stress.tables) {
    text += fmt::format("| {} |", table.settings.front().set.name);
    for (std::size_t i = 0; i < stress.contestants.size(); ++i) {
      std::size_t wrong = 0, asked = 0;
      for (const SetResults& setting : table.settings) {
        wrong += setting.results[i].wrong();
        asked += setting.results[i].asked;
      }
      text += asked == 0 ? " - |" : fmt::format(" {} |", report::percent(Result::fraction_of(wrong, asked)));
    }
    const Growth g = growth(table);
    text += fmt::format(" {:.2g} |\n", g.slowest / g.gentle);
  }
  return text + "\n";
}

constexpr const char* kHowToRead =
    "*Missed*: contact denied though there is one. *Phantom*: contact claimed though there is none. *Late*: contact "
    "claimed rightly, but the time lies after the exact one. Exact arithmetic judges. The time error is the number of "
    "doubles between the claimed time and the exact one. *Us* is processor time of one thread; methods take turns, and "
    "one that is too slow for all queries of a setting is asked the first of them. `-`: nothing to compare, or not "
    "for this kind.\n\n";

}  // namespace

std::string markdown_text(const Stress& stress) {
  std::string command =
      fmt::format("touchstone stress --seed {} --count {}", stress.options.seed, stress.options.count);
  for (const Dial* dial : stress.options.which) command += fmt::format(" --dial {}", dial->name);
  command += report::separation_arguments(stress.options.separation);
  std::string text = fmt::format("# Touchstone: stability\n\nVersion {}, {}, {}. Made by `{}`.\n\n", version(),
                                 report::machine_name(), report::compiler_name(), command);
  text += summary(stress) + overview(stress) + kHowToRead;
  for (const Table& table : stress.tables) text += section(table);
  return text;
}

}  // namespace touchstone::stress
