// SPDX-License-Identifier: MIT
#include "report/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include <touchstone/version.hpp>

#include "report/machine.hpp"
#include "report/pictures/front.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"

namespace touchstone::report {
namespace {

constexpr const char* kHowToRead =
    "Every answer is judged by exact arithmetic. *Missed*: contact denied though there is one, as a share of the "
    "contacts. *Phantom*: contact claimed though there is none, as a share of the queries without contact. *Late*: "
    "contact claimed rightly, but the time lies after the exact one, as a share of the contacts; stepping there would "
    "pass through. The *time error* is the number of doubles from the exact time (the greatest double that is not "
    "after it) to the claimed one, over the contacts that are claimed: negative is early and safe, positive is late. "
    "An answer is *wrong* when it is missed, phantom or late; a method has "
    "*errors* when some answer is wrong or some time is not the exact one.\n\n"
    "*Mean us* is processor time of one thread: the median of several passes over all the queries asked, in which the "
    "methods take turns. A method that is too slow for a whole set is asked the first queries of it only (the sets are "
    "in random order), and the table says how many: `130 of 4000`. Such a method has no place on the front, and is "
    "faint in pictures.\n\n";

std::string picture(const std::string& name, const std::string& what) {
  return fmt::format("![{}](plots/{}.svg)\n\n", what, name);
}

std::string error_table(const SetResults& set) {
  std::string text =
      "| method | tolerance | queries | mean us | missed | phantom | late | time error, median ulps | earliest | "
      "latest "
      "|\n|---|---|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const Result& result : set.results) {
    const Contestant& contestant = result.contestant;
    text += fmt::format("| {} | {} | ", contestant.name, contestant.tolerance_text());
    if (result.asked == 0) {
      text += "not for this kind | | | | | | | |\n";
      continue;
    }
    text += fmt::format("{} | {:.3g} | {} | {} | {} | ", asked_text(result, set.set), result.mean,
                        percent(result.missed_fraction()), percent(result.phantom_fraction()),
                        percent(result.late_fraction()));
    if (const auto& error = result.time_error) {
      text += fmt::format("{} | {} | {} |\n", ulps(error->median), ulps(error->earliest), ulps(error->latest));
    } else {
      text += "| | |\n";
    }
  }
  return text + "\n";
}

std::string percentile_table(const SetResults& set) {
  std::string text =
      "Run time of single queries in us, each the shortest of several tries, the clock's own included:\n\n"
      "| method | tolerance |";
  for (const char* name : kPercentileNames) text += fmt::format(" {} |", name);
  text += "\n|---|---|---:|---:|---:|---:|---:|\n";
  for (const Result& result : set.results) {
    if (result.asked == 0) continue;
    text += fmt::format("| {} | {} |", result.contestant.name, result.contestant.tolerance_text());
    for (const double percentile : result.percentiles) text += fmt::format(" {:.3g} |", percentile);
    text += "\n";
  }
  return text + "\n";
}

std::string set_section(const SetResults& set) {
  std::string text = fmt::format("## {}\n\n{}. {} queries, {} with contact.\n\n", set.set.name, set.set.about,
                                 set.set.size(), set.set.contacts());
  text += front_sentence(set.results) + "\n\n";
  text += error_table(set);
  text += picture(error_picture_name(set), "Error against run time on " + set.set.name);
  text += percentile_table(set);
  return text + picture(percentile_picture_name(set), "Run time percentiles on " + set.set.name);
}

std::string level_section(const Report& report) {
  std::string text =
      "## Levels\n\nWhich level of `touchstone` decided, as shares of the queries it was asked.\n\n"
      "| set | queries | filter | bracket | exact |\n|---|---:|---:|---:|---:|\n";
  for (const SetResults& set : report.sets) {
    if (set.set.is_of_bodies()) continue;  // many pairs decide each
    for (const Result& result : set.results) {
      if (!result.contestant.is_touchstone()) continue;
      text += fmt::format("| {} | {} | {} | {} | {} |\n", set.set.name, result.asked,
                          percent(Result::fraction_of(result.levels.filter, result.asked)),
                          percent(Result::fraction_of(result.levels.bracket, result.asked)),
                          percent(Result::fraction_of(result.levels.exact, result.asked)));
    }
  }
  return text + "\n";
}

template <class Cell>
std::string scale_table(const Report& report, const Cell& cell) {
  std::string text = "| method | tolerance |", rule = "|---|---|";
  for (const SetResults& scale : report.scales) {
    text += fmt::format(" 2^{} |", scale.exponent);
    rule += "---:|";
  }
  text += "\n" + rule + "\n";
  for (std::size_t i = 0; i < report.scales.front().results.size(); ++i) {
    const Contestant& contestant = report.scales.front().results[i].contestant;
    text += fmt::format("| {} | {} |", contestant.name, contestant.tolerance_text());
    for (const SetResults& scale : report.scales) text += fmt::format(" {} |", cell(scale.results[i], scale.set));
    text += "\n";
  }
  return text + "\n";
}

std::string scale_section(const Report& report) {
  std::string text = "## Scale of the coordinates\n\n" + report.scales.front().set.about +
                     ". Tolerances that are lengths stay the same length at every scale.\n\nMean us a query:\n\n";
  text += scale_table(report, [](const Result& result, const QuerySet&) { return fmt::format("{:.3g}", result.mean); });
  text += picture(kScalePicture, "Run time against the scale of the coordinates");
  text += "Wrong answers (missed, phantom or late), as a share of the queries asked:\n\n";
  text += scale_table(report, [](const Result& result, const QuerySet&) { return percent(result.wrong_fraction()); });
  text += "Queries asked, where there was no time for all:\n\n";
  return text + scale_table(report, [](const Result& result, const QuerySet& set) {
           return result.asked == set.size() ? std::string() : asked_text(result, set);
         });
}

constexpr const char* kAboutSeparation =
    "Contact is a distance of at most the separation. The boxes of the candidates are grown by it. The scale of the "
    "coordinates multiplies it, too.\n\n";

}  // namespace

std::string how_to_read(const Report& report) {
  std::string text = kHowToRead;
  text += "The methods:\n\n";
  std::vector<std::string> named;
  for (const auto* contestants : {&report.contestants, &report.curved_contestants, &report.body_contestants}) {
    for (const Contestant& contestant : *contestants) {
      if (std::find(named.begin(), named.end(), contestant.name) != named.end()) continue;
      named.push_back(contestant.name);
      text += fmt::format("- `{}`{}: {}\n", contestant.name,
                          contestant.curved != nullptr  ? ", for curved motion"
                          : contestant.whole != nullptr ? ", for whole bodies"
                                                        : "",
                          contestant.about);
    }
  }
  return text + "\n";
}

std::string summary(const Report& report) {
  std::size_t asked = 0, wrong = 0, on_front = 0, left_of_all = 0;
  for (const SetResults& set : report.sets) {
    const Result* own = nullptr;
    for (const Result& result : set.results) {
      if (result.contestant.is_touchstone()) own = &result;
    }
    asked += own->asked;
    wrong += own->wrong();
    const auto best = front(set.results);
    on_front += std::find(best.begin(), best.end(), own) != best.end();
    left_of_all += std::none_of(set.results.begin(), set.results.end(), [&](const Result& result) {
      return result.asked > 0 && result.has_errors() && result.mean < own->mean;
    });
  }
  return fmt::format(
      "`touchstone` is wrong on {} of {} queries. It is on the front on {} of {} sets, and faster than "
      "every method that has errors on {}.\n\n",
      wrong, asked, on_front, report.sets.size(), left_of_all);
}

std::string markdown_text(const Report& report) {
  std::string text = fmt::format(
      "# Touchstone: error against run time\n\nVersion {}, {}, {}. Made by `touchstone report --seed {}{}{}`.\n\n",
      version(), machine_name(), compiler_name(), report.size.seed, report.size.quick ? " --quick" : "",
      separation_arguments(report.size.separation));
  if (report.size.separation.distance > 0) text += kAboutSeparation;
  text += summary(report);
  text += picture(kOverviewPicture, "Error against run time on " + report.sets.front().set.name);
  for (const std::string& remark : report.remarks) text += remark + "\n\n";
  text += "## How to read it\n\n";
  text += how_to_read(report);
  for (const SetResults& set : report.sets) text += set_section(set);
  return text + level_section(report) + scale_section(report) + scene_runs_section(report.scene_runs);
}

}  // namespace touchstone::report
