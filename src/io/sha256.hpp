// The digest SHA-256 (FIPS 180-4), written here so that the project depends on no cryptographic library for 100 lines.
// Anybody can check one without this program: `sha256sum` computes the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace touchstone::io {

/// 64 lower-case hexadecimal digits. No two texts with the same digest are known.
std::string sha256(std::string_view bytes);

/// The same, without the processor's instructions for it. For tests.
std::string sha256_in_portable_code(std::string_view bytes);

}  // namespace touchstone::io
