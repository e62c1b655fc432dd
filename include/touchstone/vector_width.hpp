// The SIMD width of a batch, and the widths that this machine has.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/version.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The SIMD width of a batch: the number of bits of the processor's vector registers that it uses. One instruction then
/// tests several queries.
enum class VectorWidth : std::uint8_t {
  widest,    ///< the widest that both the processor and the library support
  none,      ///< no SIMD: one query at a time
  bits_128,  ///< two doubles; every supported processor has it
  bits_256,  ///< four doubles, AVX2
  bits_512   ///< eight doubles, AVX-512
};

/// Whether the processor and this build of the library support this SIMD width. True for widest, none and bits_128.
bool has_vectors(VectorWidth width) noexcept;

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
