// The rows of a file of curved queries. docs/program.md defines the format.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/curved_query.hpp>

namespace touchstone::io {

/// The first row of a file of curved queries.
inline constexpr std::string_view kCurvedHeader = "touchstone-curved,1";

/// Whether `row`, the first of a file, says that its queries are curved, in this version of the format or another one.
bool announces_curved_queries(std::string_view row) noexcept;

/// Why such a row is not kCurvedHeader, or an empty text.
std::string fault_of_curved_header(std::string_view row);

/// Whether the first row of `text` says that the queries of this file are curved.
bool holds_curved_queries(std::string_view text) noexcept;

/// Whether this row starts a query: its first column is "query".
bool starts_curved_query(std::string_view row) noexcept;

/// Which of the two turns between its orientations a body takes where the file says the longer one, q0 . q1 < 0: q1 and
/// -q1 are the same orientation.
enum class Turns : std::uint8_t { as_given, shorter };

/// The motions of a file that say the longer turn.
struct LongerTurns {
  std::uint64_t count = 0;
  std::uint64_t first_row = 0;  ///< the line of the first one

  /// @param later  those of a later part of the file
  void merge(const LongerTurns& later) noexcept {
    if (count == 0) first_row = later.first_row;
    count += later.count;
  }
};

/// One query, row by row.
class CurvedRows {
 public:
  explicit CurvedRows(Kind kind, Turns turns = Turns::as_given) : turns_(turns) { query_.kind = kind; }

  /// Takes in the row in line `line` of the file. @returns why it is refused, or an empty text
  std::string add(std::string_view row, std::uint64_t line);

  /// To be called after the last row. @returns why the query is refused, or an empty text
  std::string finish();

  /// The line at fault when finish() refuses the query.
  std::uint64_t fault_line() const noexcept { return fault_line_; }

  const CurvedQuery& query() const noexcept { return query_; }
  bool truth() const noexcept { return truth_; }
  const LongerTurns& longer_turns() const noexcept { return longer_turns_; }

 private:
  struct Columns;
  std::string add_query(const Columns& columns);
  std::string add_motion(const Columns& columns, std::uint64_t line);
  std::string add_body_point(const Columns& columns);
  std::string add_curve(const Columns& columns);
  std::string check_room() const;

  Turns turns_;
  LongerTurns longer_turns_;
  CurvedQuery query_;
  bool truth_ = false;
  std::size_t corners_ = 0;
  std::array<std::uint64_t, 4> motion_line_{};  ///< 0: the query has no such motion
  std::array<bool, 4> used_{};
  std::uint64_t last_line_ = 0;
  std::uint64_t fault_line_ = 0;
};

/// Appends the rows of one curved query. Its numbers must be valid. A motion that no corner names is left out.
void append_query(std::string& out, const CurvedQuery& query, bool truth);

}  // namespace touchstone::io
