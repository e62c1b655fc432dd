// SPDX-License-Identifier: MIT
#include "io/times.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <system_error>

namespace touchstone::io {
namespace {

/// The 0 or infinity that a well-formed number beyond the doubles' range rounds to. The position of the first digit
/// that is not 0 tells which: it lies hundreds of positions before or after the point.
double rounded_beyond_range(std::string_view text, bool hexadecimal) noexcept {
  const std::size_t mark = std::min(text.find_first_of(hexadecimal ? "pP" : "eE"), text.size());
  const std::string_view digits = text.substr(0, mark);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.find_first_not_of("0.");
  if (first == std::string_view::npos) return 0;
  const double position = static_cast<double>(point) - static_cast<double>(first);
  double exponent = 0;
  bool negative = false;
  for (const char c : text.substr(std::min(mark + 1, text.size()))) {
    if (c == '-') negative = true;
    if (c >= '0' && c <= '9') exponent = std::min(10 * exponent + (c - '0'), 1e15);
  }
  const double order = (hexadecimal ? 4 : 1) * position + (negative ? -exponent : exponent);
  return order > 0 ? std::numeric_limits<double>::infinity() : 0;
}

enum class Reading : std::uint8_t { number, no_number, beyond_doubles };

/// Reads all of `text`; a value beyond the doubles is the zero or infinity that it rounds to.
Reading read_number(std::string_view text, double& value) noexcept {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  constexpr std::string_view kFirst = ".0123456789abcdefABCDEF";  // from_chars takes a sign and names of its own
  const std::string_view first = kFirst.substr(0, hexadecimal ? kFirst.size() : 11);
  if (text.empty() || first.find(text.front()) == std::string_view::npos) return Reading::no_number;
  // libstdc++ 12 takes "+-" for an exponent's sign.
  if (text.find("+-") != std::string_view::npos) return Reading::no_number;
  const char* const last = text.data() + text.size();
  const auto [end, error] =
      std::from_chars(text.data(), last, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (end != last) return Reading::no_number;
  const bool beyond = error == std::errc::result_out_of_range;
  if (error != std::errc{} && !beyond) return Reading::no_number;
  if (beyond) value = rounded_beyond_range(text, hexadecimal);
  if (negative) value = -value;
  return beyond ? Reading::beyond_doubles : Reading::number;
}

}  // namespace

std::string hexfloat(double value) {
  std::array<char, 40> buffer;
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value), std::chars_format::hex);
  if (error != std::errc{}) return {};  // cannot happen: the longest is 22 characters
  std::string text = std::signbit(value) ? "-0x" : "0x";
  return text.append(buffer.data(), end);
}

std::optional<double> parse_finite_double(std::string_view text) noexcept {
  double value = 0;
  return read_number(text, value) == Reading::number ? std::optional(value) : std::nullopt;
}

std::optional<double> parse_rounded_double(std::string_view text) noexcept {
  double value = 0;
  return read_number(text, value) == Reading::no_number ? std::nullopt : std::optional(value);
}

std::string_view fault_of_double(std::string_view text) noexcept {
  double value = 0;
  switch (read_number(text, value)) {
    case Reading::number: return "";
    case Reading::no_number: return "is no finite number";
    case Reading::beyond_doubles: break;
  }
  return value == 0 ? "is closer to 0 than any double that is not 0" : "is beyond the greatest double";
}

bool is_plainly_a_double(std::string_view number) noexcept {
  if (number.starts_with('-')) number.remove_prefix(1);
  if (!number.starts_with("0x")) return false;
  number.remove_prefix(2);
  constexpr std::size_t kMostHexDigits = 14;  // a leading 1 and 13 more are 53 bits
  const bool leading_one = number.starts_with("1.") || number.starts_with("1p");
  const std::size_t mark = number.find('p');
  if (!leading_one || mark == std::string_view::npos || mark > kMostHexDigits + 1) return number == "0p+0";
  // Subnormals have fewer bits than that: their exponents have four digits, as few others have.
  return number.size() - mark <= std::string_view("p-999").size();
}

}  // namespace touchstone::io
