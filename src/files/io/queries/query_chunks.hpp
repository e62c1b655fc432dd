// A query file cut into pieces that can be parsed on any thread. Memory does not grow with the file.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <touchstone/query.hpp>

#include "io/input_file.hpp"
#include "io/queries/decimal_rows.hpp"
#include "io/queries/query_array.hpp"

namespace touchstone::io {

inline constexpr std::size_t kChunkBytes = std::size_t{1} << 18;
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;
inline constexpr std::size_t kLongestQuery = std::size_t{1} << 24;  ///< rows and the comments between them

/// Eight for edge-edge and vertex-face, six for point-edge, four for point-point.
constexpr std::size_t rows_per_query(Kind kind) noexcept { return 2 * corner_count(kind); }

/// Whether a line holds a row; the others are blank, or comments that start with '#'. The line comes without '\n'.
inline bool is_row(std::string_view line) noexcept {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos || line[first] == '#') return false;
  return line[first] != '\r' || first + 1 != line.size();
}

/// Which query files are read: those of straight motion alone, or those of curved motion too. The first row of a file
/// tells which it is.
enum class Motions : std::uint8_t { straight, any };

/// Whole queries of one file: as text, or, of a file of doubles, as a range of the array that the file is.
struct QueryChunk {
  std::shared_ptr<const std::string> file;  ///< its name, for messages
  Kind kind = Kind::edge_edge;
  std::uint64_t first_query = 0;  ///< number of the first query, counted from 0 within the file
  std::uint64_t first_row = 1;    ///< of text: line number of the first line, counted from 1
  std::size_t query_count = 0;
  bool truncated = false;        ///< the file ends in the middle of a query, whose rows follow the whole ones
  std::uint64_t header_row = 0;  ///< in a file of curved queries the line of its first row, which is no query's; else 0
  std::uint64_t names_row = 0;   ///< the line that names the columns, which is no query's; else 0
  RowFormat format = RowFormat::fractions;
  bool has_truth = false;  ///< of decimals: whether the first row has one
  bool rewritten =
      false;  ///< the text has commas where the file has other separators, and no quotes or byte order mark
  Decimals decimals = Decimals::exact;

  std::shared_ptr<const QueryArray> array;  ///< of a file of doubles; then there is no text
  std::uint64_t array_start = 0;            ///< the number of the array's first query

  bool curved() const noexcept { return header_row != 0; }

  /// The number of bytes that these queries take in the file.
  std::uint64_t size() const noexcept {
    return array != nullptr ? query_count * array->bytes_per_query() : text().size();
  }

  std::string_view text() const noexcept { return std::string_view(bytes).substr(0, bytes.size() - kPadding); }

  /// The text and then kPadding zero bytes. So a parser may read that far ahead, and needs no other end mark.
  static constexpr std::size_t kPadding = 16;
  std::string bytes = std::string(kPadding, '\0');
};

class QueryChunkReader {
 public:
  /// @param chunk_bytes  the bytes of one read; any value gives the same queries and the same errors
  /// @param motions  with Motions::straight a file of curved queries is refused
  QueryChunkReader(InputFile file, Kind kind, std::size_t chunk_bytes = kChunkBytes,
                   Motions motions = Motions::straight, Decimals decimals = Decimals::exact);

  /// The next queries, or nothing at the end of the file.
  /// @throws FileError  for a file without a query, a line that is too long, the header of a file of doubles, or what
  ///                    the system cannot read; only after every whole query before it was handed out
  std::optional<QueryChunk> next();

 private:
  void fill();
  void start();
  std::optional<QueryChunk> next_of_array();
  void scan();
  bool too_long(std::size_t end);
  bool scan_line(std::size_t end);
  bool rewrite(std::size_t end);
  bool scan_first_row(std::string_view row);
  void complete_query();
  QueryChunk take(std::size_t size, std::size_t lines, std::size_t queries);
  void refuse(std::uint64_t row, std::string reason);

  InputFile file_;
  std::shared_ptr<const std::string> name_;
  Kind kind_;
  std::size_t chunk_bytes_;
  Motions motions_;
  Decimals decimals_;
  bool first_row_found_ = false;
  std::uint64_t header_row_ = 0, names_row_ = 0;  ///< as in the chunks
  RowFormat format_ = RowFormat::fractions;
  bool has_truth_ = false;
  bool rewritten_ = false;  ///< rows have other separators than commas, or quotes
  bool marked_ = false;     ///< the file began with a byte order mark
  char separator_ = ',';    ///< of the first row
  std::string names_;       ///< the line that names the columns, until the first row
  bool at_end_ = false;
  bool started_ = false;
  std::shared_ptr<const QueryArray> array_;

  std::string buffer_;  ///< starts at line first_row_
  std::uint64_t first_row_ = 1;
  std::uint64_t next_query_ = 0;

  std::size_t line_ = 0;       ///< the start in buffer_ of the first line that is not scanned yet
  std::size_t searched_ = 0;   ///< no line end in [line_, searched_)
  std::size_t lines_ = 0;      ///< lines scanned, all before line_
  std::size_t rows_ = 0;       ///< rows of the query that is not complete yet
  std::size_t queries_ = 0;    ///< complete queries in buffer_
  std::size_t cut_ = 0;        ///< the end of the last complete query and the comments after it
  std::size_t cut_lines_ = 0;  ///< lines before cut_

  std::string error_;  ///< thrown after the complete queries before it
  std::uint64_t error_row_ = 0;
};

}  // namespace touchstone::io
