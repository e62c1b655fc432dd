// What a verdict is about, and what it says nothing about, in words.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sequence/results.hpp"

namespace touchstone::sequence {

/// What was asked about: "8 vertices, 18 edges, 12 faces".
/// @param frames  those of the report
std::string scope_of(const Heading& heading, const std::vector<FrameEntry>& frames);

/// What was not asked though a reader may think so, a sentence without a full stop each. All of it is in the report.
std::vector<std::string> warnings_of(const Heading& heading, const std::vector<FrameEntry>& frames,
                                     const ResultCounts& counts);

/// A likely cause of contacts that are everywhere: vertices that are not joined, or a separation above the lengths of
/// edges. Empty without one.
std::string likely_cause(const Heading& heading, const ResultCounts& counts);

}  // namespace touchstone::sequence
