// Compiled for vectors of 512 bits and fused multiply-add; called only where the machine has both.
// SPDX-License-Identifier: MIT
#include "filters/columns/refined_kernel.hpp"
#include "filters/refined_widths.hpp"

namespace touchstone::filters {

RefineKernel refine_kernel_512_fused(Kind kind) noexcept { return refine_kernel_for<8>(kind); }

}  // namespace touchstone::filters
