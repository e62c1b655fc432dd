// Compiled for vectors of 256 bits; called only where the machine has them.
// SPDX-License-Identifier: MIT
#include "filters/columns/bracket_kernel.hpp"

namespace touchstone::filters {

BracketKernel bracket_kernel_256(Kind kind) noexcept { return bracket_kernel_for<4>(kind); }

}  // namespace touchstone::filters
