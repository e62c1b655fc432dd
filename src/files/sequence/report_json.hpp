// The report of a checked animation: JSON with a digest of itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sequence/results.hpp"

namespace touchstone::sequence {

/// The frames that a run or a shard of it reads.
Range range_of(const Heading& heading);

/// The counts of a report's results.
ResultCounts counts_of(const Report& report);

/// The report. The text depends on nothing but its argument.
std::string report_text(const Report& report);

/// The lines of a heading within a report, without the braces around them.
std::string heading_json(const Heading& heading);

/// @throws Error  for text that report_text did not write, or that describes no possible report: it names the key
Report report_from(std::string_view text);

/// The inverse of heading_json with braces around it. @throws Error
Heading heading_from(std::string_view text);

/// What two headings differ in, as the end of a sentence about the first: "is about ..., and ...". Empty if they are
/// equal.
/// @param other  what the second is, for the message: "this run"
std::string difference_of(const Heading& a, const Heading& b, std::string_view other);

}  // namespace touchstone::sequence
