// Reading for touchstone-check: lines, words and numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "checker/digest.hpp"
#include "checker/messages.hpp"

namespace checker {

struct Rejected : std::runtime_error {  // exit status 1
  using std::runtime_error::runtime_error;
};
struct BadInput : std::runtime_error {  // exit status 2
  using std::runtime_error::runtime_error;
};

constexpr std::size_t kLongestLine = 1U << 20, kMostDigits = 4096, kMostHexDigits = 16384;
constexpr std::size_t kMostCoefficients = 33;
constexpr long kMostExponent = 20000;
constexpr std::uint32_t kMostVertices = (1U << 30) - 1;

using Words = std::vector<std::string_view>;

/// The lines of a file that are neither blank nor comments.
class Lines {
 public:
  explicit Lines(std::string name) : name_(std::move(name)), file_(name_, std::ios::binary), buffer_(kLongestLine + 2) {
    if (!file_) throw BadInput(name_ + ": cannot be opened for reading: " + std::strerror(errno));
  }
  /// Splits the next line into the words between the separators, or the columns between commas. They stay in place until
  /// the next call. @returns false at the end of the file, without words
  bool next(Words& words, const char* separators = " ") {
    words.clear();
    std::string_view line;
    std::size_t first = std::string_view::npos;
    while (first == std::string_view::npos || line[first] == '#') {
      if (!next_of_all(line)) return false;
      first = line.find_first_not_of(" \t");
    }
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
      if (*separators == ',' || end > begin) words.push_back(line.substr(begin, end - begin));
      begin = end + 1;
    }
    return true;
  }
  /// "FILE:LINE: ", of the line that was read last.
  std::string where() const { return name_ + ":" + std::to_string(number_) + ": "; }
  bool has_end() const { return has_end_; }  ///< whether the line that was read last has an end of line
  /// The digest of the whole file. Nothing is read from it then.
  std::string digest() {
    for (std::string_view line; next_of_all(line);) {
    }
    return digest_.text();
  }
  BadInput bad(const std::string& reason) const { return BadInput(where() + reason); }
  void require(bool good, const char* reason) const {
    if (!good) throw bad(reason);
  }

 private:
  bool next_of_all(std::string_view& line) {
    // The buffer holds the longest line, a carriage return, and the zero that getline puts at the end.
    file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    if (file_.bad()) throw BadInput(name_ + ": cannot be read to its end: " + std::strerror(errno));
    auto length = static_cast<std::size_t>(file_.gcount());
    if (file_.eof() && length == 0) return false;
    ++number_;
    has_end_ = !file_.eof();
    if (has_end_ && !file_.fail()) buffer_[--length] = '\n';  // the line feed counts
    line = {buffer_.data(), length};
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (number_ == 1 && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3);  // a byte order mark
    require(line.size() <= kLongestLine && (file_.eof() || !file_.fail()),
            "the line is too long: at most 2^20 bytes are read");
    digest_.add({buffer_.data(), length + (has_end_ ? 1 : 0)});
    return true;
  }

  std::string name_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::uint64_t number_ = 0;
  bool has_end_ = false;
  Digest digest_;
};

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_hexadecimal(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// Decimal digits after an optional minus sign. @returns false for any other text, or one of too many digits
inline bool read_integer(std::string_view text, mpz_class& value) {
  const bool negative = text.substr(0, 1) == "-";
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > kMostDigits) return false;
  unsigned long small = 0;  // most integers are, and this is faster
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), small);
  value = small;
  if (end != text.data() + text.size() || error != std::errc()) {
    if (!std::all_of(text.begin(), text.end(), is_digit)) return false;
    value.set_str(std::string(text), 10);
  }
  if (negative) mpz_neg(value.get_mpz_t(), value.get_mpz_t());
  return true;
}
/// Digits without a sign or leading zeros. @returns false for any other text, or a number above `most`
inline bool read_count(std::string_view text, std::uint32_t most, std::uint32_t& value) {
  mpz_class number;
  if (!read_integer(text, number) || number > most || std::to_string(number.get_ui()) != text) return false;
  value = static_cast<std::uint32_t>(number.get_ui());
  return true;
}

/// m 2^e
struct Number {
  mpz_class m;
  long e = 0;
};
inline int sign(const Number& x) { return sgn(x.m); }
inline Number operator+(const Number& a, const Number& b) {
  const long low = std::min(a.e, b.e);
  return {(a.m << static_cast<unsigned long>(a.e - low)) + (b.m << static_cast<unsigned long>(b.e - low)), low};
}
/// The sign of a - b.
inline int compare(const Number& a, const Number& b) {
  static mpz_class shifted;  // it keeps its memory
  if (a.e == b.e) return cmp(a.m, b.m);
  const bool is_a = a.e > b.e;
  shifted = (is_a ? a.m : b.m) << static_cast<unsigned long>(std::abs(a.e - b.e));
  return is_a ? cmp(shifted, b.m) : cmp(a.m, shifted);
}

/// m 2^e or m 10^e of hexadecimal or decimal digits with at most one point, and a power behind one of the marks.
/// @returns false for any other text, or one beyond the limits
inline bool read_digits(std::string_view text, bool is_hex, const char* marks, std::size_t most, Number& x) {
  const std::size_t mark = std::min(text.find_first_of(marks), text.size());
  std::string digits(text.substr(0, mark));
  const std::size_t point = std::min(digits.find('.'), digits.size());
  if (point < digits.size()) digits.erase(point, 1);
  if (digits.empty() || digits.size() > most) return false;
  if (!std::all_of(digits.begin(), digits.end(), is_hex ? is_hexadecimal : is_digit)) return false;
  mpz_class power;
  if (mark < text.size()) {
    text.remove_prefix(mark + 1);
    if (text.size() > 1 && text[0] == '+' && is_digit(text[1])) text.remove_prefix(1);
    if (!read_integer(text, power) || abs(power) > kMostExponent) return false;
  }
  x.m.set_str(digits, is_hex ? 16 : 10);
  x.e = sign(x) == 0 ? 0 : power.get_si() - (is_hex ? 4 : 1) * static_cast<long>(digits.size() - point);
  return true;
}

/// "-12", or a C hexfloat with any number of digits: "0x1.8p-3".
inline void read_number(std::string_view word, Number& x, const Lines& lines) {
  const bool negative = word.substr(0, 1) == "-", is_hex = word.substr(negative ? 1 : 0, 2) == "0x";
  x.e = 0;
  const bool is_number =
      is_hex ? word.find('p') != word.npos && read_digits(word.substr(negative ? 3 : 2), true, "p", kMostHexDigits, x)
             : read_integer(word, x.m);
  if (!is_number) {
    throw lines.bad(quoted(word) +
                    " is no number: an integer or a hexfloat such as 0x1.8p-3 was expected, of at most "
                    "4,096 or 16,384 digits, with an exponent within the limit, which is 20,000");
  }
  if (is_hex && negative) mpz_neg(x.m.get_mpz_t(), x.m.get_mpz_t());
}
/// A number that is a time; its m is odd, or 0. The cost of a check grows with the places of times: they have a limit.
inline void read_time(std::string_view word, Number& x, const Lines& lines) {
  read_number(word, x, lines);
  const mp_bitcnt_t zeros = sign(x) == 0 ? 0 : mpz_scan1(x.m.get_mpz_t(), 0);
  x.m >>= zeros;
  x.e += static_cast<long>(zeros);
  lines.require(x.e >= -kMostExponent, "a time must be a multiple of 2^-20,000");
}

/// Whether the time x is a double, and not negative. With 53 bits of m, or e = -1074, the next double is (m + 1) 2^e.
inline bool next_double(const Number& x, Number& next) {
  const auto bits = static_cast<long>(mpz_sizeinbase(x.m.get_mpz_t(), 2));
  next.e = sign(x) == 0 ? -1074 : std::max(x.e + bits - 53, -1074L);
  if (sign(x) < 0 || x.e < next.e) return false;
  next.m = (x.m << static_cast<unsigned long>(x.e - next.e)) + 1;
  return true;
}

}  // namespace checker
