// How touchstone-check shows words of files to a person. No verdict depends on it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace checker {

/// The bytes of the character at the start of the text, if it only shows: 0 for bytes that are no UTF-8, for controls,
/// and for characters that change the direction of text or have no width and are no part of a word.
inline std::size_t shown_bytes(std::string_view text) {
  static constexpr std::array<std::array<std::uint32_t, 2>, 9> kHidden = {{{0, 0x1F},
                                                                           {0x7F, 0x9F},
                                                                           {0x61C, 0x61C},
                                                                           {0x200B, 0x200B},
                                                                           {0x200E, 0x200F},
                                                                           {0x2028, 0x202E},
                                                                           {0x2060, 0x206F},
                                                                           {0xFEFF, 0xFEFF},
                                                                           {0xFFF9, 0xFFFB}}};
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0x80 ? 2 : 1;
  if ((size == 2 && first < 0xC2) || text.size() < size) return 0;
  std::uint32_t c = size == 1 ? first : first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) != 0x80) return 0;
    c = c << 6 | (byte & 0x3FU);
  }
  if ((size == 3 && c < 0x800) || (size == 4 && (c < 0x10000 || first > 0xF4)) || c > 0x10FFFF) return 0;
  const auto holds = [&](const auto& range) { return c >= range[0] && c <= range[1]; };
  return (c >= 0xD800 && c <= 0xDFFF) || std::any_of(kHidden.begin(), kHidden.end(), holds) ? 0 : size;
}
/// A text whose characters only show: the others are written as \x1b, a byte each.
inline std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t size = shown_bytes(text);
    if (size == 0) {
      const auto byte = static_cast<unsigned char>(text[0]);
      shown.append("\\x").append(1, "0123456789abcdef"[byte / 16]).append(1, "0123456789abcdef"[byte % 16]);
    }
    shown += text.substr(0, size);
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return shown;
}

/// The beginning of a word, for a message.
inline std::string quoted(std::string_view word) {
  return "\"" + printable(word.substr(0, 40)) + (word.size() > 40 ? "...\"" : "\"");
}

/// "1 step", "2 steps"
inline std::string counted(std::uint64_t number, const std::string& one, const std::string& several) {
  return std::to_string(number) + " " + (number == 1 ? one : several);
}

}  // namespace checker
