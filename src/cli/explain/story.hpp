// One query and how it is decided, for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include <touchstone/query.hpp>

#include "exact/exact.hpp"

namespace touchstone::cli {

/// Every corner at both ends, as the file gives it, and as a hexfloat if it is a double. Whole lines.
std::string corners_for_person(const std::variant<Query, RationalQuery>& query, const RationalQuery& as_given);

/// The cubic, or the distance's polynomials with a separation, the candidate times with the signs that decide them, and
/// the answer, with the normal if there is one. Whole lines.
std::string story_for_person(Kind kind, const exact::Story& story, double t_max, const Separation& separation,
                             const std::optional<std::array<double, 3>>& normal);

}  // namespace touchstone::cli
