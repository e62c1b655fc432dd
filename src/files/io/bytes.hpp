// Numbers in binary files, in either byte order.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>

namespace touchstone::io {

/// The unsigned integer of sizeof(Unsigned) bytes at `from`.
template <std::unsigned_integral Unsigned>
Unsigned unsigned_at(const char* from, std::endian order) noexcept {
  Unsigned value;
  std::memcpy(&value, from, sizeof value);
  if (order == std::endian::native) return value;
  if constexpr (sizeof value == 2) return __builtin_bswap16(value);
  if constexpr (sizeof value == 4) return __builtin_bswap32(value);
  if constexpr (sizeof value == 8) return __builtin_bswap64(value);
  return value;
}

inline double float_at(const char* from, std::endian order) noexcept {
  return std::bit_cast<float>(unsigned_at<std::uint32_t>(from, order));
}

inline double double_at(const char* from, std::endian order) noexcept {
  return std::bit_cast<double>(unsigned_at<std::uint64_t>(from, order));
}

}  // namespace touchstone::io
