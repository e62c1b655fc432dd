// Blocks that zlib has compressed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace touchstone::frames {

/// No block of zlib's is more than this many times as long as its compressed bytes.
inline constexpr std::size_t kMostInflation = 1032;

/// @param size  of the block
/// @returns why the compressed bytes are no block of this size, or an empty text
std::string_view inflate(std::string_view compressed, char* to, std::size_t size);

}  // namespace touchstone::frames
