// SPDX-License-Identifier: MIT
#include "numbers/written_number.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <charconv>

#include "numbers/fraction.hpp"

namespace touchstone::numbers {
namespace {

/// significand * base^exponent, with base 10 or 2. Neither end of the significand is a zero.
struct Scientific {
  bool negative = false;
  bool hexadecimal = false;
  std::string significand;  ///< digits alone; empty for zero
  long exponent = 0;
};

/// The exponent's text after its mark. One with more digits than these is far beyond kMostWrittenDigits.
std::optional<long> exponent_of(std::string_view text) {
  constexpr long kFar = 1'000'000'000;
  const bool negative = text.starts_with('-');
  const std::string_view digits = text.substr(negative || text.starts_with('+') ? 1 : 0);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  long value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || value > kFar) value = kFar;
  return negative ? -value : value;
}

std::optional<Scientific> scientific(std::string_view text) {
  Scientific number;
  number.negative = text.starts_with('-');
  if (number.negative) text.remove_prefix(1);
  number.hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (number.hexadecimal) text.remove_prefix(2);

  const std::size_t mark = std::min(text.find_first_of(number.hexadecimal ? "pP" : "eE"), text.size());
  if (mark < text.size()) {
    const auto exponent = exponent_of(text.substr(mark + 1));
    if (!exponent) return std::nullopt;
    number.exponent = *exponent;
  }
  const std::string_view digits = text.substr(0, mark);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  number.significand = std::string(digits.substr(0, point));
  long fraction_digits = 0;
  if (point < digits.size()) {
    number.significand += digits.substr(point + 1);
    fraction_digits = static_cast<long>(digits.size() - point - 1);
  }
  constexpr std::string_view kDigits = "0123456789abcdefABCDEF";
  const auto known = kDigits.substr(0, number.hexadecimal ? kDigits.size() : 10);
  if (number.significand.empty() || number.significand.find_first_not_of(known) != std::string::npos) {
    return std::nullopt;
  }
  const std::size_t used = number.significand.find_last_not_of('0') + 1;  // npos + 1 is 0
  fraction_digits -= static_cast<long>(number.significand.size() - used);
  number.significand.resize(used);
  number.significand.erase(0, number.significand.find_first_not_of('0'));
  number.exponent -= (number.hexadecimal ? 4 : 1) * fraction_digits;
  return number;
}

std::optional<WrittenFraction> decimal_value(const Scientific& number) {
  const auto zeros = static_cast<std::size_t>(std::abs(number.exponent));
  if (number.significand.size() > kMostWrittenDigits || zeros >= kMostWrittenDigits) return std::nullopt;
  WrittenFraction value{number.significand, "1"};
  (number.exponent < 0 ? value.denominator : value.numerator).append(zeros, '0');
  if (value.numerator.size() > kMostWrittenDigits) return std::nullopt;
  return value;
}

std::optional<WrittenFraction> hexadecimal_value(const Scientific& number) {
  // Before the conversion only what is cheap to convert must be sure: four bits a decimal digit are more than it needs.
  constexpr std::size_t kMostBits = 4 * kMostWrittenDigits;
  const auto shift = static_cast<std::size_t>(std::abs(number.exponent));
  if (4 * number.significand.size() > kMostBits || shift > kMostBits) return std::nullopt;
  mpz_class numerator(number.significand, 16);
  mpz_class denominator(1);
  mpz_class& scaled = number.exponent < 0 ? denominator : numerator;
  scaled <<= shift;
  WrittenFraction value{numerator.get_str(), denominator.get_str()};
  if (std::max(value.numerator.size(), value.denominator.size()) > kMostWrittenDigits) return std::nullopt;
  return value;
}

}  // namespace

std::optional<WrittenFraction> exact_value(std::string_view number) {
  const auto written = scientific(number);
  if (!written) return std::nullopt;
  if (written->significand.empty()) return WrittenFraction{"0", "1"};
  auto value = written->hexadecimal ? hexadecimal_value(*written) : decimal_value(*written);
  if (value && written->negative) value->numerator.insert(0, 1, '-');
  return value;
}

bool is_exactly_a_double(std::string_view number) {
  const auto value = exact_value(number);
  return value && exact_double(value->numerator, value->denominator).has_value();
}

}  // namespace touchstone::numbers
