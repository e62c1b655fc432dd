// Makes a failing query readable: small integers and short fractions, corners that stand still, few distinct values.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_set>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "seeded/rng.hpp"

namespace touchstone::fuzz {

struct ShrinkLimits {
  std::uint64_t tries = 20'000;          ///< the most queries that are asked
  std::function<bool()> stop = nullptr;  ///< called before each; true ends the shrinking with the best query so far
};

/// The simplest query found, by `difficulty`, for which `still_fails` holds; `query` itself when there is no simpler
/// one. Equal arguments give equal results unless `stop` ends it. `still_fails` is only called with valid queries.
Query shrink(const Query& query, const std::function<bool(const Query&)>& still_fails, const ShrinkLimits& limits = {});
CurvedQuery shrink(const CurvedQuery& query, const std::function<bool(const CurvedQuery&)>& still_fails,
                   const ShrinkLimits& limits = {});

/// The state that the moves of shrink_moves.hpp work on: the simplest query so far. Moves offer simpler ones to it.
template <class Q>
class Shrinking {
 public:
  Shrinking(const Q& query, const std::function<bool(const Q&)>& still_fails, const ShrinkLimits& limits);

  const Q& best() const noexcept { return best_; }

  /// Takes the candidate as the best when it is simpler, valid and still fails. @returns whether it did
  bool offer(const Q& candidate);

  /// Whether to give up: no tries are left, or `stop` asked for an end.
  bool over() const noexcept { return over_; }

  seeded::Rng& rng() noexcept { return rng_; }

 private:
  const std::function<bool(const Q&)>& still_fails_;
  const ShrinkLimits& limits_;
  Q best_;
  std::int64_t difficulty_;
  std::uint64_t tries_ = 0;
  bool over_ = false;
  seeded::Rng rng_;
  std::unordered_set<std::uint64_t> refused_;  ///< fingerprints of candidates that do not fail
};

}  // namespace touchstone::fuzz
