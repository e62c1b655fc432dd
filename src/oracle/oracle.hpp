// The independent second opinion: every definition of the design decided through CGAL's algebraic kernel. Slow and
// plain on purpose; shares no decision code with `exact` or `filters`.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

namespace touchstone::oracle {

/// The first contact in [0, t_max]; level is Level::oracle. The query must be valid (finite, t_max in [0, 1],
/// well-formed fractions) and the floating-point environment the default one: callers in `solver` see to both.
Answer decide_by_oracle(const Query& query, double t_max);
Answer decide_by_oracle(const RationalQuery& query, double t_max);

}  // namespace touchstone::oracle
