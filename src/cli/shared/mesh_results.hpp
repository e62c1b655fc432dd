// What a check of an animation found, as text for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sequence/results.hpp"

namespace touchstone::cli {

/// "face 7 (3-4-9) of sphere", in the numbers of the file.
std::string element_for_person(const sequence::NamedElement& element);

/// "vertex 41 and face 5 (6-7-8)".
std::string pair_for_person(const sequence::PairContact& pair);

/// "t = 0x1p-1 (0.5)", or "t in [0x1.5555555555555p-2, 0x1.5555555555556p-2] (0.333)".
std::string time_range(double toi, double toi_upper);

/// "3 pairs are in contact at the start".
std::string pairs_are(std::size_t count);

/// Of a list on the console; a report has all.
inline constexpr std::size_t kShownPairs = 5;

/// The line "and 7 more" for the end of a list of so many; empty where all are shown.
std::string more_line(std::size_t count, const std::string& indent);

/// A line for each of them, as far as they are shown.
std::string intersection_lines(const std::vector<sequence::RestContact>& contacts, const std::string& indent);

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
