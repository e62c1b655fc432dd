// The bracket level: the sign changes of V isolated with certified signs, the side conditions decided over each
// bracket, and the time of a contact driven to its two neighbouring doubles, all in error-bounded doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "filters/filters.hpp"
#include "filters/same_side.hpp"

namespace touchstone::filters {

/// Decides an edge-edge or vertex-face query whose contact, if any, is an ordinary crossing inside both elements, at the
/// step's ends too; asks for an exact value only where a time is too close to a double, or too small, to tell.
/// On `contact` the answer is complete (nature, features, times, weights) but for its level; on anything else it is
/// untouched. `frame` is the query's and `coefficients` are its coplanarity_coefficients.
Decision bracket(const Query& query, const Frame& frame, const std::array<double, 4>& coefficients, double t_max,
                 Want want, ExactValue exact_value, Answer& answer);

}  // namespace touchstone::filters
