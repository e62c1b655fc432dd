// The story of `explain` as HTML.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "exact/exact.hpp"

namespace touchstone::view {

/// Text: "Edge a and edge b touch first at t = 0.5."
std::string answer_sentence(Kind kind, const Answer& answer, double t_max, const Separation& separation);

/// The answer, the exact polynomials, and the candidate times with the signs that decide them.
std::string story_html(Kind kind, bool curved, const exact::Story& story, double t_max, const Separation& separation);

}  // namespace touchstone::view
