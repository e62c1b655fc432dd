// Compiled for vectors of 256 bits; called only where the machine has them.
// SPDX-License-Identifier: MIT
#include "filters/apart/same_side_widths.hpp"
#include "filters/columns/same_side_kernel.hpp"

namespace touchstone::filters {

SameSideKernel same_side_kernel_256(Kind kind) noexcept { return kernel_for<4>(kind); }
ClearanceKernel clearance_kernel_256(Kind kind, Metric metric) noexcept {
  return clearance_kernel_for<4>(kind, metric);
}

}  // namespace touchstone::filters
