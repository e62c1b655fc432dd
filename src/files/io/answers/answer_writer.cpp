// SPDX-License-Identifier: MIT
#include "io/answers/answer_writer.hpp"

#include "io/characters.hpp"
#include "io/times.hpp"

namespace touchstone::io {

bool begins_formula(std::string_view text) noexcept {
  constexpr std::string_view kMarks = "=+-@\t\r";
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string_view::npos && kMarks.find(text[first]) != std::string_view::npos;
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

namespace {

/// A row without its line end.
void append_columns(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer) {
  out.append(file_field).append(",").append(std::to_string(query));
  if (answer.contact) {
    out.append(",1,").append(hexfloat(answer.toi)).append(",").append(hexfloat(answer.toi_upper));
    out.append(",").append(name_of(answer.nature));
    out.append(",").append(name_of(answer.feature_a));
    out.append(",").append(name_of(answer.feature_b));
  } else {
    out.append(",0,,,,,");
  }
  out.append(",").append(name_of(answer.level));
}

}  // namespace

void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer) {
  append_columns(out, file_field, query, answer);
  out.append("\n");
}

void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer,
                   const Separation& separation) {
  append_columns(out, file_field, query, answer);
  out.append(!answer.contact ? "," : answer.starts_within ? ",1" : ",0");
  out.append(",").append(name_of(answer.trend));
  out.append(",").append(hexfloat(separation.distance)).append(",").append(name_of(separation.metric)).append("\n");
}

}  // namespace touchstone::io
