// SPDX-License-Identifier: MIT
#include "io/answers/answer_writer.hpp"

#include <nlohmann/json.hpp>

#include "io/characters.hpp"
#include "io/times.hpp"
#include "numbers/doubles/decimal_text.hpp"

namespace touchstone::io {

bool begins_formula(std::string_view text) noexcept {
  constexpr std::string_view kMarks = "=+-@\t\r";
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string_view::npos && kMarks.find(text[first]) != std::string_view::npos;
}

std::string_view text_of_field(std::string_view field) noexcept {
  return field.starts_with('\'') && begins_formula(field) ? field.substr(1) : field;
}

std::string csv_field(std::string_view text) {
  const std::string start = begins_formula(text) ? "'" : "";
  const bool has_blanks = text != without_blanks(text);  // which readers may take away
  if (!has_blanks && text.find_first_of(",\"\r\n") == std::string_view::npos) return start + std::string(text);
  std::string field = "\"" + start;
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

std::string number_text(double value, Numbers form) {
  return form == Numbers::hexfloats ? hexfloat(value) : numbers::decimal_text(value);
}

namespace {

/// A row without its line end.
void append_columns(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer,
                    Numbers numbers) {
  out.append(file_field).append(",").append(std::to_string(query));
  if (answer.contact) {
    out.append(",1,")
        .append(number_text(answer.toi, numbers))
        .append(",")
        .append(number_text(answer.toi_upper, numbers));
    out.append(",").append(name_of(answer.nature));
    out.append(",").append(name_of(answer.feature_a));
    out.append(",").append(name_of(answer.feature_b));
  } else {
    out.append(",0,,,,,");
  }
  out.append(",").append(name_of(answer.level));
}

}  // namespace

void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer,
                   Numbers numbers) {
  append_columns(out, file_field, query, answer, numbers);
  out.append("\n");
}

void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer,
                   const Separation& separation, Numbers numbers) {
  append_columns(out, file_field, query, answer, numbers);
  out.append(!answer.contact ? "," : answer.starts_within ? ",1" : ",0");
  out.append(",").append(name_of(answer.trend));
  out.append(",")
      .append(number_text(separation.distance, numbers))
      .append(",")
      .append(name_of(separation.metric))
      .append("\n");
}

std::string json_string(std::string_view text) {
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
  return nlohmann::json(std::string(text)).dump(-1, ' ', false, kReplace);
}

void append_answer_line(std::string& out, std::string_view file_string, std::uint64_t query, const Answer& answer,
                        const Separation* separation, std::string_view more) {
  const auto add = [&out, &answer](const char* key, const std::string& value) {
    out.append(",\"").append(key).append("\":").append(answer.contact ? value : "null");
  };
  const auto quoted = [](std::string_view name) { return std::string("\"").append(name) + "\""; };
  out.append("{\"file\":").append(file_string).append(",\"query\":").append(std::to_string(query));
  out.append(",\"contact\":").append(answer.contact ? "true" : "false");
  add("toi", number_text(answer.toi, Numbers::decimals));
  add("toi_upper", number_text(answer.toi_upper, Numbers::decimals));
  add("nature", quoted(name_of(answer.nature)));
  add("feature_a", quoted(name_of(answer.feature_a)));
  add("feature_b", quoted(name_of(answer.feature_b)));
  out.append(",\"level\":").append(quoted(name_of(answer.level)));
  if (separation != nullptr) {
    add("starts_within", answer.starts_within ? "true" : "false");
    add("trend", answer.trend == Trend::none ? "null" : quoted(name_of(answer.trend)));
    out.append(",\"separation\":").append(number_text(separation->distance, Numbers::decimals));
    out.append(",\"metric\":").append(quoted(name_of(separation->metric)));
  }
  out.append(more).append("}\n");
}

}  // namespace touchstone::io
