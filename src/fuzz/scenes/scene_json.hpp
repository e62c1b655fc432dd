// The lines of JSON in which a program under test gets a scene and replies.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <touchstone/mesh.hpp>

#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::fuzz {

/// The shortest decimal that reads back as the same double: readers take -0 for an integer, which has no sign.
inline void append_json(std::string& line, double x) {
  line.append(x == 0 && std::signbit(x) ? "-0.0" : numbers::decimal_text(x));
}
inline void append_json(std::string& line, std::uint32_t x) { line.append(std::to_string(x)); }
inline void append_json(std::string& line, const Vec3& p) {
  for (const auto& [before, x] : {std::pair{"[", p.x}, {",", p.y}, {",", p.z}}) append_json(line.append(before), x);
  line.append("]");
}

/// A list, of lists too.
template <class List>
auto append_json(std::string& line, const List& list) -> decltype(void(list.size())) {
  line.append("[");
  for (std::size_t i = 0; i < list.size(); ++i) append_json(i > 0 ? line.append(",") : line, list[i]);
  line.append("]");
}

/// A key with its value. @param before  `{` or a comma
template <class Value>
void append_member(std::string& line, const char* before, const char* key, const Value& value) {
  append_json(line.append(before).append("\"").append(key).append("\":"), value);
}

/// The members "separation" and "metric", after a comma.
void append_separation(std::string& line, const Separation& separation);

/// The words of a reply, whatever it is about.
struct ReplyWords {
  std::optional<double> free, first_contact;              ///< infinity for null
  std::optional<std::vector<nlohmann::json>> candidates;  ///< each a list of a word and two elements
};

/// @param candidate  an example of one @throws NoReply  for a line that is no reply, with the reason
ReplyWords read_reply_words(std::string_view line, const char* candidate);

/// Not a number of any element.
inline constexpr MeshIndex kNoElement = std::numeric_limits<MeshIndex>::max();

/// The number of an element; nothing for a value that is none. A number that no mesh has is kNoElement.
inline std::optional<MeshIndex> read_index(const nlohmann::json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  return static_cast<MeshIndex>(std::min<std::uint64_t>(value.get<std::uint64_t>(), kNoElement));
}

[[noreturn]] void refuse_candidate(const char* example);

/// The reply of a line. Whether the elements of its candidates exist is not asked.
/// @param example       a candidate
/// @param read_element  of a value: an element, or nothing
/// @throws NoReply  for a line that is no reply, with the reason
template <class Reply, class ReadElement>
Reply read_reply(std::string_view line, const char* example, const ReadElement& read_element) {
  ReplyWords words = read_reply_words(line, example);
  Reply reply;
  reply.free = words.free;
  reply.first_contact = words.first_contact;
  if (!words.candidates) return reply;
  reply.candidates.emplace();
  for (const nlohmann::json& entry : *words.candidates) {
    const auto kind = from_name<Kind>(entry[0].get<std::string>());
    const auto first = read_element(entry[1]), second = read_element(entry[2]);
    if (!kind || !first || !second) refuse_candidate(example);
    reply.candidates->push_back({*kind, *first, *second});
  }
  return reply;
}

}  // namespace touchstone::fuzz
