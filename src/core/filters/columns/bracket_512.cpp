// Compiled for vectors of 512 bits; called only where the machine has them.
// SPDX-License-Identifier: MIT
#include "filters/columns/bracket_kernel.hpp"

namespace touchstone::filters {

BracketKernel bracket_kernel_512(Kind kind) noexcept { return bracket_kernel_for<8>(kind); }

}  // namespace touchstone::filters
