// Fast tests in doubles. Each is sound by itself for any finite input in the default floating-point environment: it
// proves something, or says that it is uncertain. It never guesses.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/separation.hpp>

#include "filters/apart/same_side.hpp"
#include "filters/question.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

/// The tests after same_side: separation and shared corners (Level::filter) and the bracket level (Level::bracket).
/// `answer` is the caller's object, so that it is never copied. It comes in as Answer(). It is complete when it goes
/// out, unless the finding is uncertain or the question is for contact only.
Decision decide_by_filters(const Question& question, Answer& answer);

/// The same for a valid separation > 0, after clear_all_along. `time`, if not null, becomes the exact time of a contact
/// after t = 0.
Outcome decide_by_filters(const Query& query, const Separation& separation, double t_max, Answer& answer,
                          numbers::BoundedPair* time = nullptr);

}  // namespace touchstone::filters
