// SPDX-License-Identifier: MIT
#include "cli/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include <touchstone/version.hpp>

#include "cli/shared/command_line/typed_command.hpp"
#include "report/machine.hpp"
#include "report/markdown.hpp"
#include "report/pictures/front.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"
#include "view/pages/measurements_page.hpp"

namespace touchstone::cli {
namespace {

using Cell = view::MeasuredMethod::Cell;

/// Text of a Markdown file without its marks for code and for stress.
std::string without_marks(std::string text) {
  std::erase_if(text, [](char c) { return c == '`' || c == '*'; });
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}

Cell percent(double fraction) { return {report::percent(fraction), 100 * fraction}; }

Cell ulps(std::int64_t error) { return {report::ulps(error), static_cast<double>(error)}; }

view::MeasuredMethod measured(const report::Result& result, const report::QuerySet& set) {
  view::MeasuredMethod method;
  method.label = result.contestant.label();
  method.look = report::look_of(result.contestant);
  if (result.asked != set.size()) method.subset = report::asked_text(result, set);
  method.time = result.mean;
  std::optional<double> greatest;
  if (result.time_error) greatest = static_cast<double>(result.time_error->greatest_size);
  method.errors = {100 * result.wrong_fraction(), greatest};
  method.cells = {{report::asked_text(result, set), static_cast<double>(result.asked)},
                  {fmt::format("{:.3g}", result.mean), result.mean},
                  percent(result.missed_fraction()),
                  percent(result.phantom_fraction()),
                  percent(result.late_fraction())};
  if (const auto& error = result.time_error) {
    for (const std::int64_t each : {error->median, error->earliest, error->latest}) method.cells.push_back(ulps(each));
  } else {
    method.cells.resize(method.cells.size() + 3);
  }
  for (const double time : result.percentiles) method.cells.push_back({fmt::format("{:.3g}", time), time});
  return method;
}

}  // namespace

std::string report_page(const report::Report& report) {
  view::Measurements all;
  all.title = "Touchstone: error against run time";
  all.command = typed_command();
  all.subtitle =
      fmt::format("How often each method is wrong, against the time that it takes. Version {}, {}, {}; seed {}{}{}",
                  version(), report::machine_name(), report::compiler_name(), report.size.seed,
                  report.size.quick ? ", quick" : "", report::separation_arguments(report.size.separation));
  all.summary =
      without_marks(report::summary(report)) +
      " Point at a method to see its numbers. A faint one was asked a part of the queries: it is not compared "
      "with the others. A click on a column's name sorts by it.";
  all.how_to_read = without_marks(report::how_to_read(report));
  all.time_axis = "us a query";
  all.panels = {{"Missed, phantom or late", "% of the queries wrong"}, {"Greatest time error", "ulps"}};
  all.columns = {"queries", "mean us", "missed", "phantom", "late", "time error, median ulps", "earliest", "latest"};
  all.columns.insert(all.columns.end(), report::kPercentileNames.begin(), report::kPercentileNames.end());
  for (const report::SetResults& set : report.sets) {
    view::MeasuredSet shown;
    shown.name = set.set.name;
    shown.about = fmt::format("{}. {} queries, {} with contact. {}", set.set.about, set.set.size(), set.set.contacts(),
                              without_marks(report::front_sentence(set.results)));
    for (const report::Result& result : set.results) {
      if (result.asked > 0) shown.methods.push_back(measured(result, set.set));
    }
    all.sets.push_back(std::move(shown));
  }
  return view::page_text(view::measurements_page(all));
}

}  // namespace touchstone::cli
