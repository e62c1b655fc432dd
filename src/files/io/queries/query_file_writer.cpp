// SPDX-License-Identifier: MIT
#include "io/queries/query_file_writer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <variant>

#include "io/fail.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/hdf5_layout.hpp"
#include "io/queries/query_array.hpp"
#include "io/queries/query_writer.hpp"
#include "io/queries/separation_text.hpp"
#include "numbers/fraction.hpp"

namespace touchstone::io {
namespace {

using Corners = std::array<Vec3, 4>;

bool is_text(QueryFormat format) { return format == QueryFormat::csv || format == QueryFormat::hexfloat; }

/// The pieces of a file that follow each other in it: see EncodedQueries.
std::size_t piece_count(const WrittenFile& file) {
  switch (file.format) {
    case QueryFormat::binary: return 6 * corner_count(file.kind) + 1;
    case QueryFormat::hdf5: return 2;
    default: return 1;
  }
}

void append_double(std::string& out, double value) {
  auto bits = std::bit_cast<std::uint64_t>(value);
  if constexpr (std::endian::native != std::endian::little) bits = __builtin_bswap64(bits);
  std::array<char, sizeof bits> bytes;
  std::memcpy(bytes.data(), &bits, sizeof bits);
  out.append(bytes.data(), bytes.size());
}

/// The straight motion that a query on curves of at most two control points is.
std::optional<Query> straight_motion_of(const CurvedQuery& curved) {
  Query query;
  query.kind = curved.kind;
  for (std::size_t i = 0; i < corner_count(curved.kind); ++i) {
    const CurvedCorner& corner = curved.corners[i];
    if (corner.motion != CurvedCorner::kOnCurve || corner.control_points > 2) return std::nullopt;
    query.start[i] = corner.points[0];
    query.end[i] = corner.points[corner.control_points == 2 ? 1 : 0];
  }
  return query;
}

CurvedQuery on_curves(const Query& query) {
  CurvedQuery curved;
  curved.kind = query.kind;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    curved.corners[i].control_points = 2;
    curved.corners[i].points = {query.start[i], query.end[i]};
  }
  return curved;
}

/// Calls use(row, axis, coordinate) for all coordinates; rows are those of CSV, counted from 0.
template <class Use>
void for_each_coordinate(const Query& query, Use use) {
  const std::size_t corners = corner_count(query.kind);
  for (std::size_t row = 0; row < 2 * corners; ++row) {
    const Vec3& corner = row < corners ? query.start[row] : query.end[row - corners];
    use(row, 0, corner.x);
    use(row, 1, corner.y);
    use(row, 2, corner.z);
  }
}

bool is_minus_zero(double x) { return x == 0 && std::signbit(x); }

bool has_minus_zero(const Query& query) {
  bool found = false;
  for_each_coordinate(query, [&](std::size_t, std::size_t, double x) { found = found || is_minus_zero(x); });
  return found;
}

/// The line of row `row` of a straight query, counted from 0: comments may lie between its rows.
std::uint64_t line_of_row(const QueryRecord& record, std::size_t row) {
  if (record.text.empty() || std::holds_alternative<CurvedQuery>(record.query)) return record.first_row + row;
  std::string_view text = record.text;
  for (std::uint64_t line = record.first_row;; ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (is_row(text.substr(0, end)) && row-- == 0) return line;
    if (end == text.size()) return line;
    text.remove_prefix(end + 1);
  }
}

std::string location(const QueryRecord& record, Kind kind, std::size_t row, std::size_t axis) {
  const std::size_t corners = corner_count(kind);
  return std::string(1, "xyz"[axis]) + " of " + std::string(corner_name(kind, row % corners)) +
         " at t = " + (row < corners ? "0" : "1") + " in query " + std::to_string(record.number);
}

/// Refuses the first coordinate that is no double.
[[noreturn]] void refuse_rational(const std::string& source, const QueryRecord& record, QueryFormat format) {
  const auto& query = std::get<RationalQuery>(record.query);
  const std::size_t corners = corner_count(query.kind);
  for (std::size_t row = 0; row < 2 * corners; ++row) {
    const auto& corner = row < corners ? query.start[row] : query.end[row - corners];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Fraction& fraction = corner[axis];
      if (numbers::exact_double(fraction.numerator, fraction.denominator)) continue;
      const char name = "xyz"[axis];
      fail(source, line_of_row(record, row),
           std::string(1, name) + "_num," + name + "_den (" + location(record, query.kind, row, axis) + ") is " +
               shortened(fraction.numerator) + "/" + shortened(fraction.denominator) + ", which is no double; " +
               std::string(format_name(format)) + " holds doubles alone, and csv holds every fraction" +
               (record.no_doubles > 0 ? "; --as-doubles takes the nearest double of each decimal" : ""));
    }
  }
  fail(source, record.first_row, "the query has a coordinate that is no double");
}

[[noreturn]] void refuse_minus_zero(const std::string& source, const QueryRecord& record, const Query& query) {
  for_each_coordinate(query, [&](std::size_t row, std::size_t axis, double x) {
    if (!is_minus_zero(x)) return;
    fail(source, line_of_row(record, row),
         location(record, query.kind, row, axis) +
             " is -0, and a fraction has no sign of zero; the other formats hold it, or --unsigned-zeros writes 0");
  });
  fail(source, record.first_row, "the query has a coordinate -0");
}

}  // namespace

std::string_view format_name(QueryFormat format) noexcept {
  switch (format) {
    case QueryFormat::csv: return "csv";
    case QueryFormat::hexfloat: return "hexfloat";
    case QueryFormat::binary: return "binary";
    case QueryFormat::npy: return "npy";
    case QueryFormat::hdf5: return "hdf5";
  }
  return "";
}

std::optional<QueryFormat> format_of_name(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::string ending(path.substr(dot + 1));
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == "csv") return QueryFormat::csv;
  if (ending == "tsq") return QueryFormat::binary;
  if (ending == "npy") return QueryFormat::npy;
  if (ending == "h5" || ending == "hdf5") return QueryFormat::hdf5;
  return std::nullopt;
}

std::string fault_of_written_file(const WrittenFile& file) {
  const std::string name(format_name(file.format));
  if (file.format == QueryFormat::npy && file.with_claims) {
    return "npy has no room for claims; --claims drop leaves them out";
  }
  if (file.format == QueryFormat::hexfloat && !file.with_claims) {
    return name + " has a claim for each query; --claims solve computes them";
  }
  if (file.format == QueryFormat::hdf5 && file.separation) {
    return "hdf5 has no room for the separation that the claims are about; --claims drop leaves the claims out";
  }
  return {};
}

EncodedQueries::EncodedQueries(const WrittenFile& file) : file_(file) { pieces_.resize(piece_count(file)); }

void EncodedQueries::add_doubles(const Query& query) {
  std::size_t column = 0;
  const bool columns = file_.format == QueryFormat::binary;
  for_each_coordinate(query,
                      [&](std::size_t, std::size_t, double x) { append_double(pieces_[columns ? column++ : 0], x); });
}

void EncodedQueries::add(const std::string& source, const QueryRecord& record, std::optional<bool> truth) {
  const std::optional<bool> claim = file_.with_claims ? std::optional(truth.value()) : std::nullopt;
  ++count_;
  if (const auto* const rational = std::get_if<RationalQuery>(&record.query)) {
    if (file_.format != QueryFormat::csv) refuse_rational(source, record, file_.format);
    append_query(pieces_[0], *rational, claim);
    return;
  }
  const auto* const curved = std::get_if<CurvedQuery>(&record.query);
  if (curved != nullptr && file_.format == QueryFormat::hexfloat) {
    append_query(pieces_[0], *curved, claim.value());
    return;
  }
  const auto straight = curved != nullptr ? straight_motion_of(*curved) : std::optional(std::get<Query>(record.query));
  if (!straight) {
    fail(source, record.first_row,
         "query " + std::to_string(record.number) + " has curved motion; " + std::string(format_name(file_.format)) +
             " holds straight motion alone, and hexfloat holds both");
  }
  switch (file_.format) {
    case QueryFormat::csv:
      if (file_.signed_zeros && has_minus_zero(*straight)) refuse_minus_zero(source, record, *straight);
      append_query(pieces_[0], *straight, claim);
      return;
    case QueryFormat::hexfloat: append_query(pieces_[0], on_curves(*straight), claim.value()); return;
    case QueryFormat::binary:
    case QueryFormat::hdf5:
      add_doubles(*straight);
      if (claim) pieces_.back() += *claim ? '\1' : '\0';
      return;
    case QueryFormat::npy: add_doubles(*straight); return;
  }
}

QueryFileWriter::QueryFileWriter(const std::string& path, const WrittenFile& file)
    : file_(file), out_(path == "-" ? OutputFile::standard_output() : OutputFile(path)) {
  if (is_text(file.format)) {
    if (file.separation) out_.write(separation_comment(*file.separation));
    if (file.format == QueryFormat::hexfloat) out_.write(std::string(kCurvedHeader) + "\n");
    return;
  }
  for (std::size_t i = 0; i < piece_count(file); ++i) spools_.emplace_back(path);
}

void QueryFileWriter::write(const EncodedQueries& queries) {
  count_ += queries.count_;
  if (is_text(file_.format)) {
    out_.write(queries.pieces_[0]);
    return;
  }
  for (std::size_t i = 0; i < spools_.size(); ++i) spools_[i].write(queries.pieces_[i]);
}

void QueryFileWriter::commit() {
  if (file_.format == QueryFormat::binary) {
    out_.write(BinaryHeader{file_.kind, 3, count_, file_.with_claims, file_.separation}.bytes());
  } else if (file_.format == QueryFormat::npy) {
    out_.write(npy_query_header(file_.kind, count_));
  } else if (file_.format == QueryFormat::hdf5) {
    out_.write(hdf5_query_header(file_.kind, count_, file_.with_claims));
  }
  for (SpoolFile& spool : spools_) spool.copy_to(out_);
  out_.commit();
}

}  // namespace touchstone::io
