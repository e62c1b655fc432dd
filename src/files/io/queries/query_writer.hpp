// Queries as rows of a query file.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/query.hpp>

namespace touchstone::io {

/// The exact value of a finite double, in lowest terms with a positive denominator (a power of two).
Fraction fraction_of(double value);

/// Appends the rows of one query, each with this truth, to the text of a query file. The coordinates must be finite.
void append_query(std::string& out, const Query& query, bool truth);

/// The same for rational coordinates, as they are written: no fraction is reduced.
void append_query(std::string& out, const RationalQuery& query, bool truth);

}  // namespace touchstone::io
