// Queries, claims and answers of findings as text.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "fuzz/any_query.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// The shortest decimal that is this double: "0.1", "-0", "1e+300", "nan".
std::string decimal_text(double value);

/// A corner a line, each after `indent`: "a0  (0, 0.5, 0) -> (1, 0, 0)", "b1  (0, 0, 1) stands still".
/// For a curved query a corner or motion a line: "a0  body 0 (1, 0, 0)", "b0  curve (0, 0, 1) (1, 0, 1)".
std::string corners_text(const AnyQuery& query, const std::string& indent);

std::string claim_text(const Reply& reply);   ///< "contact at 0.5", "no contact", "none: it crashed"
std::string truth_text(const Answer& truth);  ///< "contact at 0.5", "contact between 0.1 and the next double"

}  // namespace touchstone::fuzz
