// The contacts and intersections of an animation as CSV.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/answers/answer_writer.hpp"
#include "sequence/results.hpp"

namespace touchstone::sequence {

/// The header, with its line end.
inline constexpr std::string_view kPairsHeader =
    "from,to,contact,kind,first_element,first_vertices,first_number,first_part,second_element,second_vertices,"
    "second_number,second_part,toi,toi_upper,nature,feature_a,feature_b,trend\n";

/// A row for each pair of a result.
/// @param from  the label of the result's frame, or of the first frame of its step
/// @param to    the label of the step's last frame; empty for a frame at rest
std::string pair_rows(const Result& result, std::string_view from, std::string_view to, io::Numbers form);

/// The whole table of a report.
std::string pairs_table(const Report& report, io::Numbers form);

}  // namespace touchstone::sequence
