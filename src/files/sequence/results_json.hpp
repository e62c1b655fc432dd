// Results as JSON, each in one line, and back.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "json/json_node.hpp"
#include "sequence/results.hpp"

namespace touchstone::sequence {

/// Of a sequence that is read.
inline constexpr std::uint64_t kMostFrames = 1'000'000'000'000;

/// `text`, which is valid UTF-8, as a JSON string with its quotes.
std::string json_string(std::string_view text);

/// Two elements as a JSON object, without how they meet.
/// @param more  further members, each with a comma before it
std::string elements_json(const PairContact& pair, std::string_view more);

/// Two elements in contact as a JSON object.
/// @param more  further members, each with a comma before it
std::string contact_json(const PairContact& pair, std::string_view more = {});

/// A JSON list.
std::string intersections_json(const std::vector<RestContact>& intersections);

/// One line, without its end.
std::string result_json(const Result& result);

/// The same for readers of tables: with the frames' names, and doubles as the shortest decimals that read back as them.
/// @param from  the label of the result's frame, or of the first frame of its step
/// @param to    the label of the step's last frame; not used for a frame at rest
std::string result_line(const Result& result, std::string_view from, std::string_view to);

/// @throws Error  for anything that result_json does not write: it names the key
Result result_from(const json::JsonNode& node);

/// Text that io::printable leaves as it is, and that is not empty: it may be printed. @throws Error
std::string clean_text_from(const json::JsonNode& node);

/// 64 lower-case hexadecimal digits. @throws Error
std::string digest_from(const json::JsonNode& node);

}  // namespace touchstone::sequence
