// SPDX-License-Identifier: MIT
#include "io/times.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace touchstone::io {

std::string hexfloat(double value) {
  std::array<char, 40> buffer;
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value), std::chars_format::hex);
  if (error != std::errc{}) return {};  // cannot happen: the longest is 22 characters
  std::string text = std::signbit(value) ? "-0x" : "0x";
  return text.append(buffer.data(), end);
}

std::optional<double> parse_finite_double(std::string_view text) noexcept {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  if (text.empty() || text.front() == '-') return std::nullopt;
  if (text.find("+-") != std::string_view::npos) return std::nullopt;  // libstdc++ 12 takes it for an exponent's sign
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] =
      std::from_chars(text.data(), last, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (error != std::errc{} || end != last || !std::isfinite(value)) return std::nullopt;
  return negative ? -value : value;
}

}  // namespace touchstone::io
