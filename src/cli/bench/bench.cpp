// SPDX-License-Identifier: MIT
#include "cli/bench/bench.hpp"

#include <fmt/format.h>
#include <regex.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>

#include <touchstone/error.hpp>

#include "cli/bench/methods.hpp"
#include "cli/bench/results.hpp"
#include "cli/bench/sets.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/output_names.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/output_file.hpp"
#include "io/queries/kind_of_file.hpp"
#include "report/timing.hpp"
#include "solver/owned_columns.hpp"

namespace touchstone::cli {
namespace {

/// One method on one set: the queries, and room for the answers.
struct Entry {
  const BenchSet* set = nullptr;
  BenchMethod method = BenchMethod::floor;
  std::vector<Query> queries;
  solver::OwnedColumns columns;     // of the same queries
  std::vector<CurvedQuery> curved;  // in place of the queries, where the set is curved and the method takes such
  std::vector<Answer> answers;

  std::size_t size() const { return queries.size() + curved.size(); }

  void ask(const Separation& separation) {
    if (curved.empty()) {
      ask_all(method, queries, columns.view(), separation, answers);
    } else {
      ask_all(method, curved, separation, answers);
    }
  }
};

Entry entry_of(const BenchSet& set, BenchMethod method) {
  const bool curved = set.is_curved() && !is_of_straight(method);
  const std::size_t most = most_queries(method);
  std::vector<Query> queries = curved ? std::vector<Query>() : spread(set.queries, most);
  solver::OwnedColumns columns(method == BenchMethod::columns ? queries : std::vector<Query>());
  Entry entry{&set, method, std::move(queries), std::move(columns), {}, {}};
  if (curved) entry.curved = spread(set.curved, most);
  entry.answers.resize(entry.size());
  return entry;
}

/// A regular expression of POSIX's extended sort.
class NamePattern {
 public:
  explicit NamePattern(const std::string& text)
      : is_valid_(::regcomp(&compiled_, text.c_str(), REG_EXTENDED | REG_NOSUB) == 0) {}
  NamePattern(const NamePattern&) = delete;
  NamePattern& operator=(const NamePattern&) = delete;
  ~NamePattern() {
    if (is_valid_) ::regfree(&compiled_);
  }

  bool is_valid() const noexcept { return is_valid_; }
  bool matches(const std::string& name) const noexcept {
    return ::regexec(&compiled_, name.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  ::regex_t compiled_;
  bool is_valid_;
};

/// Whether the filter can match the name of any measurement of this source.
bool may_choose(const std::string& source, const std::string& filter) {
  const NamePattern pattern(filter);
  for (const Kind kind : kKinds) {
    for (const char* subset : {"all", "hits", "misses"}) {
      for (const BenchMethod method : kBenchMethods) {
        const std::string name = fmt::format("{}/{}/{}/{}", source, name_of(kind), subset, bench_method_name(method));
        if (pattern.matches(name)) return true;
      }
    }
  }
  return false;
}

/// The measurements whose "set/method" matches the filter, and of each set that has one the floor and, where it is
/// curved, the straight twins.
std::vector<Entry> chosen_entries(const std::vector<BenchSet>& sets, const BenchOptions& options) {
  const NamePattern pattern(options.filter);
  std::vector<Entry> entries;
  for (const BenchSet& set : sets) {
    const auto is_chosen = [&](BenchMethod method) {
      if (!takes(method, set.is_curved(), options.separation.separation)) return false;
      return pattern.matches(set.name + "/" + std::string(bench_method_name(method)));
    };
    if (std::none_of(kBenchMethods.begin(), kBenchMethods.end(), is_chosen)) continue;
    for (const BenchMethod method : kBenchMethods) {
      const bool is_measure = method == BenchMethod::floor || (set.is_curved() && method == BenchMethod::straight);
      if (is_measure || is_chosen(method)) entries.push_back(entry_of(set, method));
    }
  }
  return entries;
}

BenchResult result_of(Entry& entry, const std::vector<double>& seconds, const Separation& separation) {
  throw_if_interrupted();
  BenchResult result;
  result.set = entry.set->name;
  result.method = entry.method;
  result.queries = entry.size();
  result.set_size = entry.set->queries.size();
  for (const Answer& answer : entry.set->answers) result.contacts += answer.contact;
  for (const double pass : seconds) result.nanoseconds.push_back(1e9 * pass / static_cast<double>(result.queries));
  result.slowest_microseconds = entry.curved.empty() ? slowest_microseconds(entry.method, entry.queries, separation)
                                                     : slowest_microseconds(entry.method, entry.curved, separation);
  if (entry.method != BenchMethod::floor && !is_baseline(entry.method)) result.levels = count_levels(entry.answers);
  if (entry.method == BenchMethod::touchstone && entry.curved.empty() && separation.distance == 0) {
    for (const Query& query : entry.queries) ++result.rungs[solver::answer_and_rung(query, 1).rung];
  }
  return result;
}

std::vector<BenchResult> measured(std::vector<Entry>& entries, const BenchOptions& options) {
  if (::isatty(STDERR_FILENO) == 1) {
    const double passes = static_cast<double>(entries.size()) * options.repetitions;
    print_error(fmt::format("measuring {} for {:.0f} s or more\n", counted(entries.size(), "entry"),
                            passes * options.min_time));
  }
  const Separation& separation = options.separation.separation;
  std::vector<std::function<void()>> actions;
  for (Entry& entry : entries) {
    actions.push_back([&entry, &separation] {
      throw_if_interrupted();
      entry.ask(separation);
    });
  }
  const auto seconds = report::seconds_of_calls(actions, options.repetitions, options.min_time);
  std::vector<BenchResult> results;
  double floor = 0, straight = 0;  // of the set; each set's entries begin with them
  for (std::size_t i = 0; i < entries.size(); ++i) {
    results.push_back(result_of(entries[i], seconds[i], separation));
    if (entries[i].method == BenchMethod::floor) floor = results.back().median();
    if (entries[i].method == BenchMethod::straight) straight = results.back().median();
    results.back().ratio = results.back().median() / floor;
    if (entries[i].set->is_curved() && entries[i].method != BenchMethod::floor) {
      results.back().ratio_to_straight = results.back().median() / straight;
    }
  }
  return results;
}

std::string check_regex(const std::string& text) {
  // A pattern of nested repetitions takes memory that grows with each level.
  constexpr std::size_t kLongest = 1000;
  if (text.size() > kLongest) return text + " is longer than " + std::to_string(kLongest) + " characters";
  return NamePattern(text).is_valid() ? "" : text + " is no regular expression";
}

}  // namespace

int run_bench(const BenchOptions& options) {
  std::vector<io::OutputFile> outputs;
  for (const auto& name : {options.csv, options.json}) {
    refuse_to_overwrite(name, options.files);
    if (!name.empty()) outputs.emplace_back(name);
  }
  const std::vector<BenchSet> sets =
      bench_sets(options, [&](const std::string& source) { return may_choose(source, options.filter); });
  std::vector<Entry> entries = chosen_entries(sets, options);
  if (entries.empty()) throw InvalidQuery("no entry matches --filter " + options.filter);
  const std::vector<BenchResult> results = measured(entries, options);

  if (!options.csv.empty()) outputs.front().write(bench_csv(results));
  if (!options.json.empty()) outputs.back().write(bench_json(results, options));
  for (auto& output : outputs) output.commit();
  auto console = io::OutputFile::standard_output();
  const Separation& separation = options.separation.separation;
  if (separation.distance > 0) console.write(separation_for_person(separation) + "\n\n");
  console.write(bench_table(results));
  console.commit();
  return kAllHold;
}

void add_bench(CLI::App& program, Command& command) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* const subcommand = program.add_subcommand("bench", "Measure how long answers take, as ratios to a floor");
  subcommand->add_option("FILE", options->files, "Query files to measure as well, as the source `files`")
      ->type_name("");
  add_kind_option(*subcommand, options->kind);
  subcommand
      ->add_option(
          "--filter", options->filter,
          "Only entries whose name SOURCE/KIND/PART/METHOD matches this regular expression; the floor of a set is "
          "always measured")
      ->type_name("REGEX")
      ->check(check_regex);
  subcommand
      ->add_option("--repetitions", options->repetitions,
                   "The number of repetitions, of which the median counts (default: 5)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  subcommand
      ->add_option("--min-time", options->min_time,
                   "The least length of a repetition, from 1e-6 to 100 (default: 0.05)")
      ->type_name("SECONDS")
      ->check(check_range("from 1e-6 to 100", [](double x) { return x >= 1e-6 && x <= 100; }));
  subcommand
      ->add_option("--count", options->count,
                   "The number of queries to generate of each kind, by scene and at random (default: 4000)")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  add_separation_options(
      *subcommand, options->separation,
      "The distance at which two elements are in contact; candidates then come that near, and in the "
      "Euclidean metric thick_polynomial and thick_advancement are measured, too");
  subcommand->add_option("--csv", options->csv, "Write every number to this file as CSV")
      ->type_name("FILE")
      ->check(named_as(Output::csv));
  subcommand->add_option("--json", options->json, "Write every number and repetition to this file as JSON")
      ->type_name("FILE")
      ->check(named_as(Output::json));
  subcommand->footer(
      "SOURCE is simulation (candidate pairs of the three scenes of touchstone generate), random (doubles), bundled\n"
      "(degenerate queries) or files; a scene of touchstone generate along the axes, boxes, bricks, plane, grid or\n"
      "lying, or one of them in another placement, boxes-turned, grid-float32 and so on; or of curved motion\n"
      "link-chain and nut-and-bolt (candidate pairs of these scenes of touchstone simulate), bundled-curved or\n"
      "files-curved. PART is all, hits (with contact) or misses.\n\n"
      "METHOD is floor (reads the query, of a curved set the straight one, and computes the coplanarity cubic's\n"
      "four Bernstein coefficients, deciding nothing), straight (curved sets only: solve of the same pairs, moving\n"
      "straight between the same ends), touchstone (solve), touchstone_contact and touchstone_time (solve with\n"
      "Wanted::contact and Wanted::time; straight sets only), touchstone_batch (one thread), touchstone_columns (the\n"
      "same, structure of arrays), touchstone_cgal (solve by Method::fast_cgal: CGAL where the filters are\n"
      "uncertain), exact (exact arithmetic alone), oracle (a few queries) or prove (solve, and a proof of the answer\n"
      "as touchstone prove writes it).\n\n"
      "Times are processor time: the median of the repetitions, which run in random order. `x floor` is the ratio to\n"
      "the floor of the same set and run; it can be compared across machines. The slowest single query is the best\n"
      "of three tries. The last columns are the percentages of answers that each level decided, and\n"
      "the line below `touchstone` those of each rung of the ladder, which docs/design.md draws.\n\n"
      "Examples\n"
      "  touchstone bench --filter simulation\n"
      "  touchstone bench --filter 'all/(touchstone|floor)' --repetitions 9 --csv bench.csv data/*/*.csv\n\n"
      "Exit status: 0 done, 2 bad usage or bad input.");
  subcommand->callback([options, &command] { command = [options] { return run_bench(*options); }; });
}

}  // namespace touchstone::cli
