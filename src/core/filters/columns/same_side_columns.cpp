// SPDX-License-Identifier: MIT
#include "filters/columns/same_side_columns.hpp"

#include "filters/apart/same_side_widths.hpp"
#include "filters/columns/same_side_kernel.hpp"

namespace touchstone::filters {

bool has_kernel(VectorWidth width) noexcept {
  switch (width) {
    case VectorWidth::widest:
    case VectorWidth::none:
    case VectorWidth::bits_128: return true;
#ifdef TOUCHSTONE_X86_VECTORS
    case VectorWidth::bits_256: return __builtin_cpu_supports("avx2") != 0;
    case VectorWidth::bits_512: return __builtin_cpu_supports("avx512f") != 0;
#else
    case VectorWidth::bits_256:
    case VectorWidth::bits_512: break;
#endif
  }
  return false;
}

VectorWidth narrowed(VectorWidth width) noexcept {
  if (width != VectorWidth::widest) return width;
  return has_kernel(VectorWidth::bits_512)   ? VectorWidth::bits_512
         : has_kernel(VectorWidth::bits_256) ? VectorWidth::bits_256
                                             : VectorWidth::bits_128;
}

SameSideKernel same_side_kernel(Kind kind, VectorWidth width) noexcept {
  width = narrowed(width);
  if (!has_kernel(width)) return nullptr;
#ifdef TOUCHSTONE_X86_VECTORS
  if (width == VectorWidth::bits_512) return same_side_kernel_512(kind);
  if (width == VectorWidth::bits_256) return same_side_kernel_256(kind);
#endif
  return width == VectorWidth::none ? kernel_for<1>(kind) : kernel_for<2>(kind);
}

ClearanceKernel clearance_kernel(Kind kind, Metric metric, VectorWidth width) noexcept {
  width = narrowed(width);
  if (!has_kernel(width)) return nullptr;
#ifdef TOUCHSTONE_X86_VECTORS
  if (width == VectorWidth::bits_512) return clearance_kernel_512(kind, metric);
  if (width == VectorWidth::bits_256) return clearance_kernel_256(kind, metric);
#endif
  return width == VectorWidth::none ? clearance_kernel_for<1>(kind, metric) : clearance_kernel_for<2>(kind, metric);
}

}  // namespace touchstone::filters
