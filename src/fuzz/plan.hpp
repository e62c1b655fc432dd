// The queries that a run asks, in pieces that any thread can do in any order.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/query.hpp>

#include "families/families.hpp"
#include "fuzz/any_query.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// Those of the `selected` kinds (empty: all) that the solver supports. @throws InvalidQuery when it supports none
std::vector<Kind> supported_kinds(const SolverUnderTest& solver, const std::vector<Kind>& selected);

/// @throws InvalidQuery  when the solver takes no queries of this sort
void check_sort(const SolverUnderTest& solver, bool curved);

std::string kind_names(const std::vector<Kind>& kinds);  ///< "edge-edge, vertex-face"

/// Cases `first_case` to `first_case + count - 1` of one family and kind.
struct CaseRange {
  families::Family family;
  Kind kind;
  std::uint64_t first_case;
  std::uint64_t count;
};

/// The given queries that a run asks.
struct GivenPlan {
  std::vector<std::uint64_t> to_ask;  ///< their positions
  std::uint64_t selected = 0;         ///< number of given queries of a selected kind
  std::uint64_t not_taken = 0;        ///< number of these whose kind the solver does not support
};

/// @param selected  kinds; empty: all
/// @param asked  the selected kinds that the solver supports
/// @param most  the most queries to ask
GivenPlan plan_of_given(const std::vector<AnyQuery>& given, const std::vector<Kind>& selected,
                        const std::vector<Kind>& asked, std::optional<std::uint64_t> most);

/// Every family with every kind in turn, a few hundred cases at a time. A run that ends early has then seen all
/// families and kinds.
class Plan {
 public:
  /// @param cases  the number of cases in all, divided evenly; nothing: without end
  Plan(std::vector<families::Family> families, std::vector<Kind> kinds, std::optional<std::uint64_t> cases);

  /// Piece `number`, counted from 0; nothing after the last one.
  std::optional<CaseRange> piece(std::uint64_t number) const;

 private:
  std::uint64_t cases_of(std::uint64_t pair) const;

  std::vector<families::Family> families_;
  std::vector<Kind> kinds_;
  std::optional<std::uint64_t> cases_;
  std::uint64_t rounds_ = 0;  ///< pieces of each pair, when the number of cases is given
};

}  // namespace touchstone::fuzz
