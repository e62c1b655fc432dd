// SPDX-License-Identifier: MIT
#include "generators/candidates.hpp"

#include <array>
#include <string>

#include <touchstone/error.hpp>

#include "generators/step.hpp"
#include "seeded/rng.hpp"

namespace touchstone::generators {
namespace {

void check(const CandidateOptions& options) {
  if (options.edges < kFewestEdges || options.edges > kMostEdges) {
    throw InvalidQuery("a scene of " + std::to_string(options.edges) + " edges; it must have between " +
                       std::to_string(kFewestEdges) + " and " + std::to_string(kMostEdges));
  }
  if (!(options.speed >= 0 && options.speed <= kGreatestSpeed)) {
    throw InvalidQuery("the speed is " + std::to_string(options.speed) + "; it must be in [0, 1000]");
  }
}

/// Collects queries and passes them on in batches.
class Batches {
 public:
  Batches(const std::function<void(const Batch&)>& take, std::size_t step, Kind kind) : take_(take) {
    batch_.step = step;
    batch_.kind = kind;
  }

  void add(const Query& query) {
    batch_.queries.push_back(query);
    if (batch_.queries.size() == kBatchQueries) flush();
  }

  void flush() {
    if (batch_.queries.empty()) return;
    take_(batch_);
    batch_.queries.clear();
  }

 private:
  const std::function<void(const Batch&)>& take_;
  Batch batch_;
};

/// Passes on `count` of the step's candidates, each with the same probability, or all if there are no more. It is
/// reservoir sampling: the n-th candidate replaces an earlier one with probability count / n. @returns how many
std::uint64_t hand_out(const Step& step, Batches& batches, Kind kind, bool shared_corners, std::uint64_t count,
                       seeded::Rng random) {
  std::vector<std::array<Index, 2>> drawn;
  std::uint64_t seen = 0;
  step.for_each_candidate(kind, shared_corners, [&](Index i, Index j) {
    ++seen;
    if (drawn.size() < count) {
      drawn.push_back({i, j});
    } else if (const std::uint64_t slot = random.below(seen); slot < count) {
      drawn[slot] = {i, j};
    }
  });
  for (const auto& [i, j] : drawn) batches.add(step.query(kind, i, j));
  return drawn.size();
}

}  // namespace

CandidateCounts for_each_batch(const CandidateOptions& options, const std::function<void(const Batch&)>& take) {
  check(options);
  Step step(options.scene, options.seed, options.edges, options.speed, options.separation, options.placement);
  CandidateCounts counts;
  const auto hand_out_kind = [&](Kind kind, std::size_t number, std::uint64_t& handed_out) {
    Batches batches(take, number, kind);
    if (options.count == 0) {
      step.for_each_candidate(kind, options.shared_corners, [&](Index i, Index j) {
        batches.add(step.query(kind, i, j));
        ++handed_out;
      });
    } else {
      // Later steps may fill the count that earlier ones could not.
      const std::uint64_t steps_left = options.steps - number;
      const std::uint64_t count = (options.count - handed_out + steps_left - 1) / steps_left;
      const seeded::Rng random(
          seeded::seed_of_stream(options.seed, 2 + 2 * number + (kind == Kind::edge_edge ? 0 : 1)));
      handed_out += hand_out(step, batches, kind, options.shared_corners, count, random);
    }
    batches.flush();
  };
  for (std::size_t number = 0; number < options.steps; ++number) {
    step.advance();
    if (options.edge_edge) hand_out_kind(Kind::edge_edge, number, counts.edge_edge);
    if (options.vertex_face) hand_out_kind(Kind::vertex_face, number, counts.vertex_face);
  }
  return counts;
}

std::vector<Query> candidates(const CandidateOptions& options) {
  std::vector<Query> all;
  for_each_batch(options,
                 [&all](const Batch& batch) { all.insert(all.end(), batch.queries.begin(), batch.queries.end()); });
  return all;
}

}  // namespace touchstone::generators
