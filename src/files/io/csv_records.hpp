// The records of a CSV file, one after the other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.hpp"
#include "io/queries/query_chunks.hpp"

namespace touchstone::io {

/// Reads RFC 4180 CSV, with blanks around the fields, and with other separators: the first record tells which
/// (separator_of). Records are bounded by kLongestLine, lines may end in CRLF, and blank lines are skipped. So are
/// comments before the first record: lines that start with '#'.
class CsvRecords {
 public:
  /// @param is_one_field  tells that a first record is one field, though it has blanks in it; may be null
  explicit CsvRecords(InputFile file, std::size_t chunk_bytes = kChunkBytes,
                      bool (*is_one_field)(std::string_view record) = nullptr);

  /// Goes on to the next record that is not blank. @returns false at the end of the file
  /// @throws FileError  naming the row at fault
  bool next();

  /// The last of the comments, without '#' and blanks around it.
  const std::string& comment() const noexcept { return comment_; }

  /// Those of the record. Valid until the next one.
  const std::vector<std::string_view>& fields() const noexcept { return fields_; }

  /// The line where the record starts, counted from 1.
  std::uint64_t row() const noexcept { return row_; }

  const std::string& name() const noexcept { return file_.name(); }

  /// @throws FileError  naming the row of the record
  [[noreturn]] void refuse(std::string_view reason) const;

 private:
  bool is_comment() const;
  bool find_record_end(std::size_t& end);
  void split_record(std::string_view record);
  void fill();

  InputFile file_;
  std::size_t chunk_bytes_;
  bool (*is_one_field_)(std::string_view record);
  std::optional<char> separator_;  ///< of the first record
  std::string comment_;
  bool at_end_ = false;
  std::string buffer_;
  std::size_t at_ = 0;      ///< where the next record starts in buffer_
  std::uint64_t line_ = 1;  ///< the line number of at_
  std::uint64_t row_ = 0;

  std::vector<std::string> unquoted_;  ///< what quoted fields of the record stand for
  std::vector<std::string_view> fields_;
};

}  // namespace touchstone::io
