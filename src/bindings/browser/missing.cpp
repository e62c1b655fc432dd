// SPDX-License-Identifier: MIT
#include <version>

#ifndef __cpp_lib_to_chars

#ifndef FMT_HEADER_ONLY
#define FMT_HEADER_ONLY
#endif
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

std::to_chars_result written(const std::string& text, char* first, char* last) {
  if (text.size() > static_cast<std::size_t>(last - first)) return {last, std::errc::value_too_large};
  return {std::copy(text.begin(), text.end(), first), std::errc()};
}

/// value = 0.DIGITS 10^exponent with the fewest digits that read back as `value`, which is above zero.
struct Shortest {
  std::string digits;
  int exponent;

  explicit Shortest(double value) {
    const std::string text = fmt::format("{}", value);  // by the algorithm of fmt, fixed or with an exponent
    const std::size_t e = std::min(text.find('e'), text.size()), point = std::min(text.find('.'), e);
    exponent = static_cast<int>(point) + (e < text.size() ? std::atoi(text.c_str() + e + 1) : 0);
    digits = text.substr(0, point) + (point < e ? text.substr(point + 1, e - point - 1) : "");
    const std::size_t zeros = digits.find_first_not_of('0');
    digits.erase(0, zeros);
    exponent -= static_cast<int>(zeros);
    digits.erase(digits.find_last_not_of('0') + 1);
  }
};

/// The shorter of the fixed form and that with an exponent, and of two that are as long the first.
std::string shorter_form(double value) {
  const auto [digits, exponent] = Shortest(value);
  const int count = static_cast<int>(digits.size());
  const std::string scientific =
      digits.substr(0, 1) + (count > 1 ? "." + digits.substr(1) : "") + fmt::format("e{:+03}", exponent - 1);
  const int length = exponent >= count ? exponent : exponent > 0 ? count + 1 : 2 - exponent + count;
  if (static_cast<std::size_t>(length) > scientific.size()) return scientific;
  if (exponent >= count) return fmt::format("{:.0f}", value);  // all digits of an integer
  const std::size_t whole = static_cast<std::size_t>(std::max(exponent, 0));
  if (exponent > 0) return digits.substr(0, whole) + "." + digits.substr(whole);
  return "0." + std::string(static_cast<std::size_t>(-exponent), '0') + digits;
}

}  // namespace

namespace std {

to_chars_result to_chars(char* first, char* last, double value) {
  const double size = abs(value);
  return written((signbit(value) ? "-" : "") + (isnan(value)   ? "nan"
                                                : isinf(value) ? "inf"
                                                : size == 0    ? "0"
                                                               : shorter_form(size)),
                 first, last);
}

to_chars_result to_chars(char* first, char* last, double value, chars_format) {
  char text[40];
  snprintf(text, sizeof text, "%a", abs(value));
  if (fpclassify(value) == FP_SUBNORMAL) {  // with the least exponent, and not the digit 1 before the point
    snprintf(text, sizeof text, "0x0.%013llx", static_cast<unsigned long long>(abs(value) / 0x1p-1074));
    string digits(text);
    digits.erase(digits.find_last_not_of('0') + 1);
    snprintf(text, sizeof text, "%sp-1022", digits.c_str());
  }
  const string_view form(text);
  return written((signbit(value) ? "-" : "") + string(form.substr(form.starts_with("0x") ? 2 : 0)), first, last);
}

from_chars_result from_chars(const char* first, const char* last, double& value, chars_format format) {
  const bool is_negative = first != last && *first == '-', is_hex = format == chars_format::hex;
  const char* const digits = first + (is_negative ? 1 : 0);
  constexpr string_view kWithin = "0123456789abcdefABCDEFpP+-.";
  // Neither a sign nor "0x" nor a name may follow: strtod would take them.
  if (digits == last ||
      string_view(is_hex ? ".0123456789abcdefABCDEF" : ".0123456789").find(*digits) == string_view::npos)
    return {first, errc::invalid_argument};
  const char* const end = find_if(digits, last, [&](char c) { return kWithin.find(c) == string_view::npos; });
  const string text = (is_hex ? "0x" : "") + string(digits, end);
  char* stop = nullptr;
  // strtod of a hexfloat rounds some subnormals wrongly there; a long double has 113 bits.
  const double size = is_hex ? static_cast<double>(strtold(text.c_str(), &stop)) : strtod(text.c_str(), &stop);
  const auto taken = stop - text.c_str() - (is_hex ? 2 : 0);
  if (taken <= 0) return {first, errc::invalid_argument};
  const string_view number(digits, static_cast<size_t>(taken));
  const string_view mantissa = number.substr(0, number.find_first_of(is_hex ? "pP" : "eE"));
  const bool is_zero = mantissa.find_first_not_of("0.") == string_view::npos;
  if (isinf(size) || (size == 0 && !is_zero)) return {digits + taken, errc::result_out_of_range};
  value = is_negative ? -size : size;
  return {digits + taken, errc()};
}

}  // namespace std

#endif
