// How near a query is to queries on which the filters are uncertain. Hill climbing descends this number.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "fuzz/any_query.hpp"

namespace touchstone::fuzz {

/// The quotient of least magnitude of a value that a filter looks at and the bound on its rounding error: V's Bernstein
/// coefficients; at the first sign change of V over the step, the conditions that the contact lies inside both
/// elements; the gap between the elements along the direction that the separation test tries. Within [-1, 1] that
/// filter is uncertain, and near 1 and -1 the error bounds are tested. The sign is that of the value. +infinity when
/// nothing can be compared; never NaN. It is computed in doubles and is only a guide.
///
/// With a separation above 0 the values are what the filters for separations look at, each less what the separation
/// asks for: V's Bernstein coefficients less the distance times the greatest norm of n; the gap along the direction
/// between the closest points at mid-step less the distance times the direction's norm; and the same gap at the step's
/// start alone, at its end, and at a time of least distance.
double filter_margin(const Query& query, const Separation& separation = {}) noexcept;

/// The same for a curved query: the gap between the control points of both elements' paths, along an axis or the line
/// between their middles, less what the separation asks for, over the bound on its rounding error.
double filter_margin(const CurvedQuery& query, const Separation& separation = {}) noexcept;

inline double filter_margin(const AnyQuery& query, const Separation& separation = {}) noexcept {
  const auto* const curved = std::get_if<CurvedQuery>(&query);
  return curved != nullptr ? filter_margin(*curved, separation)
                           : filter_margin(*std::get_if<Query>(&query), separation);
}

}  // namespace touchstone::fuzz
