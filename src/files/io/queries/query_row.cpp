// SPDX-License-Identifier: MIT
#include "io/queries/query_row.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "io/answers/claim_columns.hpp"
#include "io/characters.hpp"
#include "io/fail.hpp"
#include "numbers/fraction.hpp"

#ifndef __SIZEOF_INT128__
#error "a compiler with 128-bit integers is needed (64-bit GCC or clang): numerators may have 38 digits"
#endif

namespace touchstone::io {
namespace {

constexpr std::array<std::string_view, 7> kColumns = {"x_num", "x_den", "y_num", "y_den", "z_num", "z_den", "truth"};

/// std::has_single_bit counts bits, which the oldest x86-64 processors have no instruction for: a library call.
constexpr bool is_power_of_two(std::uint64_t value) { return value != 0 && (value & (value - 1)) == 0; }

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The number of digits at the front of eight characters, the first in the lowest byte.
constexpr std::size_t count_digits(std::uint64_t word) {
  const std::uint64_t t = word ^ 0x3030303030303030u;  // a digit's byte becomes its value
  // A byte above 9 sets its high bit; no byte carries into the next.
  const std::uint64_t others = (((t & 0x7F7F7F7F7F7F7F7Fu) + 0x7676767676767676u) | t) & 0x8080808080808080u;
  return others == 0 ? 8 : static_cast<std::size_t>(std::countr_zero(others)) / 8;
}

/// The number that eight digits spell, the first in the lowest byte: pairs, then fours, then all eight are joined.
constexpr std::uint64_t value_of_digits(std::uint64_t word) {
  word = (word & 0x0F0F0F0F0F0F0F0Fu) * 2561 >> 8;
  word = (word & 0x00FF00FF00FF00FFu) * 6553601 >> 16;
  return (word & 0x0000FFFF0000FFFFu) * 42949672960001u >> 32;
}

constexpr std::size_t kDigitsOf64Bits = 19;

constexpr auto kPowersOfTen = [] {
  std::array<std::uint64_t, kDigitsOf64Bits + 1> powers{};
  powers[0] = 1;
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}();

/// Reads digits into `value`, which must have room for them; at most `most` (else the result is not at a separator).
const char* read_digits(const char* text, std::size_t most, std::uint64_t& value) noexcept {
  const char* const stop = text + most;
  if constexpr (std::endian::native == std::endian::little) {
    while (stop - text >= 8) {
      std::uint64_t word;
      std::memcpy(&word, text, 8);
      const std::size_t count = count_digits(word);
      if (count == 0) return text;
      // Shifted to the end, as if zeros stood before them.
      value = value * kPowersOfTen[count] + value_of_digits(word << 8 * (8 - count));
      text += count;
      if (count < 8) return text;
    }
  }
  while (text < stop && is_digit(*text)) value = value * 10 + static_cast<std::uint64_t>(*text++ - '0');
  return text;
}

/// The powers of two of 9 to 16 digits, as text. The leading digit tells the powers of one length apart.
struct WrittenPower {
  std::uint64_t first = 0, last = 0;  ///< the first eight characters, and the others with zero bytes after them
  int exponent = -1;
};
constexpr std::size_t kLeastWritten = 9, kMostWritten = 16;
constexpr auto kWrittenPowers = [] {
  std::array<std::array<WrittenPower, 10>, kMostWritten - kLeastWritten + 1> powers{};
  for (int exponent = 0; exponent < 54; ++exponent) {
    std::array<std::uint64_t, kMostWritten> digits{};
    std::size_t count = 0;
    for (std::uint64_t rest = std::uint64_t{1} << exponent; rest > 0; rest /= 10) digits[count++] = rest % 10;
    if (count < kLeastWritten) continue;
    WrittenPower& power = powers[count - kLeastWritten][digits[count - 1]];
    power.exponent = exponent;
    for (std::size_t i = 0; i < count; ++i) {
      (i < 8 ? power.first : power.last) |= ('0' + digits[count - 1 - i]) << (8 * (i % 8));
    }
  }
  return powers;
}();

/// What may follow a number. A zero byte ends the text, or is refused later.
constexpr bool ends_column(char c) { return c == ',' || c == '\n' || c == '\r' || c == '\0'; }

/// The exponent of a denominator 2^k of 9 to 16 digits, or -1: it may be another one. `text` goes to its end.
int read_written_power(const char*& text) noexcept {
  std::uint64_t first, last;
  std::memcpy(&first, text, 8);
  if (count_digits(first) < 8) return -1;
  std::memcpy(&last, text + 8, 8);
  const std::size_t count = count_digits(last);
  if (count == 0 || !ends_column(text[8 + count])) return -1;
  const WrittenPower& power = kWrittenPowers[8 + count - kLeastWritten][first & 0xF];
  if (first != power.first || last << 8 * (8 - count) != power.last << 8 * (8 - count)) return -1;
  text += 8 + count;
  return power.exponent;
}

/// The exponent of a denominator 2^k, or -1. `text` goes to its end.
int read_power_of_two(const char*& text) noexcept {
  if constexpr (std::endian::native == std::endian::little) {
    if (const int exponent = read_written_power(text); exponent >= 0) return exponent;
  }
  std::uint64_t high = 0;
  const char* end = read_digits(text, kDigitsOf64Bits, high);
  if (ends_column(*end)) {
    if (end == text || !is_power_of_two(high)) return -1;
    text = end;
    return std::countr_zero(high);
  }
  // 20 to 38 digits: high * 10^k + low < 10^38 < 2^127.
  __extension__ using Wide = unsigned __int128;
  std::uint64_t low = 0;
  const char* const last = read_digits(end, kDigitsOf64Bits, low);
  if (!ends_column(*last)) return -1;
  const Wide value = Wide{high} * kPowersOfTen[static_cast<std::size_t>(last - end)] + low;
  const auto top = static_cast<std::uint64_t>(value >> 64);
  const auto bottom = static_cast<std::uint64_t>(value);
  text = last;
  if (top == 0) return is_power_of_two(bottom) ? std::countr_zero(bottom) : -1;
  return bottom == 0 && is_power_of_two(top) ? 64 + std::countr_zero(top) : -1;
}

/// Reads "numerator,denominator" as a double. `text` goes to its end.
bool read_usual_coordinate(const char*& text, double& coordinate) noexcept {
  constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53;
  const bool negative = *text == '-';
  if (negative) ++text;
  std::uint64_t magnitude = 0;
  const char* const end = read_digits(text, kDigitsOf64Bits, magnitude);
  if (end == text || *end != ',') return false;
  if (magnitude > kExactIntegers && magnitude >> std::countr_zero(magnitude) > kExactIntegers) return false;
  text = end + 1;
  const int exponent = read_power_of_two(text);
  if (exponent < 0) return false;
  // At most 53 significant bits times 2^-126 or more: exact. The sign goes on first, so that "-0" is plain zero.
  const double numerator = magnitude == 0 ? 0.0 : static_cast<double>(magnitude) * (negative ? -1.0 : 1.0);
  coordinate = numerator * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  return true;
}

/// Why `field` cannot stand in this column, or an empty text.
std::string fault_of(std::string_view field, std::size_t column) {
  const std::string name(kColumns[column]);
  if (column == 6) {
    return parse_truth(field) ? "" : "truth is " + in_quotes(field) + "; " + std::string(kTruthIsRight);
  }
  if (!numbers::is_decimal_integer(field)) return name + " is " + in_quotes(field) + "; it must be a decimal integer";
  const std::size_t digits = field.size() - (field.front() == '-' ? 1 : 0);
  if (digits > kMostDigits) {
    return name + " has " + std::to_string(digits) + " digits; at most " + std::to_string(kMostDigits) + " are read";
  }
  if (column % 2 == 0) return {};
  if (field.find_first_not_of("-0") == std::string_view::npos) return name + " is zero; a denominator must be positive";
  if (field.front() == '-') return name + " is " + in_quotes(field) + "; a denominator must be positive";
  return {};
}

}  // namespace

const char* read_usual_row(const char* text, DoubleRow& row) noexcept {
  if (!read_usual_coordinate(text, row.corner.x) || *text++ != ',' ||  //
      !read_usual_coordinate(text, row.corner.y) || *text++ != ',' ||  //
      !read_usual_coordinate(text, row.corner.z)) {
    return nullptr;
  }
  row.truth = std::nullopt;
  if (*text == ',') {
    if (text[1] != '0' && text[1] != '1') return nullptr;
    row.truth = text[1] == '1';
    text += 2;
  }
  if (*text == '\r') ++text;
  if (*text == '\n') return text + 1;
  return *text == '\0' ? text : nullptr;
}

std::optional<RowFields> read_row(std::string_view line, std::string& reason) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line.find('\0') != std::string_view::npos) {
    reason = "a zero byte; this is no text file";
    return std::nullopt;
  }
  std::array<std::string_view, 7> fields;
  std::size_t columns = 0;
  for (std::size_t start = 0; start != std::string_view::npos;) {
    const std::size_t comma = line.find(',', start);
    if (columns < fields.size()) fields[columns] = without_blanks(line.substr(start, comma - start));
    ++columns;
    start = comma == std::string_view::npos ? comma : comma + 1;
  }
  const bool has_truth = columns == fields.size();
  if (!has_truth && columns != fields.size() - 1) {
    reason = std::to_string(columns) + (columns == 1 ? " column" : " columns") +
             "; a row has 7: x_num,x_den,y_num,y_den,z_num,z_den,truth, or 6 without truth";
    return std::nullopt;
  }
  for (std::size_t column = 0; column < columns; ++column) {
    reason = fault_of(fields[column], column);
    if (!reason.empty()) return std::nullopt;
  }
  RowFields row;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    row.corner[axis] = {std::string(fields[2 * axis]), std::string(fields[2 * axis + 1])};
  }
  if (has_truth) row.truth = parse_truth(fields[6]);
  return row;
}

}  // namespace touchstone::io
