// The last step of the bracket level over several roots at once, in vectors of doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "filters/columns/bracket_columns.hpp"

namespace touchstone::filters {

/// Roots that the bracket kernel has found. So all that their radius reaches lies inside the step.
struct RootsToRefine {
  const BracketedRoots& roots;
  const std::size_t* queries;         ///< roots.t[k] is a root of query queries[k] of the columns
  std::size_t which[kMostBracketed];  ///< the roots that are asked for, by their k
  std::size_t count = 0;
};

/// The result for several roots.
struct RefinedRoots {
  /// What refine_root finds, as a number; or `uncertain`, where only refine_root tells: it may ask for exact values.
  std::int64_t finding[kMostBracketed];
  double toi[kMostBracketed], toi_upper[kMostBracketed];
  double weights[3][kMostBracketed];  ///< of contacts, where weights are wanted

  RefinedRoot root(std::size_t i, bool with_weights) const noexcept {
    RefinedRoot root = {static_cast<Outcome>(finding[i]), toi[i], toi_upper[i]};
    if (with_weights) root.weights = {weights[0][i], weights[1][i], weights[2][i]};
    return root;
  }
};

/// Refines the roots as refine_root does: all that is found is the same bit for bit, since every lane takes the same
/// steps.
using RefineKernel = void (*)(const Columns& columns, const RootsToRefine& roots, double t_max, bool with_weights,
                              RefinedRoots& result);

/// The kernel for queries of a kind that has a cubic, with vectors of that width; null where one query at a time is
/// meant or no kernel is there. Its products are fused or not as those of contact_values are.
RefineKernel refine_kernel(Kind kind, VectorWidth width) noexcept;

}  // namespace touchstone::filters
