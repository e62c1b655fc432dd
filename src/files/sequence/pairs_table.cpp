// SPDX-License-Identifier: MIT
#include "sequence/pairs_table.hpp"

#include <fmt/format.h>

#include "sequence/report_json.hpp"

namespace touchstone::sequence {
namespace {

std::string element_columns(const NamedElement& element) {
  std::string vertices;
  for (std::size_t i = 0; i < element.corner_count(); ++i) {
    vertices += fmt::format("{}{}", i == 0 ? "" : " ", element.vertices[i]);
  }
  const std::string number = element.element == MeshElement::face ? std::to_string(element.face) : std::string();
  return fmt::format("{},{},{},{}", name_of(element.element), vertices, number, io::csv_field(element.part));
}

std::string pair_row(const std::string& start, const PairContact& pair, double toi, double toi_upper,
                     std::string_view contact, io::Numbers form) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", start, contact, name_of(pair.kind),
                     element_columns(pair.first), element_columns(pair.second), io::number_text(toi, form),
                     io::number_text(toi_upper, form), name_of(pair.nature), name_of(pair.feature_a),
                     name_of(pair.feature_b), name_of(pair.trend));
}

}  // namespace

std::string pair_rows(const Result& result, std::string_view from, std::string_view to, io::Numbers form) {
  const std::string start = io::csv_field(from) + "," + io::csv_field(to);
  std::string rows;
  for (const auto& pair : result.first) rows += pair_row(start, pair, result.toi, result.toi_upper, "first", form);
  for (const auto& pair : result.at_start) rows += pair_row(start, pair, 0, 0, "at_start", form);
  const std::string at_end = io::csv_field(result.step ? to : from) + ",";
  for (const auto& contact : result.intersections) {
    rows += fmt::format("{},{},,{},{},,,,,,\n", at_end, name_of(contact.sort), element_columns(contact.first),
                        element_columns(contact.second));
  }
  return rows;
}

std::string pairs_table(const Report& report, io::Numbers form) {
  std::string text(kPairsHeader);
  const std::size_t first = range_of(report.heading).first;
  for (const Result& result : report.results) {
    const std::string& from = report.frames[result.frame - first].label;
    text += pair_rows(result, from, result.step ? report.frames[result.frame - first + 1].label : std::string(), form);
  }
  return text;
}

}  // namespace touchstone::sequence
