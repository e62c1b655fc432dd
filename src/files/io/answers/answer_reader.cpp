// SPDX-License-Identifier: MIT
#include "io/answers/answer_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "io/answers/answer_writer.hpp"
#include "io/characters.hpp"
#include "io/fail.hpp"
#include "io/queries/separation_text.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::io {
namespace {

std::string count(std::size_t number, std::string_view thing) {
  return std::to_string(number) + " " + std::string(thing) + (number == 1 ? "" : "s");
}

/// "is colliding" is one name.
bool is_one_name(std::string_view record) { return claim_column(record).has_value(); }

}  // namespace

AnswerReader::AnswerReader(InputFile file, const ClaimColumns& columns, std::size_t chunk_bytes, MissingClaim missing)
    : records_(std::move(file), chunk_bytes, is_one_name), missing_(missing) {
  read_header(columns);
}

bool AnswerReader::next(AnswerRow& row) {
  if (!std::exchange(has_row_, false) && !next_record()) return false;
  if (fields().size() != column_count_) {
    records_.refuse(count(fields().size(), "column") + " where the first line has " + std::to_string(column_count_));
  }
  row.row = records_.row();
  row.file = std::nullopt;
  if (has(ClaimColumn::file)) row.file = text_of_field(field(ClaimColumn::file));
  row.query = std::nullopt;
  if (has(ClaimColumn::query)) row.query = number_of(field(ClaimColumn::query));
  if (unnamed_ != kAbsent && !has(ClaimColumn::query)) require_in_order(fields()[unnamed_]);
  ++rows_;

  row.contact = true;
  if (has(ClaimColumn::contact)) {
    const std::string_view contact = field(ClaimColumn::contact);
    const std::optional<bool> truth = parse_truth(contact);
    if (!truth) records_.refuse("contact is " + in_quotes(contact) + "; " + std::string(kTruthIsRight));
    row.contact = *truth;
  } else if (has(ClaimColumn::toi)) {
    const std::string_view toi = field(ClaimColumn::toi);
    const std::optional<bool> contact = contact_of_toi(toi);
    if (!contact) records_.refuse("toi is " + in_quotes(toi) + "; " + std::string(kToiIsRight));
    row.contact = *contact;
  }

  row.toi = std::nullopt;
  row.toi_as_written = {};
  if (row.contact && has(ClaimColumn::toi) && !field(ClaimColumn::toi).empty()) read_toi(field(ClaimColumn::toi), row);
  row.separation = std::nullopt;
  if (has(ClaimColumn::separation)) read_separation(row);
  return true;
}

std::uint64_t AnswerReader::number_of(std::string_view query) const {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(query.data(), query.data() + query.size(), number);
  if (error == std::errc{} && end == query.data() + query.size()) return number;
  const double whole = parse_exact_double(query).value_or(-1);  // 1.0, as pandas and NumPy write it among doubles
  if (!(whole >= 0 && whole <= 0x1p53 && whole == std::floor(whole))) {
    records_.refuse("query is " + in_quotes(query) + "; it must be a number counted from 0");
  }
  return static_cast<std::uint64_t>(whole);
}

/// A column has no name, as where pandas and R write the index of a table, from 0 or from 1 on. Of rows that were
/// sorted or left out it is not their number, and nobody knows whether it numbers the queries.
void AnswerReader::require_in_order(std::string_view index) {
  const std::optional<double> number = parse_exact_double(index);
  if (rows_ == 0) first_index_ = number == 1 ? 1 : 0;
  if (number && *number != static_cast<double>(rows_) + first_index_) {
    records_.refuse("a column has no name, and is " + in_quotes(index) + " in row " + std::to_string(rows_) +
                    ", counted from 0: is it the number of the query? Then name it query; else delete it");
  }
}

void AnswerReader::read_toi(std::string_view field, AnswerRow& row) const {
  row.toi = parse_rounded_double(field);
  if (!row.toi) {
    records_.refuse("toi is " + in_quotes(field) +
                    "; of a contact it must be a finite number such as 0x1.8p-2 or 0.375, or empty");
  }
  if (std::isinf(*row.toi))
    records_.refuse("toi is " + in_quotes(field) + "; it " + std::string(fault_of_double(field)));
  if (is_plainly_a_double(field) || is_beside_upper(*row.toi)) return;
  // Long texts are refused before they are parsed. A large exponent makes a number long, too.
  constexpr std::size_t kMost = numbers::kMostWrittenDigits;
  if (field.size() > kMost) {
    records_.refuse("toi has " + std::to_string(field.size()) + " characters; at most " + std::to_string(kMost) +
                    " are read");
  }
  if (!numbers::exact_value(field)) {
    records_.refuse("toi is " + in_quotes(field) + "; as a fraction it has more than " + std::to_string(kMost) +
                    " digits");
  }
  row.toi_as_written = field;
}

/// Whether the row has a toi_upper that is this double, or the one after it.
bool AnswerReader::is_beside_upper(double toi) const {
  if (!has(ClaimColumn::toi_upper)) return false;
  const std::optional<double> upper = parse_finite_double(field(ClaimColumn::toi_upper));
  return upper && (*upper == toi || *upper == std::nextafter(toi, std::numeric_limits<double>::infinity()));
}

void AnswerReader::read_separation(AnswerRow& row) const {
  const std::string_view distance = field(ClaimColumn::separation);
  const auto value = parse_finite_double(distance);
  if (!value || *value < 0) {
    records_.refuse("separation is " + in_quotes(distance) +
                    "; it must be a finite number such as 0x1p-3 or 0.125, 0 or greater");
  }
  row.separation = Separation{*value, Metric::euclidean};
  if (!has(ClaimColumn::metric)) return;
  const std::string_view name = field(ClaimColumn::metric);
  const auto metric = from_name<Metric>(name);
  if (!metric) records_.refuse("metric is " + in_quotes(name) + "; it must be euclidean or max");
  row.separation->metric = *metric;
}

void AnswerReader::read_header(const ClaimColumns& columns) {
  if (!next_record()) fail(name(), "is empty; its first line may name the columns, for example query,contact,toi");
  column_count_ = fields().size();
  const bool is_row = is_row_of_values();
  if (!columns.empty()) {
    if (columns.size() != column_count_) records_.refuse(fault_of_column_count(column_count_, columns));
    take(columns);
    has_row_ = has(ClaimColumn::contact) ? parse_truth(field(ClaimColumn::contact)).has_value() : is_row;
  } else if (!is_row) {
    read_names(fields());
  } else if (has_row_ = true; !read_comment()) {
    if (column_count_ == 1) return take({ClaimColumn::contact});
    if (column_count_ == 3) return take({ClaimColumn::query, ClaimColumn::contact, ClaimColumn::toi});
    records_.refuse(
        "no names of columns; --columns says what they are, for example --columns contact,toi or query,contact");
  }
  if (!has(ClaimColumn::contact) && !has(ClaimColumn::toi)) {
    const std::string fault = fault_without_contact("column", has(ClaimColumn::query), missing_);
    if (!fault.empty()) records_.refuse(fault + (columns.empty() ? "; --columns says what the columns are" : ""));
  }
  if (has(ClaimColumn::metric) && !has(ClaimColumn::separation)) {
    records_.refuse("column 'metric' needs column 'separation'");
  }
}

void AnswerReader::read_names(const std::vector<std::string_view>& names) {
  ClaimColumns named;
  const auto is_unnamed = [](std::string_view text) {  // pandas reads such a column as "Unnamed: 0"
    return without_blanks(text).empty() || text == "\"\"" || in_lower_case(text).starts_with("unnamed");
  };
  const auto unnamed = std::find_if(names.begin(), names.end(), is_unnamed);
  unnamed_ = unnamed == names.end() ? kAbsent : static_cast<std::size_t>(unnamed - names.begin());
  for (const std::string_view text : names) {
    const auto column = claim_column(text);
    if (!column && !is_description(text)) unread_columns_.emplace_back(text);
    if (column && std::count(named.begin(), named.end(), *column) != 0) {
      records_.refuse("two columns are a " + in_quotes(claim_column_name(*column)) +
                      "; --columns says which one is read");
    }
    named.push_back(column.value_or(ClaimColumn::unread));
  }
  take(named);
}

/// Takes the names of the comment before the first row, if it has one for each column, and one of them is known.
bool AnswerReader::read_comment() {
  const std::string& text = records_.comment();
  if (text.empty() || text.find('"') != std::string::npos) return false;
  CsvRecords comment(InputFile::from_memory(name(), text), kChunkBytes, is_one_name);
  const auto is_known = [](std::string_view field) { return claim_column(field).has_value(); };
  const auto& names = comment.fields();
  if (!comment.next() || names.size() != column_count_) return false;
  if (std::none_of(names.begin(), names.end(), is_known)) return false;
  read_names(names);
  return true;
}

void AnswerReader::take(const ClaimColumns& columns) {
  index_.fill(kAbsent);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] != ClaimColumn::unread) index_[static_cast<std::size_t>(columns[i])] = i;
  }
}

/// Whether the first line is no header: each of its fields is a number, yes or no, or empty.
bool AnswerReader::is_row_of_values() const {
  return std::all_of(fields().begin(), fields().end(), [](std::string_view text) {
    if (text.empty() || parse_truth(text) || parse_rounded_double(text)) return true;
    std::string lower = in_lower_case(text);
    if (lower.starts_with('-') || lower.starts_with('+')) lower.erase(0, 1);
    return lower == "inf" || lower == "infinity" || lower == "nan";
  });
}

/// The next record that is not blank. @returns false at the end of the file
bool AnswerReader::next_record() {
  if (!records_.next()) return false;
  last_row_ = records_.row();
  return true;
}

}  // namespace touchstone::io
