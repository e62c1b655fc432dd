// SPDX-License-Identifier: MIT
#include "cli/bench/sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include <touchstone/curved.hpp>

#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "generators/candidates.hpp"
#include "io/queries/kind_of_file.hpp"
#include "report/sets/body_pairs.hpp"
#include "seeded/rng.hpp"

namespace touchstone::cli {
namespace {

constexpr std::uint64_t kSeed = 1;

template <class AnyQuery>
using AnyByKind = std::array<std::vector<AnyQuery>, 4>;
using ByKind = AnyByKind<Query>;
using CurvedByKind = AnyByKind<CurvedQuery>;

template <class AnyQuery>
std::vector<AnyQuery>& of_kind(AnyByKind<AnyQuery>& queries, Kind kind) {
  return queries[static_cast<std::size_t>(kind)];
}

void add_candidates(generators::CandidateOptions options, std::size_t count, const Separation& separation,
                    ByKind& queries) {
  options.seed = kSeed;
  options.count = count;
  options.separation = separation.distance;
  generators::for_each_batch(options, [&](const generators::Batch& batch) {
    throw_if_interrupted();
    auto& all = of_kind(queries, batch.kind);
    all.insert(all.end(), batch.queries.begin(), batch.queries.end());
  });
}

ByKind simulation_queries(std::size_t count, const Separation& separation) {
  ByKind queries;
  for (const auto scene : generators::kScenes) {
    generators::CandidateOptions options;
    options.scene = scene;
    add_candidates(options, count, separation, queries);
  }
  return queries;
}

/// Corners anywhere in a cube, at both ends; the cube's size is log-uniform from 2^-20 to 2^20.
ByKind random_queries(std::size_t count) {
  ByKind queries;
  seeded::Rng random(kSeed);
  for (const Kind kind : kKinds) {
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

/// The queries of files, straight or curved.
template <class AnyQuery>
AnyByKind<AnyQuery> queries_of(const std::vector<Input>& inputs) {
  AnyByKind<AnyQuery> queries;
  TurnNotes turns(inputs, io::Turns::as_given, kConvertForShorterTurns);
  const auto take = [&](std::size_t input, const io::QueryRecord& record) {
    const auto* const query = std::get_if<AnyQuery>(&record.query);
    if (query == nullptr) return;
    of_kind(queries, query->kind).push_back(*query);
    turns.add(input, record.longer_turns);
  };
  for_each_query(inputs, take, io::Motions::any);
  turns.tell();
  return queries;
}

bool is_finite(const Query& query) {
  const auto finite = [](const Vec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); };
  return std::all_of(query.start.begin(), query.start.end(), finite) &&
         std::all_of(query.end.begin(), query.end.end(), finite);
}

void append_sets(const std::string& source, const ByKind& queries, const Separation& separation,
                 std::vector<BenchSet>& sets) {
  BatchOptions options;
  options.separation = separation;
  for (const Kind kind : kKinds) {
    const std::string name = source + "/" + std::string(name_of(kind)) + "/";
    BenchSet all{name + "all", queries[static_cast<std::size_t>(kind)], {}, {}}, hits{name + "hits", {}, {}, {}},
        misses{name + "misses", {}, {}, {}};
    all.answers = solve_batch(all.queries, options);
    for (std::size_t i = 0; i < all.queries.size(); ++i) {
      BenchSet& subset = all.answers[i].contact ? hits : misses;
      subset.queries.push_back(all.queries[i]);
      subset.answers.push_back(all.answers[i]);
    }
    for (BenchSet* set : {&all, &hits, &misses}) {
      if (!set->queries.empty()) sets.push_back(std::move(*set));
    }
  }
}

/// The scenes along the axes as they are built and turned, as "boxes" and "boxes-turned"; in the other placements only
/// where a filter chooses them.
void append_aligned_sets(std::size_t count, const Separation& separation, bool filtered,
                         const std::function<bool(const std::string&)>& is_selected, std::vector<BenchSet>& sets) {
  for (const auto scene : generators::kAlignedScenes) {
    for (const auto placement : generators::kAllPlacements) {
      std::string source(generators::scene_name(scene));
      if (placement != generators::Placement::as_built) source.append("-").append(placement_name(placement));
      const bool usual = placement <= generators::Placement::turned;
      if (!is_selected(source) || !(usual || filtered)) continue;
      generators::CandidateOptions options;
      options.scene = scene;
      options.placement = placement;
      ByKind queries;
      add_candidates(options, count, separation, queries);
      append_sets(source, queries, separation, sets);
    }
  }
}

void append_curved_sets(const std::string& source, const CurvedByKind& queries, const Separation& separation,
                        std::vector<BenchSet>& sets) {
  for (const Kind kind : kKinds) {
    const std::string name = source + "/" + std::string(name_of(kind)) + "/";
    BenchSet all{name + "all", {}, {}, {}}, hits{name + "hits", {}, {}, {}}, misses{name + "misses", {}, {}, {}};
    for (const CurvedQuery& query : queries[static_cast<std::size_t>(kind)]) {
      const Query twin = report::straight_twin(query);
      if (!is_finite(twin)) continue;
      const Answer answer = solve(query, {.separation = separation});
      for (BenchSet* set : {&all, answer.contact ? &hits : &misses}) {
        set->queries.push_back(twin);
        set->curved.push_back(query);
        set->answers.push_back(answer);
      }
    }
    for (BenchSet* set : {&all, &hits, &misses}) {
      if (!set->queries.empty()) sets.push_back(std::move(*set));
    }
  }
}

void append_body_pairs(std::size_t count, const Separation& separation,
                       const std::function<bool(const std::string&)>& is_selected, std::vector<BenchSet>& sets) {
  report::BodyPairOptions pairs;
  pairs.count = count;
  pairs.separation = separation.distance;
  for (const std::string_view scene : report::kBodyScenes) {
    if (!is_selected(std::string(scene))) continue;
    CurvedByKind queries;
    for (report::QuerySet& set : report::body_pair_sets(scene, pairs, throw_if_interrupted)) {
      of_kind(queries, set.kind) = std::move(set.curved);
    }
    append_curved_sets(std::string(scene), queries, separation, sets);
  }
}

}  // namespace

std::vector<BenchSet> bench_sets(const BenchOptions& options,
                                 const std::function<bool(const std::string&)>& is_selected) {
  const std::vector<Input> given = find_inputs(options.files, options.kind);
  std::vector<BenchSet> sets;
  const Separation& separation = options.separation.separation;
  append_sets("simulation", simulation_queries(options.count, separation), separation, sets);
  append_sets("random", random_queries(options.count), separation, sets);
  append_sets("bundled", queries_of<Query>(bundled_touching_inputs()), separation, sets);
  append_sets("files", queries_of<Query>(given), separation, sets);
  append_aligned_sets(options.count, separation, !options.filter.empty(), is_selected, sets);
  append_body_pairs(options.count, separation, is_selected, sets);
  append_curved_sets("bundled-curved", queries_of<CurvedQuery>(bundled_touching_inputs(io::Motions::any)), separation,
                     sets);
  append_curved_sets("files-curved", queries_of<CurvedQuery>(given), separation, sets);
  return sets;
}

}  // namespace touchstone::cli
