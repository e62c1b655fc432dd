// SPDX-License-Identifier: MIT
#include "io/queries/query_chunks.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "io/fail.hpp"
#include "io/foreign_bytes.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/hdf5_layout.hpp"
#include "io/separators.hpp"

namespace touchstone::io {

QueryChunkReader::QueryChunkReader(InputFile file, Kind kind, std::size_t chunk_bytes, Motions motions,
                                   Decimals decimals)
    : file_(std::move(file)),
      name_(std::make_shared<const std::string>(file_.name())),
      kind_(kind),
      chunk_bytes_(std::max<std::size_t>(chunk_bytes, 1)),
      motions_(motions),
      decimals_(decimals) {}

std::optional<QueryChunk> QueryChunkReader::next() {
  if (!started_) start();
  if (array_ != nullptr) return next_of_array();
  for (;;) {
    if (!error_.empty()) fail(*name_, error_row_, error_);
    if (at_end_ && buffer_.empty()) {
      if (next_query_ > 0) return std::nullopt;
      fail(*name_, header_row_ != 0 ? "holds no query; a query starts with a row query,truth"
                                    : "holds no query; " + right_rows(kind_));
    }
    if (!at_end_) fill();
    scan();
    if (queries_ > 0) return take(cut_, cut_lines_, queries_);
    if (at_end_ && rows_ > 0 && error_.empty()) {
      QueryChunk chunk = take(buffer_.size(), lines_, 0);
      chunk.truncated = true;
      ++next_query_;
      return chunk;
    }
    if (cut_ > 0) take(cut_, cut_lines_, 0);  // nothing but comments: forget them
  }
}

void QueryChunkReader::fill() {
  const std::size_t old_size = buffer_.size();
  buffer_.reserve(old_size + chunk_bytes_ + QueryChunk::kPadding);
  buffer_.resize(old_size + chunk_bytes_);
  std::size_t size = old_size;
  while (size < buffer_.size()) {
    const std::size_t count = file_.read(buffer_.data() + size, buffer_.size() - size);
    if (count == 0) {
      at_end_ = true;
      break;
    }
    size += count;
  }
  buffer_.resize(size);
}

/// Tells a file of doubles from text, whose byte order mark is skipped.
void QueryChunkReader::start() {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  started_ = true;
  while (!at_end_ && buffer_.size() < std::max(kBinaryMagic.size(), kForeignStart)) fill();
  refuse_foreign_bytes(*name_, buffer_);
  if (starts_query_array(buffer_)) {
    array_ = std::make_shared<const QueryArray>(file_);
    if (const std::string fault = array_->fault_of_kind(kind_); !fault.empty()) fail(*name_, fault);
    buffer_ = std::string();
  } else if (buffer_.starts_with(kHdf5Magic)) {
    fail(*name_, "is an HDF5 file; touchstone convert makes a binary query file of it");
  } else if (buffer_.starts_with(kMark)) {
    buffer_.erase(0, kMark.size());
    marked_ = true;
  }
}

std::optional<QueryChunk> QueryChunkReader::next_of_array() {
  if (next_query_ == array_->count()) return std::nullopt;
  const std::uint64_t most = std::max<std::uint64_t>(chunk_bytes_ / array_->bytes_per_query(), 1);
  QueryChunk chunk;
  chunk.file = name_;
  chunk.kind = kind_;
  chunk.first_query = next_query_;
  chunk.query_count = static_cast<std::size_t>(std::min(most, array_->count() - next_query_));
  chunk.array = array_;
  next_query_ += chunk.query_count;
  return chunk;
}

/// Cuts buffer_ into lines as far as it goes, and counts rows and whole queries.
void QueryChunkReader::scan() {
  while (error_.empty()) {
    const char* const from = buffer_.data() + searched_;
    const void* const found = std::memchr(from, '\n', buffer_.size() - searched_);
    if (found == nullptr) break;
    if (!scan_line(static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.data()))) return;
  }
  searched_ = buffer_.size();
  if (!error_.empty() || too_long(searched_) || !at_end_) return;
  if (line_ < searched_ && !scan_line(searched_)) return;
  if (header_row_ != 0 && rows_ > 0) complete_query();
}

/// Of a file of curved queries: the next query starts at line_, or the file ends there.
void QueryChunkReader::complete_query() {
  ++queries_;
  rows_ = 0;
  cut_ = line_;
  cut_lines_ = lines_;
}

/// Finds out what the file's first row, which is the next line, says of the others. @returns false after an error
bool QueryChunkReader::scan_first_row(std::string_view row) {
  first_row_found_ = true;
  if (!announces_curved_queries(row)) {
    format_ = format_of_row(row, kind_).value_or(RowFormat::fractions);  // of another one the parser tells
    has_truth_ = format_ != RowFormat::fractions && has_truth(row, kind_, format_);
    if (names_row_ != 0 && format_of_row(row, kind_)) {
      if (std::string fault = fault_of_names(names_, row, kind_); !fault.empty()) refuse(names_row_, std::move(fault));
    }
    if (names_row_ == 0 && format_ == RowFormat::whole_query && counts_from_zero(row)) {
      refuse(
          first_row_ + lines_,
          "the first row counts from 0, as pandas names columns; write the file without names (header=False), or with "
          "such as x,y,z, before a query that is so");
    }
    return error_.empty();
  }
  if (names_row_ != 0) {
    refuse(names_row_, "a line of words stands before the row touchstone-curved,1, which must be the first");
    return false;
  }
  header_row_ = first_row_ + lines_;
  std::string fault = fault_of_curved_header(row);
  if (fault.empty() && motions_ == Motions::straight) {
    fault =
        "the queries of this file have curved motion, which is not read here; solve, certify, explain, judge, prove, "
        "fuzz, "
        "bench and report read it";
  }
  if (!fault.empty()) refuse(header_row_, std::move(fault));
  return error_.empty();
}

/// Refuses a line or a query that is too long, where the current line reaches to `end`. It reports the limit that comes
/// first in the file, so that the message does not depend on how much was read at a time.
bool QueryChunkReader::too_long(std::size_t end) {
  const std::size_t line_limit = line_ + kLongestLine;
  const std::size_t query_limit = rows_ > 0 ? cut_ + kLongestQuery : std::string::npos;
  if (end <= std::min(line_limit, query_limit)) return false;
  if (line_limit <= query_limit) {
    refuse(first_row_ + lines_, "the line is longer than " + std::to_string(kLongestLine) + " bytes");
  } else {
    refuse(first_row_ + cut_lines_,
           "this query and the comments in it are longer than " + std::to_string(kLongestQuery) + " bytes");
  }
  return true;
}

/// Makes the row [line_, end) one of commas without quotes, where the first row is none. The line that names the
/// columns may have other separators than the rows. @returns false after an error
bool QueryChunkReader::rewrite(std::size_t end) {
  const std::span<char> row(buffer_.data() + line_, end - line_);
  if (!first_row_found_) {
    const std::string_view text(row.data(), row.size());
    separator_ = separator_of(text);
    rewritten_ = separator_ != ',' || text.find('"') != std::string_view::npos;
  }
  if (!rewritten_) return true;
  if (std::string fault = put_commas(row, separator_); !fault.empty()) refuse(first_row_ + lines_, std::move(fault));
  return error_.empty();
}

/// Takes in the line [line_, end). @returns whether there may be more: not after an error
bool QueryChunkReader::scan_line(std::size_t end) {
  if (too_long(end)) return false;
  const std::string_view line(buffer_.data() + line_, end - line_);
  bool row = is_row(line);
  if (row && !rewrite(end)) return false;
  if (row && !first_row_found_ && names_row_ == 0 && names_columns(line) && !announces_curved_queries(line)) {
    names_row_ = first_row_ + lines_;
    names_ = line;
    row = false;
  } else if (row && !first_row_found_) {
    if (!scan_first_row(line)) return false;
    row = header_row_ == 0;
  } else if (row && header_row_ != 0) {
    if (end == buffer_.size()) {  // in the straight format a row that is cut off lacks its last column
      refuse(first_row_ + lines_,
             "the last row does not end with an end of line, so that the file may be cut off here");
      return false;
    }
    if (rows_ > 0 && starts_curved_query(line)) complete_query();
  }
  if (row && format_ != RowFormat::fractions && end == buffer_.size()) {  // half a decimal is a decimal
    refuse(first_row_ + lines_, "the last row does not end with an end of line, so that the file may be cut off here");
    return false;
  }
  if (!row && line.find('\0') != std::string_view::npos) {
    refuse(first_row_ + lines_, "a zero byte; this is no text file");
    return false;
  }
  line_ = searched_ = std::min(end + 1, buffer_.size());
  ++lines_;
  if (row && ++rows_ == rows_per_query(kind_, format_) && header_row_ == 0) {
    rows_ = 0;
    ++queries_;
  }
  if (rows_ == 0) {
    cut_ = line_;
    cut_lines_ = lines_;
  }
  return true;
}

/// Hands out the first `size` bytes of buffer_ and keeps the rest.
QueryChunk QueryChunkReader::take(std::size_t size, std::size_t lines, std::size_t queries) {
  QueryChunk chunk;
  chunk.file = name_;
  chunk.kind = kind_;
  chunk.first_query = next_query_;
  chunk.first_row = first_row_;
  chunk.query_count = queries;
  chunk.header_row = header_row_;
  chunk.names_row = names_row_;
  chunk.format = format_;
  chunk.has_truth = has_truth_;
  chunk.rewritten = rewritten_ || marked_;
  chunk.decimals = decimals_;

  std::string rest;
  rest.reserve(buffer_.size() - size + chunk_bytes_ + QueryChunk::kPadding);
  rest.assign(buffer_, size, std::string::npos);
  buffer_.resize(size);
  buffer_.append(QueryChunk::kPadding, '\0');
  chunk.bytes = std::exchange(buffer_, std::move(rest));

  first_row_ += lines;
  next_query_ += queries;
  line_ -= size;
  searched_ -= size;
  lines_ -= lines;
  queries_ = 0;
  cut_ = cut_lines_ = 0;
  if (buffer_.empty()) rows_ = 0;
  return chunk;
}

void QueryChunkReader::refuse(std::uint64_t row, std::string reason) {
  error_row_ = row;
  error_ = std::move(reason);
}

}  // namespace touchstone::io
