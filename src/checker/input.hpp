// Reading for touchstone-check: lines, words and numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// The beginning of a word, for a message. Bytes that a terminal may take for a command become question marks.
inline std::string quoted(std::string_view word) {
  std::string text = "\"";
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 40 ? "...\"" : "\"");
}

/// "1 step", "2 steps"
inline std::string counted(std::uint64_t number, const std::string& one, const std::string& several) {
  return std::to_string(number) + " " + (number == 1 ? one : several);
}

// ---- Lines and words ------------------------------------------------------------------------------------------------

using Words = std::vector<std::string_view>;

/// The lines of a file that are neither blank nor comments.
class Lines {
 public:
  explicit Lines(std::string name) : name_(std::move(name)), file_(name_, std::ios::binary), buffer_(kLongestLine + 2) {
    if (!file_) throw BadInput(name_ + ": cannot be opened for reading: " + std::strerror(errno));
  }
  /// Splits the next line into the words between spaces, or the columns between commas. They stay in place until the
  /// next call. @returns false at the end of the file, without words
  bool next(Words& words, char separator = ' ') {
    words.clear();
    std::string_view line;
    std::size_t first = std::string_view::npos;
    while (first == std::string_view::npos || line[first] == '#') {
      if (!next_of_all(line)) return false;
      first = line.find_first_not_of(" \t");
    }
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(separator, begin), line.size());
      if (separator != ' ' || end > begin) words.push_back(line.substr(begin, end - begin));
      begin = end + 1;
    }
    return true;
  }
  /// "FILE:LINE: ", of the line that was read last.
  std::string where() const { return name_ + ":" + std::to_string(number_) + ": "; }
  bool has_end() const { return has_end_; }  ///< whether the line that was read last has an end of line
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
    if (has_end_ && !file_.fail()) --length;  // the line feed counts
    line = {buffer_.data(), length};
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (number_ == 1 && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3);  // a byte order mark
    require(line.size() <= kLongestLine && (file_.eof() || !file_.fail()),
            "the line is too long: at most 2^20 bytes are read");
    return true;
  }

  std::string name_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::uint64_t number_ = 0;
  bool has_end_ = false;
};

// ---- Numbers --------------------------------------------------------------------------------------------------------

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_hexadecimal(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// Decimal digits after an optional minus sign. @returns false for any other text, or one of too many digits
inline bool read_integer(std::string_view text, mpz_class& value) {
  const bool negative = text.substr(0, 1) == "-";
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > kMostDigits) return false;
  value = 0;
  while (!text.empty()) {  // as many digits at once as an unsigned long has for sure
    const std::string_view digits = text.substr(0, std::numeric_limits<unsigned long>::digits10);
    unsigned long number = 0, unit = 1;
    for (const char c : digits) {
      if (!is_digit(c)) return false;
      number = 10 * number + static_cast<unsigned long>(c - '0');
      unit *= 10;
    }
    value *= unit;
    value += number;
    text.remove_prefix(digits.size());
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
  static mpz_class x, y;  // they keep their memory
  const long low = std::min(a.e, b.e);
  x = a.m << static_cast<unsigned long>(a.e - low);
  y = b.m << static_cast<unsigned long>(b.e - low);
  return cmp(x, y);
}

/// Whether x is a double: m 2^e with 0 <= m < 2^53 and e >= -1074. The next double is x + 2^e, with the least such e
/// for which m >= 2^52, or e = -1074.
inline bool next_double(Number x, Number& next) {
  next = {1, -1074};
  if (sign(x) <= 0) return sign(x) == 0;
  const unsigned long zeros = mpz_scan1(x.m.get_mpz_t(), 0);
  x.m >>= zeros;
  x.e += static_cast<long>(zeros);
  const long shift = std::min(53 - static_cast<long>(mpz_sizeinbase(x.m.get_mpz_t(), 2)), x.e + 1074);
  if (shift < 0) return false;
  next = {(x.m << static_cast<unsigned long>(shift)) + 1, x.e - shift};
  return true;
}

/// "-12", or a C hexfloat with any number of digits: "0x1.8p-3".
inline void read_number(std::string_view word, Number& x, const Lines& lines) {
  const auto require = [&](bool is_number) {
    if (is_number) return;
    throw lines.bad(
        quoted(word) +
        " is no number: an integer or a hexfloat such as 0x1.8p-3 was expected, of at most 4,096 or 16,384 digits");
  };
  const bool negative = word.substr(0, 1) == "-";
  const std::string_view text = word.substr(negative ? 1 : 0);
  x.e = 0;
  if (text.substr(0, 2) != "0x") return require(read_integer(word, x.m));
  const std::size_t p = text.find('p');
  require(p != std::string_view::npos);
  std::string_view power = text.substr(p + 1);
  if (power.substr(0, 1) == "+" && power.substr(1, 1) != "-") power.remove_prefix(1);
  static mpz_class exponent;
  require(read_integer(power, exponent));
  if (abs(exponent) > kMostExponent) {
    throw lines.bad(quoted(word) + " has an exponent beyond the limit, which is 20,000");
  }
  std::string digits(text.substr(2, p - 2));
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) digits.erase(point, 1);
  require(!digits.empty() && digits.size() <= kMostHexDigits);
  require(std::all_of(digits.begin(), digits.end(), is_hexadecimal));
  x.m.set_str((negative ? "-" : "") + digits, 16);
  if (sign(x) == 0) return;
  x.e = exponent.get_si();
  if (point != std::string::npos) x.e -= 4 * static_cast<long>(digits.size() - point);
}

/// The double that is nearest to a decimal or a hexfloat; of two, the one with an even significand.
inline Number read_double(std::string_view word, const Lines& lines) {
  const auto require = [&](bool good) {
    if (!good) throw lines.bad("here must be a finite double, such as 0.25 or 0x1p-2: " + quoted(word));
  };
  std::string_view text = word;
  const bool negative = text.substr(0, 1) == "-";
  if (negative) text.remove_prefix(1);
  const bool is_hex = text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X";
  if (is_hex) text.remove_prefix(2);
  const std::size_t mark = std::min(text.find_first_of(is_hex ? "pP" : "eE"), text.size());
  std::string digits(text.substr(0, mark));
  const std::size_t point = std::min(digits.find('.'), digits.size());
  if (point < digits.size()) digits.erase(point, 1);
  require(!digits.empty() && digits.size() <= kMostDigits &&
          std::all_of(digits.begin(), digits.end(), is_hex ? is_hexadecimal : is_digit));
  mpz_class m(digits, is_hex ? 16 : 10), exponent, unit = 1, quotient, rest;
  if (mark < text.size()) {
    text.remove_prefix(mark + 1);
    if (text.size() > 1 && text[0] == '+' && is_digit(text[1])) text.remove_prefix(1);
    require(read_integer(text, exponent) && abs(exponent) <= kMostExponent);
  }
  if (m == 0) return {};
  exponent -= (is_hex ? 4 : 1) * static_cast<long>(digits.size() - point);
  const mpz_class size = abs(exponent);
  is_hex ? mpz_mul_2exp(unit.get_mpz_t(), unit.get_mpz_t(), size.get_ui())
         : mpz_ui_pow_ui(unit.get_mpz_t(), 10, size.get_ui());
  if (exponent > 0) {
    m *= unit;
    unit = 1;
  }
  // The number is m / unit = (quotient + rest / unit) 2^e, with a quotient of 53 bits, or of fewer where e = -1074.
  const auto bits = [](const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  long e = std::max(bits(m) - bits(unit) - 54, -1075L);
  do {
    ++e;
    const mpz_class numerator = m << static_cast<unsigned long>(std::max(-e, 0L));
    const mpz_class denominator = unit << static_cast<unsigned long>(std::max(e, 0L));
    mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
    rest = 2 * rest - denominator;
  } while (bits(quotient) > 53);
  if (rest > 0 || (rest == 0 && mpz_odd_p(quotient.get_mpz_t()))) ++quotient;
  require(quotient != 0 && bits(quotient) + e <= 1024);
  return {negative ? mpz_class(-quotient) : quotient, e};
}

}  // namespace checker
