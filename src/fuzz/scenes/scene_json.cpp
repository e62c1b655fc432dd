// SPDX-License-Identifier: MIT
#include "fuzz/scenes/scene_json.hpp"

#include "fuzz/processes/no_reply.hpp"
#include "io/fail.hpp"

namespace touchstone::fuzz {
namespace {

[[noreturn]] void refuse(const std::string& reason) { throw NoReply(FuzzFailure::malformed, reason); }

}  // namespace

void append_separation(std::string& line, const Separation& separation) {
  append_member(line, ",", "separation", separation.distance);
  line.append(",\"metric\":\"").append(name_of(separation.metric)).append("\"");
}

// The value itself may be deep. It is not written again: that would take a call for each level.
void refuse_candidate(const char* example) { refuse(std::string("a candidate must be such as ").append(example)); }

ReplyWords read_reply_words(std::string_view line, const char* candidate) {
  auto text = nlohmann::json::parse(line, nullptr, false);
  const auto right = [&] {
    return std::string(R"(; a reply is such as {"free": 0.5}, {"first_contact": null} or {"candidates": [)") +
           candidate + "]}";
  };
  if (!text.is_object() || text.empty()) refuse(io::in_quotes(std::string(line)) + " is no reply" + right());
  ReplyWords words;
  for (auto& [key, value] : text.items()) {
    const bool is_null = value.is_null() && key == "first_contact";
    if (key == "candidates" && value.is_array()) {
      words.candidates = std::move(value.get_ref<nlohmann::json::array_t&>());  // a copy takes a call for each level
      for (const auto& entry : *words.candidates) {
        if (!entry.is_array() || entry.size() != 3 || !entry[0].is_string()) refuse_candidate(candidate);
      }
    } else if ((key == "free" || key == "first_contact") && (value.is_number() || is_null)) {
      const double number = is_null ? std::numeric_limits<double>::infinity() : value.get<double>();
      (key == "free" ? words.free : words.first_contact) = number;
    } else {
      refuse(io::in_quotes(key) + " is no word of a reply, or has no such value" + right());
    }
  }
  return words;
}

}  // namespace touchstone::fuzz
