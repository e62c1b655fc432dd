// The queries of columns that the first test leaves.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/answer.hpp>
#include <touchstone/solve.hpp>

#include "filters/columns/bracket_columns.hpp"
#include "filters/columns/refined_columns.hpp"

namespace touchstone::solver {

/// Collects queries of a kind that has a cubic, after same_side has left them, and answers several of them at a time by
/// a method with filters: the bracket level in vectors, its roots in vectors, too, and one by one what they leave. The
/// answers are the same bit for bit as those of `answer`. The arguments outlive the object.
class Survivors {
 public:
  /// @param columns  of the same queries
  Survivors(const QueryColumns& queries, const filters::Columns& columns, const BatchOptions& options,
            Answer* answers) noexcept;

  /// Answers query i, now or when enough of them have come. @throws InvalidQuery  for any of those
  void add(std::size_t i);

  /// Answers those that wait. @throws InvalidQuery
  void answer_waiting();

 private:
  void answer_one(std::size_t i);
  void answer_hits();

  const QueryColumns& queries_;
  const filters::Columns& columns_;
  const BatchOptions& options_;
  filters::BracketKernel kernel_;
  filters::RefineKernel refine_;  // null where kernel_ is
  Answer* answers_;
  std::size_t count_ = 0;
  std::size_t waiting_[filters::kMostBracketed];
  filters::BracketedRoots roots_;  // of those that wait
  filters::RootsToRefine hits_ = {roots_, waiting_, {}};
  filters::RefinedRoots refined_;
};

}  // namespace touchstone::solver
