// SPDX-License-Identifier: MIT
#include "frames/base64.hpp"

#include <array>
#include <cstdint>

namespace touchstone::frames {
namespace {

constexpr std::int8_t kNoDigit = -1;

constexpr std::array<std::int8_t, 256> kDigits = [] {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::int8_t, 256> digits{};
  digits.fill(kNoDigit);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    digits[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::int8_t>(i);
  }
  return digits;
}();

}  // namespace

void Base64Reader::skip_blanks() noexcept {
  while (!text_.empty() && std::string_view(" \t\r\n").find(text_.front()) != std::string_view::npos) {
    text_.remove_prefix(1);
  }
}

/// Decodes the next four characters, of which the last two or the last one may be padding, or may be missing at the end.
bool Base64Reader::fill() noexcept {
  unsigned bits = 0;
  std::size_t digits = 0, padding = 0;
  while (digits + padding < 4) {
    skip_blanks();
    if (text_.empty()) break;
    const char c = text_.front();
    const std::int8_t digit = kDigits[static_cast<unsigned char>(c)];
    if (c == '=' ? digits < 2 : digit == kNoDigit || padding > 0) return false;
    text_.remove_prefix(1);
    if (c == '=') {
      ++padding;
    } else {
      bits = bits << 6 | static_cast<unsigned>(digit);
      ++digits;
    }
  }
  const bool is_whole = digits + padding == 4 || padding == 0;
  if (digits < 2 || !is_whole) return false;
  held_ = digits - 1;
  bits_ = bits >> (6 * digits - 8 * held_);
  return true;
}

bool Base64Reader::read(char* to, std::size_t count) noexcept {
  for (; count > 0; --count) {
    if (held_ == 0 && !fill()) return false;
    --held_;
    *to++ = static_cast<char>(bits_ >> 8 * held_ & 0xFF);
  }
  return true;
}

bool Base64Reader::at_end() noexcept {
  skip_blanks();
  return held_ == 0 && text_.empty();
}

std::optional<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  if (text.find_first_of("= \t\r\n") != std::string_view::npos) return std::nullopt;
  std::string bytes(text.size() * 3 / 4, '\0');
  Base64Reader reader(text);
  if (!reader.read(bytes.data(), bytes.size()) || !reader.at_end()) return std::nullopt;
  return bytes;
}

}  // namespace touchstone::frames
