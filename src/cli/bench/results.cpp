// SPDX-License-Identifier: MIT
#include "cli/bench/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <touchstone/version.hpp>

#include "cli/shared/words.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

using Json = nlohmann::ordered_json;

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }
double greatest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

std::string levels_for_person(const BenchResult& result) {
  if (result.method == BenchMethod::floor || is_baseline(result.method)) return {};
  const auto& levels = result.levels;
  if (result.method == BenchMethod::oracle)
    return fmt::format("{:>36} oracle", percentage(levels.oracle, result.queries));
  if (result.method == BenchMethod::cgal) {
    return fmt::format("{:>10}{:>10}{:>16} oracle", percentage(levels.filter, result.queries),
                       percentage(levels.bracket, result.queries), percentage(levels.oracle, result.queries));
  }
  return fmt::format("{:>10}{:>10}{:>10}", percentage(levels.filter, result.queries),
                     percentage(levels.bracket, result.queries), percentage(levels.exact, result.queries));
}

std::string rungs_for_person(const BenchResult& result) {
  std::string text;
  for (std::size_t i = 0; i < result.rungs.size(); ++i) {
    if (result.rungs[i] == 0) continue;
    text += fmt::format("{} {} {}", text.empty() ? "" : ";", solver::kLadder[i].name,
                        percentage(result.rungs[i], result.queries));
  }
  return text.empty() ? text : "    rungs:" + text + "\n";
}

bool has_straight_twins(const std::vector<BenchResult>& results, const std::string& set) {
  return std::any_of(results.begin(), results.end(),
                     [&](const BenchResult& result) { return result.set == set && result.ratio_to_straight; });
}

std::string line_for_person(const BenchResult& result, bool of_curves) {
  std::string name(bench_method_name(result.method));
  if (result.queries < result.set_size) name += fmt::format(" ({} of them)", grouped(result.queries));
  const std::string slowest = result.slowest_microseconds < 0 ? "" : fmt::format("{:.2f}", result.slowest_microseconds);
  std::string line = fmt::format("  {:<26}{:>12.1f}{:>12.2f}", name, result.median(), result.ratio);
  if (of_curves)
    line += fmt::format("{:>12}", result.ratio_to_straight ? fmt::format("{:.2f}", *result.ratio_to_straight) : "");
  line += fmt::format("{:>14}{}", slowest, levels_for_person(result));
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

Json json_of(const BenchResult& result) {
  Json json = {{"set", result.set},
               {"method", bench_method_name(result.method)},
               {"queries", result.queries},
               {"set_queries", result.set_size},
               {"set_contacts", result.contacts},
               {"median_ns", result.median()},
               {"repetitions_ns", result.nanoseconds},
               {"ratio_to_floor", result.ratio}};
  if (result.ratio_to_straight) json["ratio_to_straight"] = *result.ratio_to_straight;
  json["slowest_us"] = result.slowest_microseconds < 0 ? Json(nullptr) : Json(result.slowest_microseconds);
  json["levels"] = {{"filter", result.levels.filter},
                    {"bracket", result.levels.bracket},
                    {"exact", result.levels.exact},
                    {"oracle", result.levels.oracle}};
  for (std::size_t i = 0; i < result.rungs.size(); ++i) {
    if (result.rungs[i] > 0) json["rungs"][std::string(solver::kLadder[i].name)] = result.rungs[i];
  }
  return json;
}

}  // namespace

double BenchResult::median() const {
  std::vector<double> sorted = nanoseconds;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

std::string bench_table(const std::vector<BenchResult>& results) {
  std::string table;
  std::string set;
  bool of_curves = false;
  for (const BenchResult& result : results) {
    if (result.set != set) {
      set = result.set;
      const std::string title = fmt::format("{}: {}, {} with contact", set, counted(result.set_size, "query"),
                                            percentage(result.contacts, result.set_size));
      of_curves = has_straight_twins(results, set);
      const std::string straight = of_curves ? fmt::format("{:>12}", "x straight") : "";
      table += fmt::format("{}{}\n  {:<26}{:>12}{:>12}{}{:>14}{:>10}{:>10}{:>10}\n", table.empty() ? "" : "\n", title,
                           "", "ns a query", "x floor", straight, "slowest, us", "filter", "bracket", "exact");
    }
    table += line_for_person(result, of_curves) + rungs_for_person(result);
  }
  return table;
}

std::string bench_csv(const std::vector<BenchResult>& results) {
  std::string csv =
      "set,method,queries,set_queries,set_contacts,median_ns,least_ns,greatest_ns,ratio_to_floor,slowest_us,"
      "filter,bracket,exact,oracle,ratio_to_straight\n";
  for (const BenchResult& r : results) {
    csv += fmt::format("{},{},{},{},{},{:.3f},{:.3f},{:.3f},{:.4f},{},{},{},{},{},{}\n", r.set,
                       bench_method_name(r.method), r.queries, r.set_size, r.contacts, r.median(), least(r.nanoseconds),
                       greatest(r.nanoseconds), r.ratio,
                       r.slowest_microseconds < 0 ? "" : fmt::format("{:.3f}", r.slowest_microseconds), r.levels.filter,
                       r.levels.bracket, r.levels.exact, r.levels.oracle,
                       r.ratio_to_straight ? fmt::format("{:.4f}", *r.ratio_to_straight) : "");
  }
  return csv;
}

std::string bench_json(const std::vector<BenchResult>& results, const BenchOptions& options) {
  Json json = {{"touchstone", version()},
               {"compiler", compiler()},
               {"repetitions", options.repetitions},
               {"min_time_s", options.min_time},
               {"results", Json::array()}};
  if (const Separation& separation = options.separation.separation; separation.distance > 0) {
    json["separation"] = io::hexfloat(separation.distance);
    json["metric"] = name_of(separation.metric);
  }
  for (const BenchResult& result : results) json["results"].push_back(json_of(result));
  return json.dump(2) + "\n";
}

}  // namespace touchstone::cli
