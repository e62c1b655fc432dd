// Fast tests in doubles that prove "no contact in [0, 1]" or say that they are uncertain; never a guess. Every test is
// sound by itself for any finite input, in the default floating-point environment.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/query.hpp>

namespace touchstone::filters {

/// Which test proved that there is no contact; `none` when all are uncertain.
enum class Proof : std::uint8_t { none, same_side, boxes, closest_points, normal, centres };

/// Runs the tests in order until one proves that the elements never touch.
Proof separation_proof(const Query& query) noexcept;

inline bool separated(const Query& query) noexcept { return separation_proof(query) != Proof::none; }

}  // namespace touchstone::filters
