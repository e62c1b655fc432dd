// How near a query is to one on which the filters are uncertain: what hill climbing descends.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

namespace touchstone::fuzz {

/// The quotient of least magnitude of a value that a filter looks at and the bound on its rounding error: V's Bernstein
/// coefficients; at the first sign change of V over the step, the conditions that the contact lies inside both
/// elements; the gap between the elements along the direction that the separation test tries. Within [-1, 1] that
/// filter cannot tell, near 1 and -1 the error bounds are put to the test. The sign is the value's. +infinity where
/// nothing can be compared; never NaN. In doubles, and only a guide.
double filter_margin(const Query& query) noexcept;

}  // namespace touchstone::fuzz
