// SPDX-License-Identifier: MIT
#include "filters/columns/refined_columns.hpp"

#include "filters/columns/refined_kernel.hpp"
#include "filters/contact_values.hpp"
#include "filters/refined_widths.hpp"

namespace touchstone::filters {

RefineKernel refine_kernel(Kind kind, VectorWidth width) noexcept {
  width = narrowed(width);
  if (width == VectorWidth::none || !has_kernel(width)) return nullptr;
#ifdef TOUCHSTONE_X86_VECTORS
  // Where contact_values is fused, so are these: a low part that underflows is not the same otherwise.
  if (contact_values_functions(true) != nullptr) {
    if (width == VectorWidth::bits_512) return refine_kernel_512_fused(kind);
    if (width == VectorWidth::bits_256) return refine_kernel_256_fused(kind);
    return refine_kernel_128_fused(kind);
  }
#endif
  return refine_kernel_for<2>(kind);
}

}  // namespace touchstone::filters
