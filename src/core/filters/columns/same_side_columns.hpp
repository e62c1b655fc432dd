// The first test over many queries at once, in vectors of doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/vector_width.hpp>

namespace touchstone::filters {

/// Coordinates of many queries as columns: start[i][k][q] is coordinate k of corner i of query q at t = 0.
struct Columns {
  const double* start[4][3];
  const double* end[4][3];
};

/// proved[i] != 0, 0 <= i < count, proves that query first + i of the columns has no contact and that its coordinates
/// are finite. It is so exactly when certain_same_side is true. The result is the same for every width, since every
/// lane takes the same steps.
using SameSideKernel = void (*)(const Columns& columns, std::size_t first, std::size_t count, std::int64_t* proved);

/// The same for a separation: distances[i] is that of query first + i, and proved[i] is certain_clearance.
using ClearanceKernel = void (*)(const Columns& columns, const double* distances, std::size_t first, std::size_t count,
                                 std::int64_t* proved);

/// Whether the machine has vectors of that width, and the compiler that built the library could use them.
bool has_kernel(VectorWidth width) noexcept;

/// The width itself, or the widest that the machine has in place of `widest`.
VectorWidth narrowed(VectorWidth width) noexcept;

/// The kernel for queries of a kind that has a cubic, with vectors of that width; null where has_kernel is false.
SameSideKernel same_side_kernel(Kind kind, VectorWidth width) noexcept;
ClearanceKernel clearance_kernel(Kind kind, Metric metric, VectorWidth width) noexcept;

}  // namespace touchstone::filters
