// Batches in columns beside the same queries one by one, by the percentage of queries that the first test leaves.
//
//     benchmark_columns [REPETITIONS]
//
// The queries are candidate pairs of the scenes of `touchstone generate`, mixed so that the first test leaves so many
// of them. A line has medians of processor time in nanoseconds a query, on one thread: `solve` in turn with
// `solve_batch` in columns, with vectors of each width that the machine has; and the ratio of the first to the widest.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <vector>

#include <touchstone/solve.hpp>

#include "filters/apart/same_side.hpp"
#include "generators/candidates.hpp"
#include "seeded/rng.hpp"
#include "solver/owned_columns.hpp"

namespace touchstone::benchmarks {
namespace {

constexpr std::size_t kQueries = 10'000;

struct Width {
  VectorWidth width;
  const char* name;
};
constexpr Width kWidths[] = {{VectorWidth::none, "none"},
                             {VectorWidth::bits_128, "128"},
                             {VectorWidth::bits_256, "256"},
                             {VectorWidth::bits_512, "512"}};

/// Candidate pairs, and whether the first test leaves them.
struct Candidates {
  std::vector<Query> left, proved;
};

Candidates candidates_of(Kind kind) {
  Candidates candidates;
  for (const auto scene : generators::kScenes) {
    generators::CandidateOptions options;
    options.scene = scene;
    options.count = 20'000;
    options.edge_edge = kind == Kind::edge_edge;
    options.vertex_face = !options.edge_edge;
    for (const Query& query : generators::candidates(options))
      (filters::same_side(query) ? candidates.proved : candidates.left).push_back(query);
  }
  return candidates;
}

std::vector<Query> mixed(const Candidates& candidates, std::size_t percentage) {
  seeded::Rng rng(1);
  std::vector<Query> queries;
  while (queries.size() < kQueries) {
    const std::vector<Query>& from = rng.below(100) < percentage ? candidates.left : candidates.proved;
    queries.push_back(from[rng.below(from.size())]);
  }
  return queries;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Nanoseconds a query of each action, the medians of passes in turn.
std::vector<double> measured(const std::vector<std::function<void()>>& actions, int repetitions) {
  constexpr int kPasses = 20;
  std::vector<std::vector<double>> times(actions.size());
  for (int i = 0; i < repetitions; ++i) {
    for (std::size_t k = 0; k < actions.size(); ++k) {
      const double begin = processor_seconds();
      for (int pass = 0; pass < kPasses; ++pass) actions[k]();
      times[k].push_back(1e9 * (processor_seconds() - begin) / (kPasses * static_cast<double>(kQueries)));
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& all : times) {
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    medians.push_back(all[all.size() / 2]);
  }
  return medians;
}

void measure(Kind kind, int repetitions) {
  const Candidates candidates = candidates_of(kind);
  std::printf("%s: the first test leaves %.1f %% of the candidates\n", name_of(kind).data(),
              100 * static_cast<double>(candidates.left.size()) /
                  static_cast<double>(candidates.left.size() + candidates.proved.size()));
  std::printf("  %%    solve");
  for (const auto& [width, name] : kWidths) {
    if (has_vectors(width)) std::printf("  %5s", name);
  }
  std::printf("  ratio\n");
  for (const std::size_t percentage : {0, 5, 10, 30, 50, 100}) {
    const std::vector<Query> queries = mixed(candidates, percentage);
    const solver::OwnedColumns columns(queries);
    std::vector<Answer> answers(queries.size());
    std::vector<std::function<void()>> actions = {[&] {
      for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = solve(queries[i]);
    }};
    for (const Width& each : kWidths) {
      if (!has_vectors(each.width)) continue;
      actions.push_back([&] {
        BatchOptions options;
        options.vectors = each.width;
        solve_batch(columns.view(), answers.data(), options);
      });
    }
    const std::vector<double> times = measured(actions, repetitions);
    std::printf("%3zu", percentage);
    for (const double time : times) std::printf("  %5.1f", time);
    std::printf("  %5.2f\n", times.front() / times.back());
  }
}

}  // namespace
}  // namespace touchstone::benchmarks

int main(int argc, char** argv) {
  try {
    const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
    for (const touchstone::Kind kind : {touchstone::Kind::edge_edge, touchstone::Kind::vertex_face})
      touchstone::benchmarks::measure(kind, repetitions);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_columns: %s\n", error.what());
    return 2;
  }
}
