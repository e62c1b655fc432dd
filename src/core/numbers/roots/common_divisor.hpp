// What several polynomials have in common.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numbers/roots/coefficients.hpp"

namespace touchstone::numbers {

/// The polynomial whose roots are the common roots of p and q, all simple, over the complex numbers; integer
/// coefficients without a common factor. p or q may be zero, not both. A constant when they have no common root.
std::vector<Exact> simple_common_divisor(Coefficients p, Coefficients q);

}  // namespace touchstone::numbers
