// The story of `explain` as HTML.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "exact/exact.hpp"

namespace touchstone::view {

/// The answer, the exact polynomials, and the candidate times with the signs that decide them.
std::string story_html(Kind kind, bool curved, const exact::Story& story, double t_max, const Separation& separation);

}  // namespace touchstone::view
