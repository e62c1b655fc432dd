// Error messages about files: one line, "FILE:ROW: reason", whatever bytes the file holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace touchstone::io {

/// @throws FileError "FILE: reason"
[[noreturn]] void fail(std::string_view file, std::string_view reason);

/// @throws FileError "FILE:ROW: reason"; rows are the file's lines, counted from 1
[[noreturn]] void fail(std::string_view file, std::uint64_t row, std::string_view reason);

/// `name` as one line of valid UTF-8 that only shows: the bytes of control characters (io::is_control) and those that
/// are no UTF-8 are written as \n, \r, \t or \x1b.
std::string printable(std::string_view name);

/// 'text' in quotes for a message: control characters and bytes past ASCII escaped, cut after 40 bytes.
std::string in_quotes(std::string_view text);

/// `text` as in_quotes writes it, without the quotes.
std::string shortened(std::string_view text);

/// `message`, which another library wrote, made printable; every word of more than 100 bytes is cut after 40.
std::string with_short_words(std::string_view message);

/// The operating system's message for `error_number`, for example "No such file or directory".
std::string system_reason(int error_number);

}  // namespace touchstone::io
