// Isolation of the roots of a polynomial of any degree.
// SPDX-License-Identifier: MIT
#pragma once

#include "numbers/roots/coefficients.hpp"
#include "numbers/roots/real_root.hpp"

namespace touchstone::numbers {

/// Appends the distinct roots of p in the open interval (0, limit), ascending, each with its multiplicity, by
/// Descartes' rule and bisection. p's leading coefficient and its values at 0 and at the limit are not zero.
void isolate_by_bisection(Coefficients p, const Exact& limit, RootList& roots);

}  // namespace touchstone::numbers
