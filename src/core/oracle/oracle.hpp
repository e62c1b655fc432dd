// The independent second opinion: every definition of the design decided through CGAL's algebraic kernel. Slow and
// plain on purpose; shares no decision code with `exact` or `filters`.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::oracle {

inline Answer no_contact() {
  Answer answer;
  answer.level = Level::oracle;
  return answer;
}

/// Whether the library is built with CGAL. Without it every other function here throws InvalidQuery.
bool is_present() noexcept;

/// The first contact in [0, t_max]; level is Level::oracle. The query must be valid (finite, t_max in [0, 1],
/// well-formed fractions) and the floating-point environment the default one: callers in `solver` see to both.
Answer decide_by_oracle(const Query& query, double t_max);
Answer decide_by_oracle(const RationalQuery& query, double t_max);
Answer decide_by_oracle(const CurvedQuery& query, double t_max);

/// The same for contact within a separation > 0.
Answer decide_by_oracle(const Query& query, double t_max, const Separation& separation);
Answer decide_by_oracle(const RationalQuery& query, double t_max, const Separation& separation);
Answer decide_by_oracle(const CurvedQuery& query, double t_max, const Separation& separation);

/// V(t) through CGAL's number types, for edge-edge and vertex-face queries and 0 <= t <= 1: the exact sign, and the
/// value within a relative error of 2^-50. V is the determinant of the rows a1 - a0, b1 - b0, b0 - a0 of an edge-edge
/// query and of the rows f1 - f0, f2 - f0, v - f0 of a vertex-face query, which fixes its sign.
/// A value that underflows is the least double of its sign; one that overflows is infinite.
double coplanarity_at(const Query& query, double t);

}  // namespace touchstone::oracle
