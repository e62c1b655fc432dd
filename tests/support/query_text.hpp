// The text of a failing test: queries as hexfloats that can be pasted into a test, answers field by field.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

namespace touchstone::tests {

/// The shortest C hexfloat of a double: "0x1.8p+1", "-0x0p+0", "inf".
std::string hexfloat(double value);

/// A C++ initializer of the query's struct: "EdgeEdge{{{{0x1p+0, ...}, ...}}, {{...}}}".
std::string cpp_initializer(const Query& query);

/// The corners and motions that a curved query reads, one a line: "a0  body 0 {0x1p+0, ...}", "b0  curve {...} {...}",
/// "motion 0  q0 {...} q1 {...} p0 {...} p1 {...}".
std::string curved_text(const CurvedQuery& query);

/// "contact at [0x1p-1, 0x1p-1] crossing a0 b weights (...) (...) by exact", or "no contact by filter".
std::string describe(const Answer& answer);

}  // namespace touchstone::tests
