// Which queries a run asks, in pieces that any thread can do in any order.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <touchstone/query.hpp>

#include "families/families.hpp"

namespace touchstone::fuzz {

/// Cases `first` to `first + count - 1` of one family and kind.
struct Piece {
  families::Family family;
  Kind kind;
  std::uint64_t first;
  std::uint64_t count;
};

/// Which of the queries that were given a run asks.
struct GivenPlan {
  std::vector<std::uint64_t> to_ask;  ///< their positions
  std::uint64_t wanted = 0;           ///< how many are of a kind that is wanted
  std::uint64_t not_taken = 0;        ///< how many of these are of a kind that the solver does not take
};

/// @param wanted  kinds; empty: all
/// @param asked  those of them that the solver takes
/// @param most  how many to ask
GivenPlan plan_of_given(const std::vector<Query>& given, const std::vector<Kind>& wanted,
                        const std::vector<Kind>& asked, std::optional<std::uint64_t> most);

/// Every family with every kind in turn, a few hundred cases at a time, so that a run that ends early has seen all of
/// them.
class Plan {
 public:
  /// @param cases  how many in all, shared out evenly; nothing: without end
  Plan(std::vector<families::Family> families, std::vector<Kind> kinds, std::optional<std::uint64_t> cases);

  /// Piece `number`, counted from 0; nothing after the last one.
  std::optional<Piece> piece(std::uint64_t number) const;

 private:
  std::uint64_t cases_of(std::uint64_t pair) const;

  std::vector<families::Family> families_;
  std::vector<Kind> kinds_;
  std::optional<std::uint64_t> cases_;
  std::uint64_t rounds_ = 0;  ///< pieces of each pair, when the number of cases is given
};

}  // namespace touchstone::fuzz
