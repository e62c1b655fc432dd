// Which of the candidate pairs touch during a step, and when first.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <utility>

#include <touchstone/solve.hpp>

#include "contact/colliders.hpp"
#include "linear/cancellation.hpp"

namespace touchstone::sim {

/// The solver that finds contacts for the response. The proof always asks the exact one.
enum class NarrowPhase : std::uint8_t {
  exact,  ///< touchstone::solve
  paper   ///< as in the paper: the closed form in doubles for edges, which loses contacts, and nothing for faces; it
          ///< knows no separation
};

/// Sees a query, its separation and the answer.
using QuerySink = std::function<void(const Query&, double, const Answer&)>;

/// Answers to pairs[i], in order; the same for any number of threads. Elements are in contact within their separation.
class PairSolver {
 public:
  /// @param cancel  is checked before each block of pairs, and lives as long as this
  PairSolver(const Colliders& colliders, NarrowPhase narrow_phase, int threads,
             const linear::Cancellation& cancel = linear::Cancellation::never());

  /// For every contact in the order of `pairs`: found(index, answer). @returns how many each level decided
  template <class Found>
  LevelCounts contacts(const std::vector<Pair>& pairs, const VectorX& x0, const VectorX& x1, Found found) {
    LevelCounts counts;
    for (std::size_t first = 0; first < pairs.size(); first += kBlock) {
      const std::size_t count = std::min(kBlock, pairs.size() - first);
      ask(pairs.data() + first, count, x0, x1);
      for (std::size_t i = 0; i < count; ++i) {
        count_level(answers_[i].level, counts);
        if (answers_[i].contact) found(first + i, answers_[i]);
        if (sink_) sink_(queries_[i], separation_of(i), answers_[i]);
      }
    }
    return counts;
  }

  /// Sees every query and its answer from now on.
  void watch(QuerySink sink) { sink_ = std::move(sink); }

  /// Whether its answers have weights.
  bool exact() const noexcept { return narrow_phase_ == NarrowPhase::exact; }

 private:
  static constexpr std::size_t kBlock = 1024;  // queries that stay in the cache
  void ask(const Pair* pairs, std::size_t count, const VectorX& x0, const VectorX& x1);
  double separation_of(std::size_t i) const noexcept { return separations_.empty() ? 0 : separations_[i]; }
  static void count_level(Level level, LevelCounts& counts) noexcept;

  const Colliders* colliders_;
  const linear::Cancellation* cancel_;
  NarrowPhase narrow_phase_;
  int threads_;
  QuerySink sink_;
  std::vector<Query> queries_;
  std::vector<double> separations_;  // of queries_; empty when no element has a radius
  std::vector<Answer> answers_;
};

}  // namespace touchstone::sim
