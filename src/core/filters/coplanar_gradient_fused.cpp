// Compiled for AVX2 and fused multiply-add.
// SPDX-License-Identifier: MIT
#include "filters/coplanar_gradient_steps.hpp"

namespace touchstone::filters {

extern const CoplanarGradient kFusedCoplanarGradient;
const CoplanarGradient kFusedCoplanarGradient = gradient_at_contact;

}  // namespace touchstone::filters
