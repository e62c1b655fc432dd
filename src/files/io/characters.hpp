// Characters of text from outside.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace touchstone::io {

/// A character of UTF-8. The length 0 says that none starts here.
struct Character {
  std::size_t length = 0;
  char32_t code = 0;
};

/// The character that starts at `at`, an index into the text.
Character character_at(std::string_view text, std::size_t at) noexcept;

/// Whether programs obey the character in place of showing it: controls (C0, DEL, C1), line and paragraph separators,
/// marks that change the direction of text, and characters without a width that are no part of a word.
bool is_control(char32_t code) noexcept;

/// Without spaces and tabs at both ends.
std::string_view without_blanks(std::string_view text) noexcept;

}  // namespace touchstone::io
