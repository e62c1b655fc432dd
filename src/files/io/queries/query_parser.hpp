// The queries of one chunk of a query file.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "io/queries/curved_rows.hpp"
#include "io/queries/query_chunks.hpp"

namespace touchstone::io {

/// A query of a file: rational when some coordinate is not a double, curved in a file of curved queries.
using FileQuery = std::variant<Query, RationalQuery, CurvedQuery>;

/// One query of a file, with the claim of its truth column.
struct QueryRecord {
  FileQuery query;
  std::optional<bool> truth;    ///< the file's truth column; nothing in a file without claims
  std::uint64_t number = 0;     ///< counted from 0 within the file
  std::uint64_t first_row = 0;  ///< line number of its first row, counted from 1; a file of doubles counts as CSV rows
  std::uint64_t last_row = 0;
  std::string_view text;  ///< its rows as they are in the chunk, which must outlive it; empty without fractions in them
  LongerTurns longer_turns = {};  ///< of a curved query, as the file has it
  std::uint32_t no_doubles = 0;   ///< how many of its coordinates are decimals, taken as written, that are no doubles
};

class QueryParser {
 public:
  /// The chunk must outlive the parser.
  /// @param turns  of the bodies of curved queries
  explicit QueryParser(const QueryChunk& chunk, Turns turns = Turns::as_given);

  /// The next query into `record`. @returns false after the last one
  /// @throws FileError  naming the row of the query's first fault; no query can be read after that
  bool next(QueryRecord& record);

 private:
  std::string_view line_at(const char* start) const noexcept;
  void skip_line(std::string_view line) noexcept;
  void skip_to_row() noexcept;
  void skip_names() noexcept;
  bool next_curved(QueryRecord& record);
  bool next_of_decimals(QueryRecord& record);
  bool next_of_array(QueryRecord& record);
  void check_truth(QueryRecord& record, std::size_t row, std::optional<bool> truth) const;
  [[noreturn]] void refuse_truncated(std::size_t rows) const;

  const QueryChunk& chunk_;
  Turns turns_;
  const char* at_;  ///< the start of a line
  const char* end_;
  std::uint64_t row_;  ///< the line number of at_
  std::uint64_t query_;
};

/// All corners of a straight motion as the file gives them, for reports. @param text  QueryRecord::text
RationalQuery query_as_given(Kind kind, std::string_view text);

/// The same; the doubles of a file of doubles are fractions in lowest terms.
RationalQuery query_as_given(const QueryRecord& record);

/// What the truth column of a file is about, as its first chunk says; nothing when it does not say it.
std::optional<Separation> stated_separation(const QueryChunk& first_chunk);

}  // namespace touchstone::io
