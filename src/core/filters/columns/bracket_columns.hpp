// The bracket level over several queries at once, in vectors of doubles: the queries of columns that the first test
// leaves.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <touchstone/query.hpp>
#include <touchstone/vector_width.hpp>

#include "filters/columns/same_side_columns.hpp"
#include "filters/refined_root.hpp"

namespace touchstone::filters {

/// The most queries that the kernel takes at a time, and a multiple of every width.
constexpr std::size_t kMostBracketed = 64;

// What the tests before the last step of the bracket level find about a query. One of the first three is set, or none.
// If none is set, the tests for single queries decide.
constexpr std::int64_t kBoxesDisjoint = 1;    ///< no contact, by the boxes
constexpr std::int64_t kNoContactAtRoot = 2;  ///< no contact, by this level
constexpr std::int64_t kOneRoot = 4;          ///< the last step decides: decide_refined
constexpr std::int64_t kInsideElements = 8;   ///< of such a root: SimpleRoot::inside
constexpr std::int64_t kInsideStep = 16;      ///< of such a root: it certainly lies inside [0, t_max]

/// The result for several queries. The roots are those for which kOneRoot is set.
struct BracketedRoots {
  std::int64_t facts[kMostBracketed];
  double t[kMostBracketed], radius[kMostBracketed], slope[kMostBracketed], slope_error[kMostBracketed],
      curvature[kMostBracketed], u[kMostBracketed], w[kMostBracketed], r[kMostBracketed];
  std::int64_t axis[kMostBracketed];

  SimpleRoot root(std::size_t i) const noexcept {
    return {t[i],
            radius[i],
            slope[i],
            slope_error[i],
            curvature[i],
            {u[i], w[i], r[i]},
            static_cast<std::size_t>(axis[i]),
            (facts[i] & kInsideElements) != 0};
  }
};

/// Tests the queries which[0 .. count - 1] of the columns, at most kMostBracketed. The tests for single queries would
/// find the same facts, and the same roots bit for bit, because every lane takes the same steps. A fact also proves
/// that the query's coordinates are finite, and that the elements share no corner throughout the step.
using BracketKernel = void (*)(const Columns& columns, const std::size_t* which, std::size_t count, double t_max,
                               BracketedRoots& result);

/// The kernel for queries of a kind that has a cubic, with vectors of this width. It is null for
/// VectorWidth::none, and where there is no such kernel.
BracketKernel bracket_kernel(Kind kind, VectorWidth width) noexcept;

BracketKernel bracket_kernel_256(Kind kind) noexcept;
BracketKernel bracket_kernel_512(Kind kind) noexcept;

}  // namespace touchstone::filters
