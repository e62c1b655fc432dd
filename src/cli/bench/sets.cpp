// SPDX-License-Identifier: MIT
#include "cli/bench/sets.hpp"

#include <array>
#include <variant>

#include <touchstone/solve.hpp>

#include "cli/shared/inputs.hpp"
#include "cli/shared/interrupt.hpp"
#include "generators/candidates.hpp"
#include "io/kind_of_file.hpp"
#include "seeded/rng.hpp"

namespace touchstone::cli {
namespace {

constexpr std::uint64_t kSeed = 1;

using ByKind = std::array<std::vector<Query>, 4>;

std::vector<Query>& of_kind(ByKind& queries, Kind kind) { return queries[static_cast<std::size_t>(kind)]; }

ByKind simulation_queries(std::size_t count, const Separation& separation) {
  ByKind queries;
  for (const auto scene : generators::kScenes) {
    generators::CandidateOptions options;
    options.scene = scene;
    options.seed = kSeed;
    options.count = count;
    options.separation = separation.distance;
    generators::for_each_batch(options, [&](const generators::Batch& batch) {
      throw_if_interrupted();
      auto& all = of_kind(queries, batch.kind);
      all.insert(all.end(), batch.queries.begin(), batch.queries.end());
    });
  }
  return queries;
}

/// Corners anywhere in a cube, at both ends; the cube's size is log-uniform from 2^-20 to 2^20.
ByKind random_queries(std::size_t count) {
  ByKind queries;
  seeded::Rng random(kSeed);
  for (const Kind kind : io::kKinds) {
    for (std::size_t i = 0; i < count; ++i) {
      double size = 0x1p-20;
      for (std::uint64_t doublings = random.below(41); doublings > 0; --doublings) size *= 2;
      Query query;
      query.kind = kind;
      for (std::size_t k = 0; k < corner_count(kind); ++k) {
        for (auto* corner : {&query.start[k], &query.end[k]}) {
          corner->x = random.uniform(-size, size);
          corner->y = random.uniform(-size, size);
          corner->z = random.uniform(-size, size);
        }
      }
      of_kind(queries, kind).push_back(query);
    }
  }
  return queries;
}

ByKind queries_of(const std::vector<Input>& inputs) {
  ByKind queries;
  for_each_query(inputs, [&queries](std::size_t, const io::QueryRecord& record) {
    if (const Query* query = std::get_if<Query>(&record.query)) of_kind(queries, query->kind).push_back(*query);
  });
  return queries;
}

void append_sets(const std::string& source, const ByKind& queries, const Separation& separation,
                 std::vector<BenchSet>& sets) {
  BatchOptions options;
  options.separation = separation;
  for (const Kind kind : io::kKinds) {
    const std::string name = source + "/" + std::string(kind_name(kind)) + "/";
    BenchSet all{name + "all", queries[static_cast<std::size_t>(kind)], {}}, hits{name + "hits", {}, {}},
        misses{name + "misses", {}, {}};
    all.answers = solve_batch(all.queries, options);
    for (std::size_t i = 0; i < all.queries.size(); ++i) {
      BenchSet& part = all.answers[i].contact ? hits : misses;
      part.queries.push_back(all.queries[i]);
      part.answers.push_back(all.answers[i]);
    }
    for (BenchSet* set : {&all, &hits, &misses}) {
      if (!set->queries.empty()) sets.push_back(std::move(*set));
    }
  }
}

}  // namespace

std::vector<BenchSet> bench_sets(const BenchOptions& options) {
  const std::vector<Input> given = find_inputs(options.files, options.kind);
  std::vector<BenchSet> sets;
  const Separation& separation = options.separation.separation;
  append_sets("simulation", simulation_queries(options.count, separation), separation, sets);
  append_sets("random", random_queries(options.count), separation, sets);
  append_sets("bundled", queries_of(bundled_touching_inputs()), separation, sets);
  append_sets("files", queries_of(given), separation, sets);
  return sets;
}

}  // namespace touchstone::cli
