// SPDX-License-Identifier: MIT
#include "io/fail.hpp"

#include <system_error>

#include <touchstone/error.hpp>

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

constexpr bool is_control(unsigned char byte) { return byte < 0x20 || byte == 0x7F; }

}  // namespace

void fail(std::string_view file, std::string_view reason) {
  throw FileError(printable(file) + ": " + std::string(reason));
}

void fail(std::string_view file, std::uint64_t row, std::string_view reason) {
  throw FileError(printable(file) + ":" + std::to_string(row) + ": " + std::string(reason));
}

std::string printable(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_control(byte)) {
      append_escaped(out, byte);
    } else {
      out += c;
    }
  }
  return out;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string out = "'";
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_control(byte) || byte >= 0x80) {
      append_escaped(out, byte);
    } else {
      out += c;
    }
  }
  if (text.size() > kLongest) out += "...";
  return out + "'";
}

std::string system_reason(int error_number) { return std::generic_category().message(error_number); }

}  // namespace touchstone::io
