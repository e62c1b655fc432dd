// The refinement kernels that are compiled for processors with fused multiply-add.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/columns/refined_columns.hpp"

namespace touchstone::filters {

RefineKernel refine_kernel_128_fused(Kind kind) noexcept;
RefineKernel refine_kernel_256_fused(Kind kind) noexcept;
RefineKernel refine_kernel_512_fused(Kind kind) noexcept;

}  // namespace touchstone::filters
