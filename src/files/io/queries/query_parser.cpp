// SPDX-License-Identifier: MIT
#include "io/queries/query_parser.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "io/fail.hpp"
#include "io/queries/query_row.hpp"
#include "io/queries/query_writer.hpp"
#include "io/queries/separation_text.hpp"
#include "numbers/fraction.hpp"

namespace touchstone::io {
namespace {

/// The line at the front of `text`, without its '\n', which is dropped from `text` with it.
std::string_view pop_line(std::string_view& text) noexcept {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::optional<double> double_of(const Fraction& fraction) {
  return numbers::exact_double(fraction.numerator, fraction.denominator);
}

/// The first coordinate that is not finite.
std::string fault_of_numbers(const Query& query) {
  for (const bool at_end : {false, true}) {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      const Vec3& x = at_end ? query.end[i] : query.start[i];
      const std::array<double, 3> values = {x.x, x.y, x.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (std::isfinite(values[axis])) continue;
        return std::string(1, "xyz"[axis]) + " of " + std::string(corner_name(query.kind, i)) +
               " at t = " + (at_end ? "1" : "0") + " is " +
               (std::isnan(values[axis]) ? "no number (NaN)" : "infinite") + "; a coordinate must be a finite number";
      }
    }
  }
  return {};
}

std::string an(std::string_view kind) { return (kind.front() == 'e' ? "an " : "a ") + std::string(kind); }

}  // namespace

QueryParser::QueryParser(const QueryChunk& chunk, Turns turns)
    : chunk_(chunk),
      turns_(turns),
      at_(chunk.text().data()),
      end_(at_ + chunk.text().size()),
      row_(chunk.first_row),
      query_(chunk.first_query) {}

bool QueryParser::next(QueryRecord& record) {
  if (chunk_.array != nullptr) return next_of_array(record);
  if (chunk_.curved()) return next_curved(record);
  skip_names();
  if (at_ == end_) return false;
  if (chunk_.format != RowFormat::fractions) return next_of_decimals(record);
  const char* const start = at_;
  record.first_row = row_;
  record.number = query_++;
  if (!std::holds_alternative<Query>(record.query)) record.query.emplace<Query>();
  auto& query = std::get<Query>(record.query);
  query.kind = chunk_.kind;

  const std::size_t corners = corner_count(chunk_.kind);
  bool all_doubles = true;
  for (std::size_t row = 0; row < 2 * corners; ++row) {
    if (row > 0) skip_to_row();
    if (at_ == end_) refuse_truncated(row);
    Vec3& corner = row < corners ? query.start[row] : query.end[row - corners];
    DoubleRow usual;
    const char* const following = read_usual_row(at_, usual);
    if (following != nullptr && (following == end_ || following[-1] == '\n')) {  // not at a stray zero byte
      corner = usual.corner;
      check_truth(record, row, usual.truth);
      at_ = following;
    } else {
      const std::string_view line = line_at(at_);
      std::string reason;
      const auto fields = read_row(line, reason);
      const bool is_first_row = record.number == 0 && row == 0 && line.find('\0') == std::string_view::npos;
      if (!fields && is_first_row && !format_of_row(line, chunk_.kind)) reason = fault_of_columns(line, chunk_.kind);
      if (!fields) fail(*chunk_.file, row_, reason);
      check_truth(record, row, fields->truth);
      const auto x = double_of(fields->corner[0]);
      const auto y = double_of(fields->corner[1]);
      const auto z = double_of(fields->corner[2]);
      if (x && y && z) {
        corner = {*x, *y, *z};
      } else {
        all_doubles = false;
      }
      at_ = line.end() == end_ ? end_ : line.end() + 1;
    }
    record.last_row = row_++;
  }
  record.text = {start, static_cast<std::size_t>(at_ - start)};
  if (!all_doubles) record.query = query_as_given(chunk_.kind, record.text);
  return true;
}

/// Skips to the next row that is no line of names.
void QueryParser::skip_names() noexcept {
  skip_to_row();
  if (at_ == end_ || row_ != chunk_.names_row) return;
  skip_line(line_at(at_));
  skip_to_row();
}

bool QueryParser::next_of_decimals(QueryRecord& record) {
  record.first_row = row_;
  record.number = query_++;
  record.text = {};
  std::vector<Fraction> numbers;
  const std::size_t rows = rows_per_query(chunk_.kind, chunk_.format);
  for (std::size_t row = 0; row < rows; ++row) {
    if (row > 0) skip_to_row();
    if (at_ == end_) refuse_truncated(row);
    const std::string_view line = line_at(at_);
    std::optional<bool> truth;
    const std::string fault =
        read_decimals(line, chunk_.kind, chunk_.format, chunk_.has_truth, chunk_.decimals, numbers, truth);
    if (!fault.empty()) fail(*chunk_.file, row_, fault);
    check_truth(record, row, truth);
    record.last_row = row_;
    skip_line(line);
  }
  RationalQuery rational;
  rational.kind = chunk_.kind;
  Query query;
  query.kind = chunk_.kind;
  record.no_doubles = 0;
  const std::size_t corners = corner_count(chunk_.kind);
  for (std::size_t i = 0; i < 2 * corners; ++i) {
    std::array<double, 3> x{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto value = double_of(numbers[3 * i + axis]);
      if (!value) ++record.no_doubles;
      x[axis] = value.value_or(0);
    }
    const std::size_t corner = i % corners;
    (i < corners ? query.start : query.end)[corner] = {x[0], x[1], x[2]};
    auto& written = (i < corners ? rational.start : rational.end)[corner];
    std::move(numbers.begin() + static_cast<std::ptrdiff_t>(3 * i),
              numbers.begin() + static_cast<std::ptrdiff_t>(3 * i + 3), written.begin());
  }
  if (record.no_doubles == 0) {
    record.query = query;
  } else {
    record.query = std::move(rational);
  }
  return true;
}

bool QueryParser::next_curved(QueryRecord& record) {
  skip_to_row();
  if (row_ == chunk_.header_row && at_ != end_) {
    skip_line(line_at(at_));
    skip_to_row();
  }
  if (at_ == end_) return false;
  const char* const start = at_;
  record.first_row = row_;
  record.number = query_++;
  CurvedRows rows(chunk_.kind, turns_);
  for (; at_ != end_; skip_to_row()) {
    const std::string_view line = line_at(at_);
    if (row_ != record.first_row && starts_curved_query(line)) break;
    if (const std::string fault = rows.add(line, row_); !fault.empty()) fail(*chunk_.file, row_, fault);
    record.last_row = row_;
    skip_line(line);
    record.text = {start, static_cast<std::size_t>(at_ - start)};
  }
  if (const std::string fault = rows.finish(); !fault.empty()) fail(*chunk_.file, rows.fault_line(), fault);
  record.query = rows.query();
  record.truth = rows.truth();
  record.longer_turns = rows.longer_turns();
  return true;
}

bool QueryParser::next_of_array(QueryRecord& record) {
  const QueryArray& array = *chunk_.array;
  if (query_ == chunk_.first_query + chunk_.query_count) return false;
  if (!std::holds_alternative<Query>(record.query)) record.query.emplace<Query>();
  auto& query = std::get<Query>(record.query);
  query.kind = chunk_.kind;
  record.number = query_++;
  const std::uint64_t index = record.number - chunk_.array_start;
  array.read(index, query);
  const std::uint64_t rows = rows_per_query(chunk_.kind);
  record.first_row = record.number * rows + 1;
  record.last_row = record.first_row + rows - 1;
  record.text = {};
  for (std::size_t i = 0; i < corner_count(chunk_.kind); ++i) {
    const Vec3 &x0 = query.start[i], &x1 = query.end[i];
    // The difference of a number with itself is 0, unless it is infinite or no number.
    if ((x0.x - x0.x) + (x0.y - x0.y) + (x0.z - x0.z) + (x1.x - x1.x) + (x1.y - x1.y) + (x1.z - x1.z) == 0) continue;
    fail(*chunk_.file, "query " + std::to_string(record.number) + ": " + fault_of_numbers(query));
  }
  record.truth = array.claim(index);
  if (array.has_claims() && !record.truth) {
    fail(*chunk_.file, "query " + std::to_string(record.number) + ": the byte of its claim is neither 0 nor 1");
  }
  return true;
}

std::string_view QueryParser::line_at(const char* start) const noexcept {
  const auto* const end = static_cast<const char*>(std::memchr(start, '\n', static_cast<std::size_t>(end_ - start)));
  return {start, static_cast<std::size_t>((end == nullptr ? end_ : end) - start)};
}

void QueryParser::skip_to_row() noexcept {
  // A digit or '-' starts nearly every line, and needs no search for the line's end.
  while (at_ != end_ && !(*at_ == '-' || (*at_ >= '0' && *at_ <= '9'))) {
    const std::string_view line = line_at(at_);
    if (is_row(line)) return;
    skip_line(line);
  }
}

void QueryParser::skip_line(std::string_view line) noexcept {
  at_ = line.end() == end_ ? end_ : line.end() + 1;
  ++row_;
}

/// The truth of row `row` of a query, counted from 0, must be that of its first.
void QueryParser::check_truth(QueryRecord& record, std::size_t row, std::optional<bool> truth) const {
  if (row == 0) record.truth = truth;
  if (record.truth == truth) return;
  const auto text = [](std::optional<bool> column) { return !column ? "missing" : *column ? "1" : "0"; };
  fail(*chunk_.file, row_,
       std::string("truth is ") + text(truth) + " here and " + text(record.truth) + " in row " +
           std::to_string(record.first_row) + ", where the same query " + std::to_string(record.number) +
           " starts; all " + std::to_string(rows_per_query(chunk_.kind, chunk_.format)) + " rows of " +
           an(name_of(chunk_.kind)) + " query must agree");
}

void QueryParser::refuse_truncated(std::size_t rows) const {
  fail(*chunk_.file, row_ - 1,
       "the file ends within query " + std::to_string(query_ - 1) + ", which has " + std::to_string(rows) +
           (rows == 1 ? " row" : " rows") + "; " + an(name_of(chunk_.kind)) + " query has " +
           std::to_string(rows_per_query(chunk_.kind, chunk_.format)));
}

RationalQuery query_as_given(Kind kind, std::string_view text) {
  RationalQuery query;
  query.kind = kind;
  const std::size_t corners = corner_count(kind);
  for (std::size_t row = 0; row < 2 * corners && !text.empty();) {
    const std::string_view line = pop_line(text);
    if (!is_row(line)) continue;
    std::string ignored;  // the text was parsed before
    if (auto fields = read_row(line, ignored)) {
      (row < corners ? query.start[row] : query.end[row - corners]) = std::move(fields->corner);
    }
    ++row;
  }
  return query;
}

RationalQuery query_as_given(const QueryRecord& record) {
  if (const auto* const rational = std::get_if<RationalQuery>(&record.query)) return *rational;
  const Query& query = std::get<Query>(record.query);
  if (!record.text.empty()) return query_as_given(query.kind, record.text);
  RationalQuery given;
  given.kind = query.kind;
  const auto fractions = [](const Vec3& x) { return std::array{fraction_of(x.x), fraction_of(x.y), fraction_of(x.z)}; };
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    given.start[i] = fractions(query.start[i]);
    given.end[i] = fractions(query.end[i]);
  }
  return given;
}

std::optional<Separation> stated_separation(const QueryChunk& first_chunk) {
  return first_chunk.array != nullptr ? first_chunk.array->separation() : separation_of_comments(first_chunk.text());
}

}  // namespace touchstone::io
