// The kernels that are compiled for processors beyond the least one.
// SPDX-License-Identifier: MIT
#pragma once

#include "filters/columns/same_side_columns.hpp"

namespace touchstone::filters {

SameSideKernel same_side_kernel_256(Kind kind) noexcept;
SameSideKernel same_side_kernel_512(Kind kind) noexcept;
ClearanceKernel clearance_kernel_256(Kind kind, Metric metric) noexcept;
ClearanceKernel clearance_kernel_512(Kind kind, Metric metric) noexcept;

}  // namespace touchstone::filters
