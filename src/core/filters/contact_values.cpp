// SPDX-License-Identifier: MIT
#include "filters/contact_values_steps.hpp"

namespace touchstone::filters {

#ifdef TOUCHSTONE_X86_VECTORS
extern const ContactValuesFunctions kFusedContactValues;
#endif

const ContactValuesFunctions* contact_values_functions(bool fused) noexcept {
  if (!fused) return &kContactValues;
#ifdef TOUCHSTONE_X86_VECTORS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return &kFusedContactValues;
#endif
  return nullptr;
}

namespace {
const ContactValuesFunctions& fastest() noexcept {
  const ContactValuesFunctions* const fused = contact_values_functions(true);
  return fused != nullptr ? *fused : kContactValues;
}
}  // namespace

ContactValues contact_values(const Query& query, double t, std::size_t axis) noexcept {
  return fastest().all(query, t, axis);
}
double coplanarity_value(const Query& query, double t) noexcept { return fastest().coplanarity(query, t); }

}  // namespace touchstone::filters
