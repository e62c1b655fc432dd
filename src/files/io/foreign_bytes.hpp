// Bytes that a reader of text gets where a file is packed, or is text of another encoding.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace touchstone::io {

inline constexpr std::size_t kForeignStart = 8;  ///< that many bytes at the start of a file tell

/// @param start  the first bytes of a file that must be text: kForeignStart of them, or more, or the whole file
/// @throws FileError  for UTF-16 and for packed files (gzip, zip, bzip2, xz, zstd), with the remedy
void refuse_foreign_bytes(std::string_view file, std::string_view start);

}  // namespace touchstone::io
