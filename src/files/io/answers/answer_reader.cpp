// SPDX-License-Identifier: MIT
#include "io/answers/answer_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "io/answers/answer_writer.hpp"
#include "io/characters.hpp"
#include "io/fail.hpp"
#include "io/queries/separation_text.hpp"
#include "io/separators.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::io {
namespace {

std::string count(std::size_t number, std::string_view thing) {
  return std::to_string(number) + " " + std::string(thing) + (number == 1 ? "" : "s");
}

}  // namespace

AnswerReader::AnswerReader(InputFile file, const ClaimColumns& columns, std::size_t chunk_bytes)
    : file_(std::move(file)), chunk_bytes_(std::max<std::size_t>(chunk_bytes, 1)) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  while (!at_end_ && buffer_.size() < kByteOrderMark.size()) fill();
  if (buffer_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  read_header(columns);
}

bool AnswerReader::next(AnswerRow& row) {
  if (!std::exchange(has_row_, false) && !next_record()) return false;
  if (fields_.size() != column_count_) {
    refuse(count(fields_.size(), "column") + " where the first line has " + std::to_string(column_count_));
  }
  row.row = record_row_;
  row.file = std::nullopt;
  if (has(ClaimColumn::file)) {
    row.file = field(ClaimColumn::file);
    if (row.file->starts_with('\'') && begins_formula(*row.file)) row.file->remove_prefix(1);  // the one of csv_field
  }
  row.query = std::nullopt;
  if (has(ClaimColumn::query)) row.query = number_of(field(ClaimColumn::query));

  const std::string_view contact = field(ClaimColumn::contact);
  const std::optional<bool> truth = parse_truth(contact);
  if (!truth) refuse("contact is " + in_quotes(contact) + "; " + std::string(kTruthIsRight));
  row.contact = *truth;

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
  const double whole = parse_finite_double(query).value_or(-1);  // 1.0, as pandas and NumPy write it among doubles
  if (!(whole >= 0 && whole <= 0x1p53 && whole == std::floor(whole))) {
    refuse("query is " + in_quotes(query) + "; it must be a number counted from 0");
  }
  return static_cast<std::uint64_t>(whole);
}

void AnswerReader::read_toi(std::string_view field, AnswerRow& row) const {
  row.toi = parse_rounded_double(field);
  if (!row.toi) {
    refuse("toi is " + in_quotes(field) +
           "; of a contact it must be a finite number such as 0x1.8p-2 or 0.375, or empty");
  }
  if (std::isinf(*row.toi)) refuse("toi is " + in_quotes(field) + "; it " + std::string(fault_of_double(field)));
  if (is_plainly_a_double(field) || is_beside_upper(*row.toi)) return;
  // Long texts are refused before they are parsed. A large exponent makes a number long, too.
  constexpr std::size_t kMost = numbers::kMostWrittenDigits;
  if (field.size() > kMost) {
    refuse("toi has " + std::to_string(field.size()) + " characters; at most " + std::to_string(kMost) + " are read");
  }
  if (!numbers::exact_value(field)) {
    refuse("toi is " + in_quotes(field) + "; as a fraction it has more than " + std::to_string(kMost) + " digits");
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
    refuse("separation is " + in_quotes(distance) +
           "; it must be a finite number such as 0x1p-3 or 0.125, 0 or greater");
  }
  row.separation = Separation{*value, Metric::euclidean};
  if (!has(ClaimColumn::metric)) return;
  const std::string_view name = field(ClaimColumn::metric);
  const auto metric = from_name<Metric>(name);
  if (!metric) refuse("metric is " + in_quotes(name) + "; it must be euclidean or max");
  row.separation->metric = *metric;
}

void AnswerReader::read_header(const ClaimColumns& columns) {
  if (!next_record()) fail(name(), "is empty; its first line may name the columns, for example query,contact,toi");
  column_count_ = fields_.size();
  if (!columns.empty()) {
    if (columns.size() != fields_.size()) refuse(fault_of_column_count(fields_.size(), columns));
    take(columns);
    has_row_ = parse_truth(field(ClaimColumn::contact)).has_value();  // else the line names the columns
    return;
  }
  if (is_row_of_values()) {
    has_row_ = true;
    if (column_count_ == 1) return take({ClaimColumn::contact});
    if (column_count_ == 3) return take({ClaimColumn::query, ClaimColumn::contact, ClaimColumn::toi});
    refuse("no names of columns; --columns says what they are, for example --columns contact,toi or query,contact");
  }
  ClaimColumns named;
  for (const std::string_view text : fields_) {
    const auto column = claim_column(text);
    if (!column && !is_description(text)) unread_columns_.emplace_back(text);
    if (column && std::count(named.begin(), named.end(), *column) != 0) {
      refuse("two columns are a " + in_quotes(claim_column_name(*column)) + "; --columns says which one is read");
    }
    named.push_back(column.value_or(ClaimColumn::unread));
  }
  take(named);
  if (!has(ClaimColumn::contact)) {
    refuse("no column is a 'contact'; known names are " + claim_column_names() +
           "; --columns says what the columns of others are");
  }
  if (has(ClaimColumn::metric) && !has(ClaimColumn::separation)) {
    refuse("column 'metric' needs column 'separation'");
  }
}

void AnswerReader::take(const ClaimColumns& columns) {
  index_.fill(kAbsent);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] != ClaimColumn::unread) index_[static_cast<std::size_t>(columns[i])] = i;
  }
}

/// Whether the first line is no header: each of its fields is a number, yes or no, or empty.
bool AnswerReader::is_row_of_values() const {
  return std::all_of(fields_.begin(), fields_.end(), [](std::string_view text) {
    if (text.empty() || parse_truth(text) || parse_rounded_double(text)) return true;
    std::string lower = in_lower_case(text);
    if (lower.starts_with('-') || lower.starts_with('+')) lower.erase(0, 1);
    return lower == "inf" || lower == "infinity" || lower == "nan";
  });
}

/// Splits the next record that is not blank into fields_. @returns false at the end of the file
bool AnswerReader::next_record() {
  for (;;) {
    record_row_ = line_;
    std::size_t end = 0;
    while (!find_record_end(end)) fill();
    if (at_ == buffer_.size()) return false;
    std::string_view record(buffer_.data() + at_, end - at_);
    if (record.ends_with('\r')) record.remove_suffix(1);
    line_ += 1 + static_cast<std::uint64_t>(std::count(record.begin(), record.end(), '\n'));
    at_ = std::min(end + 1, buffer_.size());
    if (record.empty()) continue;
    if (record.find('\0') != std::string_view::npos) refuse("a zero byte; this is no text file");
    if (!separator_) separator_ = claim_column(record) ? ',' : separator_of(record);  // "is colliding" is one name
    split_record(record);
    last_row_ = record_row_;
    return true;
  }
}

/// Finds the line end that closes the record at at_: the first one outside quotes, or the end of the file.
/// @returns false when more of the file must be read first
bool AnswerReader::find_record_end(std::size_t& end) {
  bool quoted = false;
  std::size_t from = at_;
  for (;;) {
    const std::size_t line_end = buffer_.find('\n', from);
    end = std::min(line_end, buffer_.size());
    if (end - at_ > kLongestLine) {
      refuse("the row is longer than " + std::to_string(kLongestLine) + " bytes" +
             (quoted ? "; is a quote not closed?" : ""));
    }
    const auto first = buffer_.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = buffer_.begin() + static_cast<std::ptrdiff_t>(end);
    if (std::count(first, last, '"') % 2 != 0) quoted = !quoted;  // a doubled quote changes nothing
    if (line_end == std::string::npos) {
      if (!at_end_) return false;
      if (quoted) refuse("the file ends inside quotes");
      return true;
    }
    if (!quoted) return true;
    from = line_end + 1;
  }
}

void AnswerReader::split_record(std::string_view record) {
  fields_.clear();
  unquoted_.clear();
  unquoted_.reserve(static_cast<std::size_t>(std::count(record.begin(), record.end(), '"')));  // keeps views valid
  const std::string_view padding = padding_beside(*separator_);
  if (separator_ == ' ') record = without_blanks(record);
  for (std::size_t at = 0;; ++at) {
    const std::size_t begin = record.find_first_not_of(padding, at);
    if (begin != std::string_view::npos && record[begin] == '"') {
      at = begin;
      std::string& text = unquoted_.emplace_back();
      for (++at;; ++at) {  // find_record_end has seen the closing quote
        const std::size_t quote = record.find('"', at);
        text.append(record.substr(at, quote - at));
        at = quote + 1;
        if (at == record.size() || record[at] != '"') break;
        text += '"';
      }
      fields_.push_back(text);
      if (separator_ != ' ') at = std::min(record.find_first_not_of(padding, at), record.size());
      if (at < record.size() && record[at] != *separator_) refuse("text after a closing quote");
    } else {
      const std::size_t end = std::min(record.find(*separator_, at), record.size());
      const std::string_view text = without_blanks(record.substr(at, end - at));
      if (text.find('"') != std::string_view::npos) refuse("a quote inside a field that does not start with one");
      fields_.push_back(text);
      at = end;
    }
    if (at == record.size()) return;
    if (separator_ == ' ') at = record.find_first_not_of(' ', at) - 1;  // however many blanks
  }
}

void AnswerReader::fill() {
  buffer_.erase(0, at_);
  at_ = 0;
  const std::size_t old_size = buffer_.size();
  buffer_.resize(old_size + chunk_bytes_);
  const std::size_t count = file_.read(buffer_.data() + old_size, chunk_bytes_);
  if (count == 0) at_end_ = true;
  buffer_.resize(old_size + count);
}

void AnswerReader::refuse(std::string_view reason) const { fail(name(), record_row_, reason); }

}  // namespace touchstone::io
