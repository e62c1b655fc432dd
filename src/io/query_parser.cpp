// SPDX-License-Identifier: MIT
#include "io/query_parser.hpp"

#include <cstring>
#include <optional>
#include <string>

#include "io/curved_rows.hpp"
#include "io/fail.hpp"
#include "io/query_row.hpp"
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

std::string an(std::string_view kind) { return (kind.front() == 'e' ? "an " : "a ") + std::string(kind); }

}  // namespace

QueryParser::QueryParser(const QueryChunk& chunk)
    : chunk_(chunk),
      at_(chunk.text().data()),
      end_(at_ + chunk.text().size()),
      row_(chunk.first_row),
      query_(chunk.first_query) {}

bool QueryParser::next(QueryRecord& record) {
  if (chunk_.curved()) return next_curved(record);
  skip_to_row();
  if (at_ == end_) return false;
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
  CurvedRows rows(chunk_.kind);
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
void QueryParser::check_truth(QueryRecord& record, std::size_t row, bool truth) const {
  if (row == 0) record.truth = truth;
  if (record.truth == truth) return;
  fail(*chunk_.file, row_,
       std::string("truth is ") + (truth ? "1" : "0") + " here and " + (truth ? "0" : "1") + " in row " +
           std::to_string(record.first_row) + ", where the same query " + std::to_string(record.number) +
           " starts; all " + std::to_string(rows_per_query(chunk_.kind)) + " rows of " + an(kind_name(chunk_.kind)) +
           " query must agree");
}

void QueryParser::refuse_truncated(std::size_t rows) const {
  fail(*chunk_.file, row_ - 1,
       "the file ends within query " + std::to_string(query_ - 1) + ", which has " + std::to_string(rows) +
           (rows == 1 ? " row" : " rows") + "; " + an(kind_name(chunk_.kind)) + " query has " +
           std::to_string(rows_per_query(chunk_.kind)));
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

}  // namespace touchstone::io
