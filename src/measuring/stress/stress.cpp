// SPDX-License-Identifier: MIT
#include "stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include <touchstone/solve.hpp>

#include "io/write_whole.hpp"
#include "report/csv.hpp"
#include "report/pictures/pictures.hpp"
#include "view/chart.hpp"

namespace touchstone::stress {
namespace {

constexpr std::size_t kOracleQueries = 10;  ///< of each set; one takes as long as hundreds of the others

/// A fraction of fewer queries is mostly chance.
constexpr std::size_t kFewest = 20;

/// Wall-clock seconds: of one pass of one method over one set, and the least that is measured.
const report::Effort kEffort{0.02, 3, 0.001, 1, true};

/// Every method, at the tolerance that its users commonly choose. `fast_cgal` is left out: it would take most of the
/// time, and CGAL takes part as the oracle.
std::vector<report::Contestant> usual_contestants(const Separation& separation) {
  std::vector<double> tolerances;
  for (const auto& method : baselines::methods()) {
    if (method.has_tolerance()) tolerances.push_back(method.usual_tolerance);
  }
  std::sort(tolerances.begin(), tolerances.end());
  tolerances.erase(std::unique(tolerances.begin(), tolerances.end()), tolerances.end());
  std::vector<report::Contestant> usual;
  for (const report::Contestant& contestant : report::contestants(tolerances, separation)) {
    if (contestant.is_usual() && contestant.competes()) usual.push_back(contestant);
  }
  return usual;
}

bool same_decision(const Answer& one, const Answer& other) {
  if (one.contact != other.contact) return false;
  return !one.contact || (one.toi == other.toi && one.toi_upper == other.toi_upper && one.nature == other.nature &&
                          one.feature_a == other.feature_a && one.feature_b == other.feature_b);
}

void ask_oracle(const report::SetResults& set, Stress& stress) {
  if (!has_method(Method::oracle)) return;
  const auto& queries = set.set.queries;
  for (std::size_t i = 0; i < std::min(kOracleQueries, queries.size()); ++i) {
    ++stress.oracle_asked;
    const Answer second = solve(queries[i], {.separation = set.set.separation, .method = Method::oracle});
    if (same_decision(set.set.truth[i], second)) continue;
    stress.oracle_differs.push_back(fmt::format("{}, setting {}, query {}", set.set.name, set.exponent, i));
  }
}

report::Picture picture_of(const Table& table) {
  const view::ChartAxis x{fmt::format("{}, 2 to the power of", table.dial->varies)};
  const view::Chart wrong{"Wrong answers: missed, phantom or late", x, {"% of the queries"}, {}};
  const view::Chart time{"Mean run time", x, {"us per query", true}, {}};
  const auto wrong_of = [](const report::Result& result) -> std::optional<double> {
    if (result.asked < kFewest) return std::nullopt;
    return 100 * result.wrong_fraction();
  };
  bool withheld = false;
  for (const report::SetResults& setting : table.settings) {
    for (const report::Result& result : setting.results) withheld |= result.asked > 0 && result.asked < kFewest;
  }
  const std::string subtitle =
      withheld ? fmt::format("wrong answers are drawn from {} queries on: some methods were asked fewer", kFewest) : "";
  const std::string name = picture_name(table);
  return {name, view::chart_file(
                    "Stability: " + table.settings.front().set.name, subtitle,
                    {report::chart_of_settings(table.settings, wrong, wrong_of),
                     report::chart_of_settings(table.settings, time, [](const report::Result& r) { return r.mean; })})};
}

}  // namespace

Stress run_stress(const Options& options, const report::Progress& progress) {
  Stress stress;
  stress.options = options;
  stress.contestants = usual_contestants(options.separation);
  std::vector<const Dial*> which = options.which;
  if (which.empty()) {
    for (const Dial& dial : dials()) which.push_back(&dial);
  }
  std::size_t sets = 0, done = 0;
  for (const Dial* dial : which) sets += kAskedKinds.size() * dial->settings.size();
  for (const Dial* dial : which) {
    for (const Kind kind : kAskedKinds) {
      Table& table = stress.tables.emplace_back(Table{dial, kind, {}});
      for (const int setting : dial->settings) {
        const auto pulse = [&] {
          progress(fmt::format("{} 2^{}", dial->name, setting), static_cast<double>(done) / static_cast<double>(sets));
        };
        auto set = make_set(*dial, kind, setting, options.seed, options.count);
        set.separation = options.separation;
        table.settings.push_back(report::measure(std::move(set), stress.contestants, kEffort, pulse));
        table.settings.back().exponent = setting;
        ask_oracle(table.settings.back(), stress);
        ++done;
      }
    }
  }
  return stress;
}

const report::Result& own_result(const report::SetResults& setting) {
  return *std::find_if(setting.results.begin(), setting.results.end(),
                       [](const report::Result& result) { return result.contestant.is_touchstone(); });
}

std::size_t own_errors(const Stress& stress) {
  std::size_t errors = 0;
  for (const Table& table : stress.tables) {
    for (const auto& setting : table.settings) {
      const report::Result& own = own_result(setting);
      errors += own.wrong() > 0 ? own.wrong() : own.has_errors();
    }
  }
  return errors;
}

Growth growth(const Table& table) {
  Growth result;
  for (const auto& setting : table.settings) {
    const double mean = own_result(setting).mean;
    if (setting.exponent == table.dial->gentle) result.gentle = mean;
    if (mean > result.slowest) {
      result.slowest = mean;
      result.slowest_at = setting.exponent;
    }
  }
  result.low = own_result(table.settings.front()).mean;
  result.high = own_result(table.settings.back()).mean;
  return result;
}

std::string picture_name(const Table& table) { return report::picture_name("", table.settings.front()); }

void write_stress(const Stress& stress, const std::string& folder) {
  const std::filesystem::path root = folder;
  std::string csv = report::csv_header("dial_exponent", stress.options.separation);
  std::vector<report::Picture> pictures;
  for (const Table& table : stress.tables) {
    csv += report::csv_rows({false, stress.options.seed}, table.settings);
    pictures.push_back(picture_of(table));
  }
  io::write_whole((root / "stress.csv").string(), csv);
  report::write_pictures(pictures, root / "plots");
  io::write_whole((root / "stress.md").string(), markdown_text(stress));
}

}  // namespace touchstone::stress
