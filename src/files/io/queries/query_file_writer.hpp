// Writes query files in each of their formats. What a format does not hold is refused, so that no bit is lost.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "io/output_file.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::io {

enum class QueryFormat : std::uint8_t {
  csv,       ///< rows of fractions
  hexfloat,  ///< the rows of curved queries, with hexfloats
  binary,    ///< a header and columns of doubles
  npy,       ///< NumPy's array of doubles of shape (n, 2, corners, 3)
  hdf5       ///< rows of doubles and results, as the public benchmark packs them
};
inline constexpr std::array<QueryFormat, 5> kQueryFormats = {QueryFormat::csv, QueryFormat::hexfloat,
                                                             QueryFormat::binary, QueryFormat::npy, QueryFormat::hdf5};

/// "csv", "hexfloat", "binary", "npy", "hdf5"
std::string_view format_name(QueryFormat format) noexcept;

/// The format that the ending of the name says: .csv, .tsq, .npy, .h5 or .hdf5, in upper or lower case; else nothing.
std::optional<QueryFormat> format_of_name(std::string_view path);

/// What holds for all queries of a file that is written.
struct WrittenFile {
  QueryFormat format = QueryFormat::csv;
  Kind kind = Kind::edge_edge;
  bool with_claims = true;               ///< CSV and hexfloat always have claims, .npy never
  std::optional<Separation> separation;  ///< what the claims are about; nothing: it is not said
  bool signed_zeros = true;              ///< false: a -0, which a fraction of CSV cannot be, is written as 0 there
};

/// Why a file of this sort cannot be written, or an empty text.
std::string fault_of_written_file(const WrittenFile& file);

/// Some queries in the bytes of the format. Any thread may make them.
class EncodedQueries {
 public:
  explicit EncodedQueries(const WrittenFile& file);

  /// Appends one query with its claim. @param truth  must have a value when the file has claims
  /// @throws FileError  naming `source`, the row and the column of a coordinate that the format does not hold
  void add(const std::string& source, const QueryRecord& record, std::optional<bool> truth);

 private:
  friend class QueryFileWriter;
  void add_doubles(const Query& query);

  WrittenFile file_;
  std::uint64_t count_ = 0;
  /// One for text and for .npy; of the binary format one for each column and then the claims; of HDF5 the doubles, in the
  /// order of .npy, and the claims.
  std::vector<std::string> pieces_;
};

/// A file that appears when all of its queries are written.
class QueryFileWriter {
 public:
  /// @param path  "-": standard output. @throws FileError
  QueryFileWriter(const std::string& path, const WrittenFile& file);

  void write(const EncodedQueries& queries);  ///< @throws FileError
  void commit();                              ///< @throws FileError

 private:
  WrittenFile file_;
  OutputFile out_;
  std::uint64_t count_ = 0;
  std::deque<SpoolFile> spools_;  ///< of the formats whose header has the number of queries
};

}  // namespace touchstone::io
