// Compiled for AVX2 and fused multiply-add.
// SPDX-License-Identifier: MIT
#include "filters/contact_values_steps.hpp"

namespace touchstone::filters {

extern const ContactValuesFunctions kFusedContactValues;
const ContactValuesFunctions kFusedContactValues = kContactValues;

}  // namespace touchstone::filters
