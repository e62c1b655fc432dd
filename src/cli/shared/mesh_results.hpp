// What a check of an animation found, as text for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sequence/results.hpp"

namespace touchstone::cli {

/// "face 7 (3-4-9) of sphere", in the numbers of the file.
std::string element_for_person(const sequence::NamedElement& element);

/// "3 intersections, 2 of them folds".
std::string intersections_for_person(const sequence::IntersectionCounts& counts);

/// "least distance 0.25 in the max metric".
std::string least_distance_for_person(double distance, Metric metric);

/// The last lines of a run, with their ends. The last one has the verdict and all that it leaves out: "12 steps: 11
/// free, 1 not free (8 vertices, ...); 1 vertex in no element was left out". A likely cause of contacts comes before it.
/// @param frames  those of the report
std::string counts_for_person(const sequence::Heading& heading, const std::vector<sequence::FrameEntry>& frames,
                              const sequence::ResultCounts& counts);

}  // namespace touchstone::cli
