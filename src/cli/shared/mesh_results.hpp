// What a check of an animation found, as text for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sequence/results.hpp"

namespace touchstone::cli {

/// "face 7 (3-4-9) of sphere", in the numbers of the file.
std::string element_for_person(const sequence::NamedElement& element);

/// The last line of a run, with its end: "12 steps: 11 free, 1 not free".
std::string counts_for_person(const sequence::Heading& heading, const sequence::ResultCounts& counts);

}  // namespace touchstone::cli
