// Compiled for AVX2 and fused multiply-add.
// SPDX-License-Identifier: MIT
#include "filters/contact_values_steps.hpp"

namespace touchstone::filters {

ContactValues contact_values_fused(const Query& query, double t, std::size_t axis);

ContactValues contact_values_fused(const Query& query, double t, std::size_t axis) {
  return rounded(precise_values(query, t, axis));
}

}  // namespace touchstone::filters
