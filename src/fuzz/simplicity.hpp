// How hard a query is to read.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/query.hpp>

namespace touchstone::fuzz {

/// The less, the easier: about the length of the coordinates in binary, where a fraction weighs more than an integer of
/// as many digits. Corners that stand still or lie on an earlier one cost next to nothing, and every distinct absolute
/// value a little.
std::int64_t difficulty(const Query& query) noexcept;

}  // namespace touchstone::fuzz
