// Reads a whole query file at once, and keeps the message of a refusal.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/query.hpp>

#include "io/queries/query_parser.hpp"

namespace touchstone::tests {

struct ReadQuery {
  io::FileQuery query;
  std::optional<bool> truth;
  std::uint64_t number;
  std::uint64_t first_row;
  std::uint64_t last_row;
  std::string text;
};

struct ReadFile {
  std::vector<ReadQuery> queries;  ///< those before the error
  std::string error;               ///< empty: none
};

inline ReadFile read_queries(std::string_view content, Kind kind, std::size_t chunk_bytes,
                             io::Motions motions = io::Motions::straight, io::Decimals decimals = io::Decimals::exact) {
  ReadFile result;
  try {
    io::QueryChunkReader reader(io::InputFile::from_memory("q.csv", content), kind, chunk_bytes, motions, decimals);
    while (const auto chunk = reader.next()) {
      io::QueryParser parser(*chunk);
      io::QueryRecord record;
      while (parser.next(record)) {
        result.queries.push_back(
            {record.query, record.truth, record.number, record.first_row, record.last_row, std::string(record.text)});
      }
    }
  } catch (const FileError& error) {
    result.error = error.what();
  }
  return result;
}

inline bool same(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Equal values; 0 and -0 are one number.
inline bool same(const Query& a, const Query& b) {
  bool equal = a.kind == b.kind;
  for (std::size_t i = 0; i < corner_count(a.kind); ++i) {
    equal = equal && same(a.start[i], b.start[i]) && same(a.end[i], b.end[i]);
  }
  return equal;
}

inline bool same(const RationalQuery& a, const RationalQuery& b) {
  bool equal = a.kind == b.kind;
  for (std::size_t i = 0; i < corner_count(a.kind); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const auto& [x, y] :
           {std::pair{&a.start[i][axis], &b.start[i][axis]}, std::pair{&a.end[i][axis], &b.end[i][axis]}}) {
        equal = equal && x->numerator == y->numerator && x->denominator == y->denominator;
      }
    }
  }
  return equal;
}

}  // namespace touchstone::tests
