// SPDX-License-Identifier: MIT
#include "io/queries/answer_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "io/fail.hpp"
#include "io/queries/answer_writer.hpp"
#include "io/queries/separation_text.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::io {
namespace {

constexpr std::size_t kAbsent = std::string::npos;

/// The columns of answers.csv; those that make a claim come first, in the order of AnswerReader::Column.
constexpr std::array<std::string_view, 13> kColumnNames = {
    "file",   "query",     "contact",   "toi",   "separation",    "metric", "toi_upper",
    "nature", "feature_a", "feature_b", "level", "starts_within", "trend"};

std::string count(std::size_t number, std::string_view thing) {
  return std::to_string(number) + " " + std::string(thing) + (number == 1 ? "" : "s");
}

}  // namespace

AnswerReader::AnswerReader(InputFile file, std::size_t chunk_bytes)
    : file_(std::move(file)), chunk_bytes_(std::max<std::size_t>(chunk_bytes, 1)) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  while (!at_end_ && buffer_.size() < kByteOrderMark.size()) fill();
  if (buffer_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  read_header();
}

bool AnswerReader::next(AnswerRow& row) {
  if (!next_record()) return false;
  if (fields_.size() != column_count_) {
    refuse(count(fields_.size(), "column") + "; the header has " + std::to_string(column_count_));
  }
  row.row = record_row_;
  row.file = std::nullopt;
  if (index_[kFile] != kAbsent) {
    row.file = fields_[index_[kFile]];
    if (row.file->starts_with('\'') && begins_formula(*row.file)) row.file->remove_prefix(1);  // the one of csv_field
  }

  const std::string_view query = fields_[index_[kQuery]];
  const auto [end, error] = std::from_chars(query.data(), query.data() + query.size(), row.query);
  if (error != std::errc{} || end != query.data() + query.size()) {
    refuse("query is " + in_quotes(query) + "; it must be a number counted from 0");
  }
  const std::string_view contact = fields_[index_[kContact]];
  if (contact != "0" && contact != "1") refuse("contact is " + in_quotes(contact) + "; it must be 0 or 1");
  row.contact = contact == "1";

  row.toi = std::nullopt;
  row.toi_as_written = {};
  if (index_[kToi] != kAbsent && !fields_[index_[kToi]].empty()) read_toi(fields_[index_[kToi]], row);
  row.separation = std::nullopt;
  if (index_[kSeparation] != kAbsent) read_separation(row);
  return true;
}

void AnswerReader::read_toi(std::string_view field, AnswerRow& row) const {
  row.toi = parse_rounded_double(field);
  if (!row.toi) {
    refuse("toi is " + in_quotes(field) + "; it must be a finite number such as 0x1.8p-2 or 0.375, or empty");
  }
  if (std::isinf(*row.toi)) refuse("toi is " + in_quotes(field) + "; it " + std::string(fault_of_double(field)));
  if (!row.contact) refuse("contact is 0 and toi is " + in_quotes(field) + "; without contact toi must be empty");
  if (is_plainly_a_double(field)) return;
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

void AnswerReader::read_separation(AnswerRow& row) const {
  const std::string_view distance = fields_[index_[kSeparation]];
  const auto value = parse_finite_double(distance);
  if (!value || *value < 0) {
    refuse("separation is " + in_quotes(distance) +
           "; it must be a finite number such as 0x1p-3 or 0.125, 0 or greater");
  }
  row.separation = Separation{*value, Metric::euclidean};
  if (index_[kMetric] == kAbsent) return;
  const std::string_view name = fields_[index_[kMetric]];
  const auto metric = from_name<Metric>(name);
  if (!metric) refuse("metric is " + in_quotes(name) + "; it must be euclidean or max");
  row.separation->metric = *metric;
}

void AnswerReader::read_header() {
  if (!next_record()) fail(name(), "is empty; its first line must name the columns, for example query,contact,toi");
  column_count_ = fields_.size();
  index_.fill(kAbsent);
  std::array<bool, kColumnNames.size()> seen{};
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const auto known = std::find(kColumnNames.begin(), kColumnNames.end(), fields_[i]);
    if (known == kColumnNames.end()) {
      refuse("unknown column " + in_quotes(fields_[i]) + "; the columns are query, contact and optionally file, toi, " +
             "toi_upper, nature, feature_a, feature_b, level, starts_within, trend, separation, metric");
    }
    const auto column = static_cast<std::size_t>(known - kColumnNames.begin());
    if (std::exchange(seen[column], true)) refuse("column " + in_quotes(fields_[i]) + " is there twice");
    if (column < kOther) index_[column] = i;
  }
  for (const Column needed : {kQuery, kContact}) {
    if (index_[needed] == kAbsent) refuse("column " + in_quotes(kColumnNames[needed]) + " is missing");
  }
  if (index_[kMetric] != kAbsent && index_[kSeparation] == kAbsent) refuse("column 'metric' needs column 'separation'");
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
  for (std::size_t at = 0;; ++at) {
    if (at < record.size() && record[at] == '"') {
      std::string& text = unquoted_.emplace_back();
      for (++at;; ++at) {  // find_record_end has seen the closing quote
        const std::size_t quote = record.find('"', at);
        text.append(record.substr(at, quote - at));
        at = quote + 1;
        if (at == record.size() || record[at] != '"') break;
        text += '"';
      }
      fields_.push_back(text);
      if (at < record.size() && record[at] != ',') refuse("text after a closing quote");
    } else {
      const std::size_t comma = std::min(record.find(',', at), record.size());
      const std::string_view text = record.substr(at, comma - at);
      if (text.find('"') != std::string_view::npos) refuse("a quote inside a field that does not start with one");
      fields_.push_back(text);
      at = comma;
    }
    if (at == record.size()) return;
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
