// The reader of query files. Any bytes are queries or an error that names a row, and the pieces do not matter; queries
// that were read can be written and read again. The first byte chooses the kind and the size of the pieces, and
// whether the first row of a file of curved queries is put before the text. Bytes that start as a binary query file or
// an .npy array are read as one.
// SPDX-License-Identifier: MIT
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <touchstone/error.hpp>

#include "io/queries/curved_rows.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/queries/query_parser.hpp"
#include "io/queries/query_writer.hpp"
#include "targets.hpp"

namespace touchstone::fuzzing {
namespace {

struct Record {
  io::FileQuery query;
  std::optional<bool> truth;
  std::uint64_t number, first_row, last_row;
};

struct ReadQueries {
  std::vector<Record> records;
  std::string error;
};

ReadQueries read(std::string_view text, Kind kind, std::size_t chunk_bytes) {
  ReadQueries outcome;
  try {
    io::QueryChunkReader reader(io::InputFile::from_memory("fuzz.csv", text), kind, chunk_bytes, io::Motions::any);
    while (auto chunk = reader.next()) {
      io::QueryParser parser(*chunk);
      io::QueryRecord record;
      while (parser.next(record)) {
        outcome.records.push_back({record.query, record.truth, record.number, record.first_row, record.last_row});
        if (!chunk->curved()) io::query_as_given(record);
      }
    }
  } catch (const FileError& error) {
    outcome.error = error.what();
  }
  return outcome;
}

/// The values. Minus zero counts as zero, because a fraction has no minus zero.
bool same(const Query& one, const Query& other) {
  const auto equal = [](const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  if (one.kind != other.kind) return false;
  for (std::size_t i = 0; i < corner_count(one.kind); ++i) {
    if (!equal(one.start[i], other.start[i]) || !equal(one.end[i], other.end[i])) return false;
  }
  return true;
}

bool same(const RationalQuery& one, const RationalQuery& other) {
  const auto equal = [](const Fraction& a, const Fraction& b) {
    return a.numerator == b.numerator && a.denominator == b.denominator;
  };
  if (one.kind != other.kind) return false;
  for (std::size_t i = 0; i < corner_count(one.kind); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!equal(one.start[i][k], other.start[i][k]) || !equal(one.end[i][k], other.end[i][k])) return false;
    }
  }
  return true;
}

/// The bits of all that a reader sets. Motions that no corner names are zero.
bool same(const CurvedQuery& one, const CurvedQuery& other) {
  const auto equal = [](const auto& a, const auto& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  for (std::size_t i = 0; i < corner_count(one.kind); ++i) {
    const CurvedCorner &a = one.corners[i], &b = other.corners[i];
    if (a.motion != b.motion || a.control_points != b.control_points || !equal(a.points, b.points)) return false;
  }
  return one.kind == other.kind && equal(one.motions, other.motions);
}

bool same(const io::FileQuery& one, const io::FileQuery& other) {
  if (one.index() != other.index()) return false;
  if (one.index() == 2) return same(std::get<CurvedQuery>(one), std::get<CurvedQuery>(other));
  if (one.index() == 0) return same(std::get<Query>(one), std::get<Query>(other));
  return same(std::get<RationalQuery>(one), std::get<RationalQuery>(other));
}

bool same(const ReadQueries& one, const ReadQueries& other) {
  if (one.error != other.error || one.records.size() != other.records.size()) return false;
  for (std::size_t i = 0; i < one.records.size(); ++i) {
    const Record &a = one.records[i], &b = other.records[i];
    if (!same(a.query, b.query) || a.truth != b.truth || a.number != b.number || a.first_row != b.first_row ||
        a.last_row != b.last_row) {
      return false;
    }
  }
  return true;
}

}  // namespace

void fuzz_query_file(Bytes input) {
  if (input.empty()) return;
  const auto kind = static_cast<Kind>(input[0] & 3);
  const std::size_t piece = std::size_t{1} << (input[0] >> 2 & 7);
  std::string text((input[0] & 32) != 0 ? std::string(io::kCurvedHeader) + "\n" : std::string());
  text += as_text(input.subspan(1));
  const ReadQueries whole = read(text, kind, io::kChunkBytes);
  if (!same(whole, read(text, kind, piece))) {
    throw Finding("read in pieces of " + std::to_string(piece) +
                  " bytes it is another file; as a whole: " + whole.error);
  }
  if (!whole.error.empty() && whole.error.rfind("fuzz.csv:", 0) != 0) {
    throw Finding("the error does not name the file: " + whole.error);
  }
  if (whole.error.find('\n') != std::string::npos) throw Finding("the error is not one line: " + whole.error);
  if (whole.records.empty()) return;

  std::string written;
  if (std::holds_alternative<CurvedQuery>(whole.records.front().query)) written = std::string(io::kCurvedHeader) + "\n";
  for (const Record& record : whole.records) {
    std::visit([&](const auto& query) { io::append_query(written, query, record.truth.value_or(false)); },
               record.query);
  }
  const ReadQueries again = read(written, kind, io::kChunkBytes);
  bool kept = again.error.empty() && again.records.size() == whole.records.size();
  for (std::size_t i = 0; kept && i < whole.records.size(); ++i) {
    kept = same(whole.records[i].query, again.records[i].query) &&
           whole.records[i].truth.value_or(false) == again.records[i].truth;
  }
  if (!kept) throw Finding("what was read is not what is read after writing it: " + again.error);
}

}  // namespace touchstone::fuzzing
