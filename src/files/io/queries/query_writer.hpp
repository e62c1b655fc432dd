// Queries as rows of a query file.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <touchstone/query.hpp>

namespace touchstone::io {

/// The exact value of a finite double, in lowest terms with a positive denominator (a power of two).
Fraction fraction_of(double value);

/// Appends the rows of one query to the text of a query file, each with this truth, or of six columns without one. The
/// coordinates must be finite.
void append_query(std::string& out, const Query& query, std::optional<bool> truth);

/// The same for rational coordinates, as they are written: no fraction is reduced.
void append_query(std::string& out, const RationalQuery& query, std::optional<bool> truth);

}  // namespace touchstone::io
