// SPDX-License-Identifier: MIT
#include "filters/coplanar_gradient_steps.hpp"

namespace touchstone::filters {

#ifdef TOUCHSTONE_X86_VECTORS
extern const CoplanarGradient kFusedCoplanarGradient;
#endif

CoplanarGradient coplanar_gradient_function(bool fused) noexcept {
  if (!fused) return gradient_at_contact;
#ifdef TOUCHSTONE_X86_VECTORS
  if (contact_values_functions(true) != nullptr) return kFusedCoplanarGradient;
#endif
  return nullptr;
}

bool coplanar_gradient(const Query& query, double toi, double toi_upper, geometry::EndGradients& gradient) noexcept {
  const CoplanarGradient fused = coplanar_gradient_function(true);
  return (fused != nullptr ? fused : gradient_at_contact)(query, toi, toi_upper, gradient);
}

}  // namespace touchstone::filters
