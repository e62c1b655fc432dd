// SPDX-License-Identifier: MIT
#include "filters/columns/bracket_columns.hpp"

#include "filters/columns/bracket_kernel.hpp"

namespace touchstone::filters {

BracketKernel bracket_kernel(Kind kind, VectorWidth width) noexcept {
  width = narrowed(width);
  if (width == VectorWidth::none || !has_kernel(width)) return nullptr;
#ifdef TOUCHSTONE_X86_VECTORS
  if (width == VectorWidth::bits_512) return bracket_kernel_512(kind);
  if (width == VectorWidth::bits_256) return bracket_kernel_256(kind);
#endif
  return bracket_kernel_for<2>(kind);
}

}  // namespace touchstone::filters
