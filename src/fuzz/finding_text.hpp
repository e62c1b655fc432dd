// Queries, claims and answers of findings as text.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// The shortest decimal that is this double: "0.1", "-0", "1e+300", "nan".
std::string decimal_text(double value);

/// A corner a line, each after `indent`: "a0  (0, 0.5, 0) -> (1, 0, 0)", "b1  (0, 0, 1) stands still".
std::string corners_text(const Query& query, const std::string& indent);

std::string claim_text(const Reply& reply);   ///< "contact at 0.5", "no contact", "none: it crashed"
std::string truth_text(const Answer& truth);  ///< "contact at 0.5", "contact between 0.1 and the next double"

}  // namespace touchstone::fuzz
