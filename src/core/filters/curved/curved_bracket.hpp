// The bracket level of curved queries. It isolates the roots of V with certified signs, decides the side conditions
// over each bracket, and drives the time of a contact to its two neighbouring doubles, in doubles and double-doubles
// that carry their error bounds along.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>

#include "filters/question.hpp"

namespace touchstone::filters {

/// Decides a query whose contact, if any, is an ordinary crossing of two edges, or of a vertex and a face, inside both.
/// Of a point and an edge, or two points, it only decides that they do not touch. On `contact` the answer is
/// complete; otherwise it is untouched.
Outcome decide_in_brackets(const CurvedQuery& query, double t_max, Answer& answer) noexcept;

/// The same with a separation > 0, for an ordinary entry into it and for elements that are within it from the start on;
/// the closest points are then the only ones.
Outcome decide_in_brackets(const CurvedQuery& query, const Separation& separation, double t_max,
                           Answer& answer) noexcept;

}  // namespace touchstone::filters
