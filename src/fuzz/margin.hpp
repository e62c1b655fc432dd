// How near a query is to one on which the filters are uncertain: what hill climbing descends.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

namespace touchstone::fuzz {

/// The least quotient of a value that a filter looks at and the bound on its rounding error: V's Bernstein coefficients;
/// at the first sign change of V over the step, the conditions that the contact lies inside both elements; the gap
/// between the elements along the direction that the separation test tries. Below 1 that filter cannot tell, around 1
/// the error bounds are put to the test. +infinity where nothing can be compared. In doubles, and only a guide.
double filter_margin(const Query& query) noexcept;

}  // namespace touchstone::fuzz
