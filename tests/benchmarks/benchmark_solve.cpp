// Microseconds a query: every method, on the public queries and on every seeded family, beside the floor.
//
//     benchmark_solve [--data=FOLDER] [--benchmark_filter=public/fast] [--benchmark_format=csv] ...
//
// FOLDER defaults to the environment variable TOUCHSTONE_QUERY_DATA. `us` is the mean over the set, the least of
// several runs; `slowest_us` is its slowest query, the best of three tries; `ratio` is the mean over the floor's.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "benchmarks/floor.hpp"
#include "benchmarks/query_sets.hpp"

namespace touchstone::benchmarks {
namespace {

constexpr std::size_t kQueriesOfEachKind = 250;

void ask_floor(const Query& query) { benchmark::DoNotOptimize(bernstein_coefficients(query)); }
void ask_fast(const Query& query) { benchmark::DoNotOptimize(solve(query, {.method = Method::fast})); }
void ask_exact(const Query& query) { benchmark::DoNotOptimize(solve(query, {.method = Method::exact})); }
void ask_oracle(const Query& query) { benchmark::DoNotOptimize(solve(query, {.method = Method::oracle})); }

using Ask = void (*)(const Query&);

double seconds(Ask ask, const Query& query) {
  const auto start = std::chrono::steady_clock::now();
  ask(query);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The slowest query, each by the best of three tries.
double slowest_seconds(Ask ask, const std::vector<Query>& queries) {
  double slowest = 0;
  for (const Query& query : queries) {
    slowest = std::max(slowest, std::min({seconds(ask, query), seconds(ask, query), seconds(ask, query)}));
  }
  return slowest;
}

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

// The least mean of three passes over the set, for the ratio.
double floor_seconds(const std::vector<Query>& queries) {
  double best = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < 3; ++pass) {
    const auto start = std::chrono::steady_clock::now();
    for (const Query& query : queries) ask_floor(query);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best / static_cast<double>(queries.size());
}

void measure(benchmark::State& state, const QuerySet& set, Ask ask) {
  double spent = 0;
  std::size_t asked = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    for (const Query& query : set.queries) ask(query);
    spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    asked += set.queries.size();
  }
  const double mean = spent / static_cast<double>(asked);
  state.counters["queries"] = static_cast<double>(set.queries.size());
  state.counters["us"] = 1e6 * mean;
  state.counters["slowest_us"] = 1e6 * slowest_seconds(ask, set.queries);
  state.counters["ratio"] = mean / floor_seconds(set.queries);
}

void measure_batch(benchmark::State& state, const QuerySet& set, int threads) {
  BatchOptions options;
  options.threads = threads;
  std::vector<Answer> answers(set.queries.size());
  double spent = 0;
  std::size_t asked = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    solve_batch(set.queries.data(), set.queries.size(), answers.data(), options);
    spent += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    asked += set.queries.size();
  }
  const LevelCounts levels = count_levels(answers);
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(answers.size());
  };
  state.counters["queries"] = static_cast<double>(set.queries.size());
  state.counters["us"] = 1e6 * spent / static_cast<double>(asked);
  state.counters["filter"] = share(levels.filter);
  state.counters["bracket"] = share(levels.bracket);
  state.counters["exact"] = share(levels.exact);
}

void tune(benchmark::internal::Benchmark* entry) {
  entry->Unit(benchmark::kMillisecond)->MinTime(0.05)->Repetitions(3);
  entry->ComputeStatistics("min", least)->ReportAggregatesOnly(true)->UseRealTime();
}

void register_set(const QuerySet& set) {
  const auto entry = [&](const char* name, Ask ask) {
    tune(benchmark::RegisterBenchmark((set.name + "/" + name).c_str(),
                                      [&set, ask](benchmark::State& state) { measure(state, set, ask); }));
  };
  entry("floor", ask_floor);
  entry("fast", ask_fast);
  entry("exact", ask_exact);
  entry("oracle", ask_oracle);
  for (const int threads : {1, 2}) {
    const std::string name = set.name + "/batch-" + std::to_string(threads);
    tune(benchmark::RegisterBenchmark(
        name.c_str(), [&set, threads](benchmark::State& state) { measure_batch(state, set, threads); }));
  }
}

// Takes --data=FOLDER out of the arguments, which Google Benchmark would not know.
std::string data_folder(int& argc, char** argv) {
  const char* environment = std::getenv("TOUCHSTONE_QUERY_DATA");
  std::string folder = environment == nullptr ? "" : environment;
  constexpr const char* kFlag = "--data=";
  const auto is_flag = [&](const char* argument) { return std::strncmp(argument, kFlag, std::strlen(kFlag)) == 0; };
  char** const last = argv + argc;
  for (char** argument = argv + 1; argument < last; ++argument) {
    if (is_flag(*argument)) folder = *argument + std::strlen(kFlag);
  }
  argc = static_cast<int>(std::remove_if(argv + 1, last, is_flag) - argv);
  return folder;
}

int run(int argc, char** argv) {
  const std::string folder = data_folder(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  std::vector<QuerySet> sets = public_sets(folder);
  if (sets.empty()) std::fprintf(stderr, "no public queries: neither --data nor TOUCHSTONE_QUERY_DATA is set\n");
  for (QuerySet& set : family_sets(kQueriesOfEachKind)) sets.push_back(std::move(set));
  for (const QuerySet& set : sets) register_set(set);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace
}  // namespace touchstone::benchmarks

int main(int argc, char** argv) {
  try {
    return touchstone::benchmarks::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_solve: %s\n", error.what());
    return 2;
  }
}
