// SPDX-License-Identifier: MIT
#include "filters/contact_values_steps.hpp"

namespace touchstone::filters {

#ifdef TOUCHSTONE_X86_VECTORS
ContactValues contact_values_fused(const Query& query, double t, std::size_t axis);
#endif

namespace {
ContactValues contact_values_plain(const Query& query, double t, std::size_t axis) {
  return rounded(precise_values(query, t, axis));
}
}  // namespace

ContactValuesFunction contact_values_function(bool fused) noexcept {
  if (!fused) return contact_values_plain;
#ifdef TOUCHSTONE_X86_VECTORS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return contact_values_fused;
#endif
  return nullptr;
}

ContactValues contact_values(const Query& query, double t, std::size_t axis) noexcept {
#ifdef TOUCHSTONE_X86_VECTORS
  if (const auto fused = contact_values_function(true)) return fused(query, t, axis);
#endif
  return contact_values_plain(query, t, axis);
}

}  // namespace touchstone::filters
