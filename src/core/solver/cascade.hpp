// The cascade: the filters, then the exact level where they are uncertain.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "filters/refined_root.hpp"

// A function that is not inlined and reads its operands from memory: the compiler cannot move its operations out of the
// caller's environment guard.
#if defined(__GNUC__)
#define TOUCHSTONE_BEHIND_GUARD __attribute__((noinline))
#else
#define TOUCHSTONE_BEHIND_GUARD
#endif

namespace touchstone::solver {

/// Takes out of the answer what is not wanted of a contact, which the levels may have written.
void trim(Answer& answer, Wanted wanted) noexcept;

/// Validates a query and answers it, in the default floating-point environment. `query.kind` says which corners count.
/// @throws InvalidQuery  naming the method, the kind, t_max or the first coordinate that is not finite
TOUCHSTONE_BEHIND_GUARD Answer answer(const Query& query, Method method, double t_max, Wanted wanted = Wanted::all);

/// The same by a method with filters, for a query that the first of them, same_side, leaves.
TOUCHSTONE_BEHIND_GUARD Answer answer_after_same_side(const Query& query, Method method, double t_max, Wanted wanted);

/// The same for such a query that is valid, and of which the bracket level has found the one root. `inside_step`: the
/// root certainly lies inside [0, t_max].
TOUCHSTONE_BEHIND_GUARD Answer answer_at_root(const Query& query, const filters::SimpleRoot& root, bool inside_step,
                                              Method method, double t_max, Wanted wanted);

/// The same where the root is refined, too: a contact or none.
TOUCHSTONE_BEHIND_GUARD Answer answer_at_refined_root(Kind kind, const filters::RefinedRoot& root, Wanted wanted);

/// The same for contact within a separation, which is valid. @throws InvalidQuery the same
TOUCHSTONE_BEHIND_GUARD Answer answer(const Query& query, const Separation& separation, Method method, double t_max,
                                      Wanted wanted = Wanted::all);

/// The same for rational coordinates and for curved queries. @throws InvalidQuery  also naming the first fraction,
/// corner or motion without meaning
TOUCHSTONE_BEHIND_GUARD Answer answer(const RationalQuery& query, const Separation& separation, Method method,
                                      double t_max, Wanted wanted);
TOUCHSTONE_BEHIND_GUARD Answer answer(const CurvedQuery& query, Method method, double t_max,
                                      Wanted wanted = Wanted::all);
TOUCHSTONE_BEHIND_GUARD Answer answer(const CurvedQuery& query, const Separation& separation, Method method,
                                      double t_max, Wanted wanted = Wanted::all);

}  // namespace touchstone::solver
