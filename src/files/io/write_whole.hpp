// A file that is written at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace touchstone::io {

/// Writes all of the text; when that fails, the old file stays. @throws FileError
void write_whole(const std::string& path, std::string_view text);

}  // namespace touchstone::io
