// SPDX-License-Identifier: MIT
#include "io/foreign_bytes.hpp"

#include <string>

#include "io/fail.hpp"

namespace touchstone::io {
namespace {

/// With a byte order mark, or of ASCII characters alone, whose other byte is zero.
bool is_utf_16(std::string_view start) {
  if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) return true;
  if (start.size() < 4) return false;
  const auto is_zero = [&](std::size_t i) { return start[i] == '\0'; };
  return is_zero(0) != is_zero(1) && is_zero(0) == is_zero(2) && is_zero(1) == is_zero(3);
}

}  // namespace

void refuse_foreign_bytes(std::string_view file, std::string_view start) {
  struct Packed {
    std::string_view bytes, name, unpacker;
  };
  constexpr Packed kPacked[] = {{"\x1F\x8B", "gzip", "gunzip"},
                                {"PK\x03\x04", "zip", "unzip"},
                                {"BZh", "bzip2", "bunzip2"},
                                {"\xFD\x37zXZ", "xz", "unxz"},
                                {"\x28\xB5\x2F\xFD", "zstd", "unzstd"}};
  for (const auto& [bytes, name, unpacker] : kPacked) {
    if (!start.starts_with(bytes)) continue;
    fail(file, "is packed by " + std::string(name) + ", which is not read; unpack it first: " + std::string(unpacker));
  }
  if (is_utf_16(start)) {
    fail(file, "is text in UTF-16, which is not read; save it as UTF-8: iconv -f UTF-16 -t UTF-8");
  }
}

}  // namespace touchstone::io
