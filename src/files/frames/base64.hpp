// Bytes that a text file holds in base64.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace touchstone::frames {

/// Reads bytes from a text in base64, or from several that follow one another, each with its own padding. Blanks and
/// ends of lines may be anywhere.
class Base64Reader {
 public:
  explicit Base64Reader(std::string_view text) : text_(text) {}

  /// @returns whether so many bytes were there, and all of it was base64
  bool read(char* to, std::size_t count) noexcept;

  /// Whether nothing remains. False before anything that is no base64.
  bool at_end() noexcept;

  /// The remaining bytes are not more.
  std::size_t most_remaining() const noexcept { return held_ + text_.size() / 4 * 3 + 2; }
  std::size_t characters_remaining() const noexcept { return text_.size(); }

 private:
  bool fill() noexcept;
  void skip_blanks() noexcept;

  std::string_view text_;
  unsigned bits_ = 0;
  std::size_t held_ = 0;  ///< the last bytes of bits_, which are not read yet
};

/// The bytes of one text without blanks, whose padding may be missing; nothing for a text that is no base64.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace touchstone::frames
