// The cascade: filters, then exact. SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::solver {

/// Answers a valid query in the default floating-point environment. `query.kind` says which corners count.
/// Not inlined, and its operands come from memory: no operation moves out of the caller's environment guard.
#if defined(__GNUC__)
__attribute__((noinline))
#endif
Answer answer(const Query& query, Method method, double t_max);

/// answer(query, Method::fast, t_max).contact.
#if defined(__GNUC__)
__attribute__((noinline))
#endif
bool any_contact(const Query& query, double t_max);

}  // namespace touchstone::solver
