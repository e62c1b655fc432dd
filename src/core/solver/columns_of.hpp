// A caller's columns as the kernels take them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <touchstone/solve.hpp>

#include "filters/columns/same_side_columns.hpp"

namespace touchstone::solver {

/// The same columns: the pointers are copied, not the coordinates.
inline filters::Columns columns_of(const QueryColumns& queries) noexcept {
  filters::Columns columns;
  for (std::size_t i = 0; i < 4; ++i) {
    std::copy_n(queries.start[i].begin(), 3, columns.start[i]);
    std::copy_n(queries.end[i].begin(), 3, columns.end[i]);
  }
  return columns;
}

}  // namespace touchstone::solver
