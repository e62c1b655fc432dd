// How near a query is to queries on which the filters are uncertain. Hill climbing descends this number.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>

namespace touchstone::fuzz {

/// The quotient of least magnitude of a value that a filter looks at and the bound on its rounding error: V's Bernstein
/// coefficients; at the first sign change of V over the step, the conditions that the contact lies inside both
/// elements; the gap between the elements along the direction that the separation test tries. Within [-1, 1] that
/// filter is uncertain, and near 1 and -1 the error bounds are tested. The sign is that of the value. +infinity when
/// nothing can be compared; never NaN. It is computed in doubles and is only a guide.
double filter_margin(const Query& query) noexcept;

}  // namespace touchstone::fuzz
