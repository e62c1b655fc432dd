// SPDX-License-Identifier: MIT
#include "stress/stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <touchstone/solve.hpp>

#include "report/csv.hpp"
#include "report/pictures/drawing.hpp"

namespace touchstone::stress {
namespace {

constexpr double kMeasuring = 0.9;          ///< fraction of the time; the rest is drawing
constexpr std::size_t kOracleQueries = 10;  ///< of each set; one takes as long as hundreds of the others

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
          progress(fmt::format("{} 2^{}", dial->name, setting),
                   kMeasuring * static_cast<double>(done) / static_cast<double>(sets));
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

std::string write_stress(const Stress& stress, const std::string& folder, const report::Progress& progress) {
  const std::filesystem::path root = folder;
  report::make_folder(root / "plots");
  std::string csv = report::csv_header("dial_exponent", stress.options.separation);
  for (const Table& table : stress.tables) csv += report::csv_rows({false, stress.options.seed}, table.settings);
  report::write_whole(root / "stress.csv", csv);
  const auto drawing = [&](double fraction) { progress("drawing", kMeasuring + (1 - kMeasuring) * fraction); };
  const std::string hint = report::write_plots(plots(stress), root / "plots", drawing);
  report::write_whole(root / "stress.md", markdown_text(stress, hint.empty()));
  return hint;
}

}  // namespace touchstone::stress
