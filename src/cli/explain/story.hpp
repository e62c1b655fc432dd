// One query and how it is decided, for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/contact_times.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "exact/exact.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {

/// Every corner at both ends, as the file gives it, and as a hexfloat if it is a double. Whole lines.
std::string corners_for_person(const io::FileQuery& query, const RationalQuery& as_given);

/// Every motion with the angle of its turn, and every corner in the body's own frame or with its control points. Whole
/// lines.
std::string curves_for_person(const CurvedQuery& query);

/// The rung of solver::kLadder that decides the query by Method::fast. Whole lines.
std::string rung_for_person(std::size_t rung);

/// All contact times, exactly. Whole lines.
std::string times_for_person(const std::vector<ContactInterval>& times);

/// The cubic, or the distance's polynomials with a separation, the candidate times with the signs that decide them, and
/// the answer, with the normal if there is one. Whole lines.
/// @param curved  whether the corners move on curves: V is then a polynomial of another degree
std::string story_for_person(Kind kind, bool curved, const exact::Story& story, double t_max,
                             const Separation& separation, const std::optional<std::array<double, 3>>& normal);

}  // namespace touchstone::cli
