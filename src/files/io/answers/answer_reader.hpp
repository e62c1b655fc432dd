// Reads answers.csv, and tables like it, as the claims of a solver.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/separation.hpp>

#include "io/answers/claim_columns.hpp"
#include "io/csv_records.hpp"
#include "io/input_file.hpp"
#include "io/queries/query_chunks.hpp"

namespace touchstone::io {

/// One row of an answers file: the columns that make a claim.
struct AnswerRow {
  std::optional<std::string_view> file;  ///< nothing when the file has no such column; valid until the next row
  std::optional<std::uint64_t> query;    ///< nothing when the file has no such column: one row for each in their order
  bool contact = false;
  std::optional<double> toi;  ///< finite; only with contact
  /// The field's text, if its number may lie beside its nearest double `toi`; else empty. Its exact value has at most
  /// numbers::kMostWrittenDigits digits. Valid until the next row. Empty where a `toi_upper` in the row is that double
  /// or the next one: then decimals are spellings of doubles.
  std::string_view toi_as_written;
  std::optional<Separation> separation;  ///< what the claim is about; nothing when the file has no such column
  std::uint64_t row = 0;                 ///< the line where it starts, counted from 1
};

/// Reads CsvRecords. The first line names the columns, in any order, by the names that claim_columns.hpp lists. A
/// comment before the first row may name them, too, as numpy.savetxt writes it. Only `contact` is needed, or else `toi`
/// (contact_of_toi), or else `query` in a list of contacts alone. `separation` and `metric` say what a row is about; a
/// separation without a metric is Euclidean. Other columns are not read. Without such a line, one column is `contact`,
/// and three are `query`, `contact` and `toi`. The toi of a row without contact is not read.
class AnswerReader {
 public:
  /// Reads the header, if there is one.
  /// @param columns  what each column is, in place of the header's names, as --columns says it; empty for these
  /// @param missing  with MissingClaim::no_contact a table with `query` and without `contact` has contacts alone
  /// @throws FileError
  explicit AnswerReader(InputFile file, const ClaimColumns& columns = {}, std::size_t chunk_bytes = kChunkBytes,
                        MissingClaim missing = MissingClaim::refused);

  /// The next row into `row`. @returns false at the end of the file. @throws FileError naming the row at fault
  bool next(AnswerRow& row);

  const std::string& name() const noexcept { return records_.name(); }

  bool has_query_column() const noexcept { return has(ClaimColumn::query); }
  bool has_contact_column() const noexcept { return has(ClaimColumn::contact); }

  /// The names of columns that are not read and that answers.csv has not either.
  const std::vector<std::string>& unread_columns() const noexcept { return unread_columns_; }

  /// The line where the last row started.
  std::uint64_t last_row() const noexcept { return last_row_; }

 private:
  static constexpr std::size_t kAbsent = std::string::npos;

  std::uint64_t number_of(std::string_view query) const;
  void require_in_order(std::string_view index);
  void read_toi(std::string_view field, AnswerRow& row) const;
  bool is_beside_upper(double toi) const;
  void read_separation(AnswerRow& row) const;
  bool next_record();
  void read_header(const ClaimColumns& columns);
  void read_names(const std::vector<std::string_view>& names);
  bool read_comment();
  void take(const ClaimColumns& columns);
  bool is_row_of_values() const;
  bool has(ClaimColumn column) const noexcept { return index_[static_cast<std::size_t>(column)] != kAbsent; }
  std::string_view field(ClaimColumn column) const { return fields()[index_[static_cast<std::size_t>(column)]]; }
  const std::vector<std::string_view>& fields() const noexcept { return records_.fields(); }

  CsvRecords records_;
  MissingClaim missing_;
  std::uint64_t last_row_ = 0;
  bool has_row_ = false;           ///< whether fields() are a row that next() has not told yet
  std::size_t unnamed_ = kAbsent;  ///< the first column without a name
  double first_index_ = 0;         ///< what it says of the first row
  std::uint64_t rows_ = 0;         ///< that next() has told
  std::size_t column_count_ = 0;
  std::array<std::size_t, kClaimColumns> index_{};  ///< position of each column that is read; kAbsent: not there
  std::vector<std::string> unread_columns_;
};

}  // namespace touchstone::io
