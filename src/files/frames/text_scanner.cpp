// SPDX-License-Identifier: MIT
#include "frames/text_scanner.hpp"

#include <algorithm>
#include <cstring>

#include "io/fail.hpp"
#include "io/times.hpp"

namespace touchstone::frames {

void TextScanner::fail(std::string_view reason) const { io::fail(file_, line_, reason); }

void TextScanner::skip_line() noexcept {
  const void* const found = at_ == end_ ? nullptr : std::memchr(at_, '\n', remaining());
  if (found == nullptr) {
    at_ = end_;
  } else {
    at_ = static_cast<const char*>(found) + 1;
    ++line_;
  }
}

std::string_view TextScanner::word() {
  at_line_end();
  const char* const first = at_;
  while (!at_word_end()) ++at_;
  return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view TextScanner::rest_of_line() noexcept {
  const char* first = at_;
  skip_line();
  const char* last = at_;
  if (last != first && last[-1] == '\n') --last;
  while (first != last && is_blank(*first)) ++first;
  while (first != last && is_blank(last[-1])) --last;
  return {first, static_cast<std::size_t>(last - first)};
}

/// The number of bytes of a backslash and the end of its line; 0 if there is no such thing here.
std::size_t TextScanner::length_of_continuation() const noexcept {
  if (!continues_ || at_ == end_ || *at_ != '\\') return 0;
  const char* p = at_ + 1;
  if (p != end_ && *p == '\r') ++p;
  return p != end_ && *p == '\n' ? static_cast<std::size_t>(p + 1 - at_) : 0;
}

bool TextScanner::skip_continuation() noexcept {
  const std::size_t length = length_of_continuation();
  at_ += length;
  if (length != 0) ++line_;
  return length != 0;
}

double TextScanner::unusual_number(std::string_view what) {
  const std::string_view found = word();
  if (found.empty()) fail(std::string(at_end() ? "the file" : "the line").append(" ends before ").append(what));
  std::string_view digits = found;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  const auto value = io::parse_finite_double(digits);
  if (!value) {
    fail(std::string(what) + ": " + io::in_quotes(found) + " " + std::string(io::fault_of_double(digits)));
  }
  return *value;
}

void TextScanner::fail_integer(std::string_view what) {
  if (word_ != nullptr) at_ = word_;
  const std::string_view found = word();
  if (found.empty()) fail(std::string(at_end() ? "the file" : "the line").append(" ends before ").append(what));
  fail(std::string(what) + ": " + io::in_quotes(found) + " is no integer of at most 18 digits");
}

void TextScanner::fail_at_junk(std::string_view what) {
  fail(io::in_quotes(word()) + " after " + std::string(what) + ", where the line should end");
}

bool equal_but_for_case(std::string_view a, std::string_view b) noexcept {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace touchstone::frames
