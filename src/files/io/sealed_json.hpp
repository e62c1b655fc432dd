// JSON files that carry a digest of themselves, so that damage does not pass for data. The first line of such a file is
//
//   {"sha256": "<64 hexadecimal digits>",
//
// and the digest is that of all bytes after this line: `tail -n +2 FILE | sha256sum` computes it.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace touchstone::io {

/// The text of a JSON object with at least one key, with the first line put in the place of its opening brace.
std::string sealed_json(std::string_view object);

/// Whether `text` is what sealed_json wrote, to the last bit.
bool seal_holds(std::string_view text);

}  // namespace touchstone::io
