// SPDX-License-Identifier: MIT
#include "io/fail.hpp"

#include <algorithm>
#include <system_error>

#include <touchstone/error.hpp>

#include "io/characters.hpp"

namespace touchstone::io {
namespace {

void append_escaped(std::string& out, unsigned char byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  if (byte == '\n') {
    out += "\\n";
  } else if (byte == '\r') {
    out += "\\r";
  } else if (byte == '\t') {
    out += "\\t";
  } else {
    out += "\\x";
    out += kDigits[byte >> 4];
    out += kDigits[byte & 15];
  }
}

constexpr std::size_t kShown = 40;  // of a text that is too long for a message

}  // namespace

void fail(std::string_view file, std::string_view reason) {
  throw FileError(printable(file) + ": " + std::string(reason));
}

void fail(std::string_view file, std::uint64_t row, std::string_view reason) {
  throw FileError(printable(file) + ":" + std::to_string(row) + ": " + std::string(reason));
}

std::string printable(std::string_view name) {
  constexpr std::size_t kLongestPath = 4096;  // a longer path names no file
  const bool cut = name.size() > kLongestPath;
  if (cut) name = name.substr(0, kShown);
  std::string out;
  for (std::size_t at = 0; at < name.size();) {
    const Character character = character_at(name, at);
    const std::size_t length = std::max<std::size_t>(character.length, 1);
    const std::string_view bytes = name.substr(at, length);
    if (character.length == 0 || is_control(character.code)) {
      for (const char c : bytes) append_escaped(out, static_cast<unsigned char>(c));
    } else {
      out += bytes;
    }
    at += length;
  }
  return cut ? out + "..." : out;
}

std::string in_quotes(std::string_view text) { return std::string("'").append(shortened(text)).append("'"); }

std::string shortened(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, kShown)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || is_control(byte)) {
      append_escaped(out, byte);
    } else {
      out += c;
    }
  }
  if (text.size() > kShown) out += "...";
  return out;
}

std::string with_short_words(std::string_view message) {
  constexpr std::size_t kLongestWord = 100;  // names of files are longer than numbers
  std::string out;
  while (!message.empty()) {
    const std::size_t end = std::min(message.find(' '), message.size());
    const std::string_view word = message.substr(0, end);
    out += word.size() > kLongestWord ? printable(word.substr(0, kShown)) + "..." : printable(word);
    if (end < message.size()) out += ' ';
    message.remove_prefix(std::min(end + 1, message.size()));
  }
  return out;
}

std::string system_reason(int error_number) { return std::generic_category().message(error_number); }

}  // namespace touchstone::io
