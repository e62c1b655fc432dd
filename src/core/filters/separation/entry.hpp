// The first time within a separation, in error-bounded arithmetic.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "filters/question.hpp"
#include "numbers/doubles/bounded.hpp"

namespace touchstone::filters {

/// Whether and when the elements of a valid query come within a valid separation > 0 in [0, t_max]. `answer`
/// comes in as Answer() and is complete when the finding is `contact`; its level is not set. Uncertain where the
/// elements graze the separation, where the exact time is a double, where a foot is at a feature's border or the
/// closest points are not certainly unique, and where coordinates are far from ordinary size. `time`, if not null,
/// becomes the exact time of a contact after t = 0.
Outcome decide_entry(const Query& query, const Separation& separation, double t_max, Answer& answer,
                     numbers::BoundedPair* time = nullptr) noexcept;

}  // namespace touchstone::filters
