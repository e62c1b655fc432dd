// The difficulty of reading a query.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

namespace touchstone::fuzz {

/// A smaller number is easier to read. It is about the length of the coordinates in binary; a fraction weighs more than
/// an integer with as many digits. Corners that stand still or lie on an earlier corner cost next to nothing. Every
/// distinct absolute value costs a little.
std::int64_t difficulty(const Query& query) noexcept;

std::int64_t difficulty(double x) noexcept;  ///< of one number

/// The same for corners and motions. Corners at rest are simplest, then those on bodies, then those on curves.
std::int64_t difficulty(const CurvedQuery& query);

}  // namespace touchstone::fuzz
