// SPDX-License-Identifier: MIT
#include "report/csv.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <touchstone/version.hpp>

#include "io/answers/answer_writer.hpp"
#include "io/times.hpp"
#include "report/machine.hpp"

namespace touchstone::report {
namespace {

constexpr const char* kOrigin = "version,machine,compiler,seed,quick,set,kind,";
constexpr const char* kCsvColumns =
    ",method,tolerance,tolerance_measures,set_queries,"
    "queries,contacts,missed,phantom,late,missed_share,phantom_share,late_share,wrong_share,times_compared,"
    "ulps_earliest,ulps_median,ulps_latest,ulps_median_magnitude,ulps_greatest_magnitude,passes,mean_us,"
    "fastest_pass_us,slowest_pass_us,p50_us,p90_us,p99_us,p99_9_us,slowest_us,level_filter,level_bracket,level_exact,"
    "level_oracle\n";

std::string tolerance_measures(const Contestant& contestant) {
  if (contestant.tolerance == 0) return "";
  if (contestant.thick != nullptr) return "share";
  const auto measured = contestant.curved != nullptr  ? contestant.curved->tolerance
                        : contestant.whole != nullptr ? contestant.whole->tolerance
                                                      : contestant.baseline->tolerance;
  return measured == baselines::Tolerance::length ? "length" : "share";
}

std::string numbers(const Result& result) {
  std::string text = fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},", result.asked, result.contacts,
                                 result.missed, result.phantom, result.late, result.missed_fraction(),
                                 result.phantom_fraction(), result.late_fraction(), result.wrong_fraction());
  if (const auto& error = result.time_error) {
    text += fmt::format("{},{},{},{},{},{},", error->claims, error->earliest, error->median, error->latest,
                        error->median_size, error->greatest_size);
  } else {
    text += "0,,,,,,";
  }
  const auto [fastest, slowest] = std::minmax_element(result.passes.begin(), result.passes.end());
  text += fmt::format("{},{:.6g},{:.6g},{:.6g}", result.passes.size(), result.mean, *fastest, *slowest);
  for (const double percentile : result.percentiles) text += fmt::format(",{:.6g}", percentile);
  if (result.contestant.may_be_wrong()) return text + ",,,,";
  const LevelCounts& levels = result.levels;
  return text + fmt::format(",{},{},{},{}", levels.filter, levels.bracket, levels.exact, levels.oracle);
}

std::string not_asked() {
  const std::string header = kCsvColumns;
  const std::string from_queries = header.substr(header.find(",queries,") + 1);
  std::string text(1, '0');
  text.append(static_cast<std::size_t>(std::count(from_queries.begin(), from_queries.end(), ',')), ',');
  return text;
}

}  // namespace

std::string csv_header(const std::string& exponent_column, const Separation& separation) {
  const std::string columns = kCsvColumns;
  return kOrigin + exponent_column +
         (separation.distance == 0 ? columns : columns.substr(0, columns.size() - 1) + ",separation,metric\n");
}

std::string csv_rows(const Size& size, const std::vector<SetResults>& sets) {
  const std::string origin = fmt::format("{},{},{},{},{}", io::csv_field(version()), io::csv_field(machine_name()),
                                         io::csv_field(compiler_name()), size.seed, size.quick ? 1 : 0);
  std::string text;
  for (const SetResults& set : sets) {
    const Separation& separation = set.set.separation;
    std::string end;
    if (separation.distance > 0) {
      end = fmt::format(",{},{}", separation.distance, name_of(separation.metric));
    }
    for (const Result& result : set.results) {
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{}{}\n", origin, set.set.name, set.set.kind_name(), set.exponent,
                      result.contestant.name, result.contestant.tolerance_text(), tolerance_measures(result.contestant),
                      set.set.size(), result.asked > 0 ? numbers(result) : not_asked(), end);
    }
  }
  return text;
}

std::string csv_text(const Report& report) {
  return csv_header("scale_exponent", report.size.separation) + csv_rows(report.size, report.sets) +
         csv_rows(report.size, report.scales);
}

}  // namespace touchstone::report
