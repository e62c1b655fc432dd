// The reader of answers files. Any bytes are claims or an error that names a row, and the pieces do not matter.
// The first byte chooses the size of the pieces, and whether columns are told.
// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "io/answers/answer_reader.hpp"
#include "io/answers/npz.hpp"
#include "numbers/fraction.hpp"
#include "numbers/written_number.hpp"
#include "targets.hpp"

namespace touchstone::fuzzing {
namespace {

struct Row {
  std::optional<std::string> file;
  std::optional<std::uint64_t> query;
  bool contact;
  std::optional<std::uint64_t> toi;  ///< its bits
  std::uint64_t row;
  std::string toi_as_written;
  bool operator==(const Row&) const = default;
};

struct ReadAnswers {
  std::vector<Row> rows;
  std::string error;
  bool operator==(const ReadAnswers&) const = default;
};

/// The time as it is written has an exact value, and where that is a double, it is `toi`.
void check_written(const io::AnswerRow& row) {
  const auto value = numbers::exact_value(row.toi_as_written);
  if (!row.toi || !value) throw Finding("a time as written without a value: " + std::string(row.toi_as_written));
  const auto exact = numbers::exact_double(value->numerator, value->denominator);
  if (exact && *exact != *row.toi) throw Finding("another double than is written: " + std::string(row.toi_as_written));
}

ReadAnswers read(std::string_view text, const io::ClaimColumns& columns, std::size_t chunk_bytes) {
  ReadAnswers outcome;
  try {
    io::AnswerReader reader(io::InputFile::from_memory("fuzz.csv", text), columns, chunk_bytes);
    io::AnswerRow row;
    while (reader.next(row)) {
      Row kept{std::nullopt, row.query, row.contact, std::nullopt, row.row, std::string(row.toi_as_written)};
      if (row.file) kept.file = std::string(*row.file);
      if (row.toi) kept.toi = std::bit_cast<std::uint64_t>(*row.toi);
      if (row.toi && (!row.contact || !std::isfinite(*row.toi))) throw Finding("a toi without contact, or not finite");
      if (!row.toi_as_written.empty()) check_written(row);
      if (!outcome.rows.empty() && row.row <= outcome.rows.back().row) throw Finding("rows that do not ascend");
      outcome.rows.push_back(std::move(kept));
    }
  } catch (const FileError& error) {
    outcome.error = error.what();
  }
  return outcome;
}

/// An archive of arrays: each is where the archive says, and its header is read or refused.
void read_arrays(std::string_view archive) {
  try {
    for (const io::NpzArray& array : io::npz_arrays("fuzz.npz", archive)) {
      if (array.content.data() < archive.data() ||
          array.content.data() + array.content.size() > archive.data() + archive.size()) {
        throw Finding("an array that is not in the archive");
      }
      io::InputFile memory = io::InputFile::from_memory("fuzz.npy", array.content);
      const io::NpyHeader header = io::read_npy_header(memory, array.content.size(), "(1,)");
      if (header.values > 0) {
        io::number_at(array.content.data() + header.header_size + (header.values - 1) * header.size, header);
      }
    }
  } catch (const FileError&) {
  }
}

}  // namespace

void fuzz_answers_file(Bytes input) {
  if (input.empty()) return;
  const std::size_t piece = std::size_t{1} << (input[0] & 7);
  const std::string_view text = as_text(input.subspan(1));
  io::ClaimColumns columns;
  if ((input[0] & 8) != 0) columns = {io::ClaimColumn::contact, io::ClaimColumn::toi};
  if ((input[0] & 16) != 0) columns.push_back(io::ClaimColumn::unread);
  if ((input[0] & 24) == 16) columns.push_back(io::ClaimColumn::contact);
  read_arrays(text);
  const ReadAnswers whole = read(text, columns, io::kChunkBytes);
  if (whole != read(text, columns, piece)) {
    throw Finding("read in pieces of " + std::to_string(piece) +
                  " bytes it is another file; as a whole: " + whole.error);
  }
  if (!whole.error.empty() && whole.error.rfind("fuzz.csv", 0) != 0) {
    throw Finding("the error does not name the file: " + whole.error);
  }
  if (whole.error.find('\n') != std::string::npos) throw Finding("the error is not one line: " + whole.error);
}

}  // namespace touchstone::fuzzing
