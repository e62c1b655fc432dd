// Compiled for vectors of 128 bits and fused multiply-add; called only where the machine has both.
// SPDX-License-Identifier: MIT
#include "filters/columns/refined_kernel.hpp"
#include "filters/refined_widths.hpp"

namespace touchstone::filters {

RefineKernel refine_kernel_128_fused(Kind kind) noexcept { return refine_kernel_for<2>(kind); }

}  // namespace touchstone::filters
