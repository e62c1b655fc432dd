// The digest SHA-256 (FIPS 180-4), written here so that the project depends on no cryptographic library for 100 lines.
// Anybody can check one without this program: `sha256sum` computes the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace touchstone::io {

/// The digest of bytes that come one piece after the other.
class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  std::string digest() const;  ///< of all bytes so far; as sha256 gives it

  using State = std::array<std::uint32_t, 8>;
  using AddBlocks = void (*)(State& state, const char* blocks, std::size_t count);

 private:
  friend std::string sha256_in_portable_code(std::string_view bytes);

  State state_;
  AddBlocks add_blocks_;
  std::string rest_;  ///< less than a block
  std::uint64_t size_ = 0;
};

/// 64 lower-case hexadecimal digits. No two texts with the same digest are known.
std::string sha256(std::string_view bytes);

/// The same, without the processor's instructions for it. For tests.
std::string sha256_in_portable_code(std::string_view bytes);

}  // namespace touchstone::io
