// The first filter over many queries at once, with the vectors of the machine. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::filters {

/// Coordinates of many queries as columns: start[i][k][q] is coordinate k of corner i of query q at t = 0.
struct Columns {
  const double* start[4][3];
  const double* end[4][3];
};

/// proved[i] != 0, 0 <= i < count, proves that query first + i of the columns has no contact, and that its coordinates
/// are finite, exactly when certain_same_side does. The same result whatever the width: every lane takes the same steps.
using SameSideKernel = void (*)(const Columns& columns, std::size_t first, std::size_t count, std::int64_t* proved);

/// The kernel for queries of a kind that has a cubic, with vectors of that width; null when the machine, or the compiler that
/// built the library, has none. Never null for VectorWidth::none and widest.
SameSideKernel same_side_kernel(Kind kind, VectorWidth width) noexcept;

}  // namespace touchstone::filters
