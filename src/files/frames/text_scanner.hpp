// Words and numbers of a text file, with the line that each is on.
// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

namespace touchstone::frames {

constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// Reads forwards. The functions with `next_` in their names go on to later lines; the others stay on the current one.
class TextScanner {
 public:
  /// @param file       the name of the file, for messages
  /// @param text       its content
  /// @param continues  whether a backslash at the end of a line joins the next line to it
  /// @param line       the line of the file that the text begins on
  TextScanner(std::string_view file, std::string_view text, bool continues = false, std::uint64_t line = 1)
      : file_(file),
        start_(text.data()),
        at_(text.data()),
        end_(text.data() + text.size()),
        continues_(continues),
        line_(line) {}

  std::uint64_t line() const noexcept { return line_; }                                    ///< the current line, from 1
  std::size_t offset() const noexcept { return static_cast<std::size_t>(at_ - start_); }   ///< bytes before the cursor
  std::size_t remaining() const noexcept { return static_cast<std::size_t>(end_ - at_); }  ///< bytes after it
  bool at_end() const noexcept { return at_ == end_; }

  /// @throws FileError "FILE:LINE: reason"
  [[noreturn]] void fail(std::string_view reason) const;

  /// Skips the mark that some programs put at the start of text in UTF-8.
  void skip_byte_order_mark() noexcept {
    if (std::string_view(at_, remaining()).starts_with("\xEF\xBB\xBF")) at_ += 3;
  }

  /// Skips blanks. @returns whether the line, or the file, ends here
  bool at_line_end() {
    for (;;) {
      if (at_ == end_ || *at_ == '\n') return true;
      if (is_blank(*at_)) {
        ++at_;
      } else if (*at_ != '\\' || !skip_continuation()) {
        return false;
      }
    }
  }

  /// Skips the rest of the line and its end.
  void skip_line() noexcept;

  /// @throws FileError  unless only blanks remain on the line. Skips its end.
  void end_line(std::string_view what) {
    if (!at_line_end()) fail_at_junk(what);
    skip_line();
  }

  /// Skips blanks and ends of lines. @returns whether the file ends here
  bool at_file_end() noexcept {
    for (; at_ != end_; ++at_) {
      if (*at_ == '\n') {
        ++line_;
      } else if (!is_blank(*at_)) {
        return false;
      }
    }
    return true;
  }

  /// The next word of the line; empty at its end.
  std::string_view word();

  /// The next word of the file; empty at its end.
  std::string_view next_word() {
    at_file_end();
    return word();
  }

  /// What remains of the line without the blanks around it. Skips the end of the line.
  std::string_view rest_of_line() noexcept;

  /// The next word of the line as a double: a decimal, rounded to the nearest, or a hexfloat.
  /// @param what  what the number is, for messages: "a coordinate"
  double number(std::string_view what) {
    at_line_end();
    return number_here(what);
  }

  /// The next word of the file as a double.
  double next_number(std::string_view what) {
    at_file_end();
    return number_here(what);
  }

  /// The next word of the line as an integer of at most 18 digits.
  std::int64_t integer(std::string_view what) {
    at_line_end();
    const std::int64_t value = leading_integer(what);
    if (!at_word_end()) fail_integer(what);
    return value;
  }

  /// The next word of the file as an integer.
  std::int64_t next_integer(std::string_view what) {
    at_file_end();
    return integer(what);
  }

  /// An integer at the cursor, which may stand before something else.
  std::int64_t leading_integer(std::string_view what) {
    word_ = at_;
    const char* p = at_;
    const bool negative = p != end_ && *p == '-';
    if (negative) ++p;
    const char* const first = p;
    std::int64_t value = 0;
    for (; p != end_ && is_digit(*p); ++p) {
      if (p - first == kMostDigits) fail_integer(what);
      value = 10 * value + (*p - '0');
    }
    if (p == first) fail_integer(what);
    at_ = p;
    return negative ? -value : value;
  }

  /// Skips `c` if it is at the cursor.
  bool skip(char c) noexcept {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  /// Skips `count` bytes, which must remain. They are not text: ends of lines in them do not count.
  std::string_view raw_bytes(std::size_t count) noexcept {
    const std::string_view found(at_, count);
    at_ += count;
    return found;
  }

  /// Whether a word ends at the cursor.
  bool at_word_end() const noexcept {
    return at_ == end_ || *at_ == '\n' || is_blank(*at_) || (*at_ == '\\' && length_of_continuation() != 0);
  }

  /// The word that the cursor is in, from the start of the integer that was read last, for messages.
  [[noreturn]] void fail_integer(std::string_view what);

 private:
  static constexpr std::ptrdiff_t kMostDigits = 18;

  double number_here(std::string_view what) {
    const char* p = at_;
    const bool negative = p != end_ && *p == '-';
    if (negative) ++p;
    if (p != end_ && (is_digit(*p) || *p == '.')) {
      double value = 0;
      const auto [last, error] = std::from_chars(p, end_, value);
      // libstdc++ 12 takes "+-" for an exponent's sign: words with a '+' are looked at by the slow path.
      if (error == std::errc{} && (last == end_ || *last == '\n' || is_blank(*last)) &&
          std::string_view(p, static_cast<std::size_t>(last - p)).find('+') == std::string_view::npos) {
        at_ = last;
        return negative ? -value : value;
      }
    }
    return unusual_number(what);
  }

  double unusual_number(std::string_view what);
  bool skip_continuation() noexcept;
  std::size_t length_of_continuation() const noexcept;
  [[noreturn]] void fail_at_junk(std::string_view what);

  std::string_view file_;
  const char* start_;
  const char* at_;
  const char* word_ = nullptr;
  const char* end_;
  bool continues_;
  std::uint64_t line_;
};

/// Whether both are the same but for the case of ASCII letters.
bool equal_but_for_case(std::string_view a, std::string_view b) noexcept;

}  // namespace touchstone::frames
