// SPDX-License-Identifier: MIT
#include "cli/bench/clock.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <string>

namespace touchstone::cli {
namespace {

/// Benchmarks are named by their action's index.
class Collector final : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::size_t actions) : seconds(actions) {}

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      seconds[std::stoul(run.run_name.function_name)].push_back(run.cpu_accumulated_time /
                                                                static_cast<double>(run.iterations));
    }
  }

  std::vector<std::vector<double>> seconds;
};

}  // namespace

void require_benchmark_library() {}

std::vector<std::vector<double>> measure(const std::vector<std::function<void()>>& actions, int repetitions,
                                         double min_time) {
  std::string program = "touchstone", interleave = "--benchmark_enable_random_interleaving=true";
  std::array<char*, 3> arguments{program.data(), interleave.data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments.data());
  for (std::size_t i = 0; i < actions.size(); ++i) {
    benchmark::RegisterBenchmark(std::to_string(i).c_str(),
                                 [&action = actions[i]](benchmark::State& state) {
                                   for (auto _ : state) action();
                                 })
        ->MinTime(min_time)
        ->Repetitions(repetitions);
  }
  Collector collector(actions.size());
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  return collector.seconds;
}

}  // namespace touchstone::cli
