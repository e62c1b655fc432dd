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

/// Adds one, or all of the others.
void count(Level level, LevelCounts& counts) noexcept;
void count(const LevelCounts& others, LevelCounts& counts) noexcept;

/// Pairs that keep a distance, and do not only not touch.
struct SeparationCounts {
  std::uint64_t pairs = 0;
  double least = 0, largest = 0;  ///< of these distances, m; 0 without any

  void operator+=(const SeparationCounts& others) noexcept;
};
SeparationCounts separations_of(const Colliders& colliders, const std::vector<Pair>& pairs);

/// Sees a query of particles, its separation and the answer.
using QuerySink = std::function<void(const Query&, double, const Answer&)>;

/// Answers to pairs[i], in order; pairs of particles only where the motion has no bodies, and always by the exact
/// solver where it has; the same for any number of threads. Elements are in contact within their separation.
class PairSolver {
 public:
  /// @param cancel  is checked before each block of pairs, and lives as long as this
  PairSolver(const Colliders& colliders, NarrowPhase narrow_phase, int threads,
             const linear::Cancellation& cancel = linear::Cancellation::never());

  /// For every contact in the order of `pairs`: found(index, answer). @returns how many each level decided
  template <class Found>
  LevelCounts contacts(const std::vector<Pair>& pairs, const SceneMotion& motion, Found found) {
    LevelCounts counts;
    for (std::size_t first = 0; first < pairs.size(); first += kBlock) {
      const std::size_t size = std::min(kBlock, pairs.size() - first);
      ask(pairs.data() + first, size, motion);
      for (std::size_t i = 0; i < size; ++i) {
        count(answers_[i].level, counts);
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
  void ask(const Pair* pairs, std::size_t count, const SceneMotion& motion);
  double separation_of(std::size_t i) const noexcept { return separations_.empty() ? 0 : separations_[i]; }

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
