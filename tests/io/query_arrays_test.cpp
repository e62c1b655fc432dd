// Query files of doubles: the binary format and .npy keep every bit, and damaged files are named.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "io/queries/kind_of_file.hpp"
#include "io/queries/query_array.hpp"
#include "io/queries/query_file_writer.hpp"
#include "io/read_queries.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::array<std::size_t, 3> kChunks = {1, 1000, io::kChunkBytes};

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

bool same_bits(const Query& a, const Query& b) {
  bool equal = a.kind == b.kind;
  for (std::size_t i = 0; i < corner_count(a.kind); ++i) {
    equal = equal && same_bits(a.start[i], b.start[i]) && same_bits(a.end[i], b.end[i]);
  }
  return equal;
}

/// Queries of every family, and one of zeros of both signs, subnormals and the greatest doubles.
std::vector<Query> sample_queries(Kind kind, Rng& rng) {
  std::vector<Query> queries;
  for (const auto& family : all_families()) queries.push_back(make(family.family, kind, rng));
  Query extreme;
  extreme.kind = kind;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    extreme.start[i] = {-0.0, std::numeric_limits<double>::denorm_min(), -DBL_MAX};
    extreme.end[i] = {0.0, -DBL_MIN / 3, std::nextafter(1.0, 2.0)};
  }
  queries.push_back(extreme);
  return queries;
}

/// The bytes of a file of these queries; the claim of every second one is 1.
std::string file_of(const TemporaryFolder& folder, const std::vector<Query>& queries, const io::WrittenFile& file) {
  io::QueryFileWriter writer(folder.path("written"), file);
  for (std::size_t first = 0; first < queries.size(); first += 7) {
    io::EncodedQueries encoded(file);
    for (std::size_t i = first; i < std::min(first + 7, queries.size()); ++i) {
      io::QueryRecord record;
      record.query = queries[i];
      record.number = i;
      encoded.add("test", record, i % 2 == 1);
    }
    writer.write(encoded);
  }
  writer.commit();
  return folder.read("written");
}

std::string error_of(const std::string& content, Kind kind) {
  const std::string error = read_queries(content, kind, io::kChunkBytes, io::Motions::any).error;
  CHECK(read_queries(content, kind, 1, io::Motions::any).error == error);
  return error;
}

/// The same file with other bytes at one place.
std::string with_bytes(std::string content, std::size_t at, const std::string& bytes) {
  return content.replace(at, bytes.size(), bytes);
}

std::string little_endian(std::uint64_t value, std::size_t size) {
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
  return bytes;
}

template <class Number>
std::string bytes_of(Number value, std::endian order) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (order != std::endian::native) bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

std::string npy(const std::string& type, bool fortran, const std::string& shape, const std::string& values) {
  std::string text =
      "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\x01\x00", 8) + little_endian(text.size(), 2) + text + values;
}

/// An array of the numbers 0, 1, 2, ... in C's order, laid out as told.
template <class Number>
std::string counting_npy(const std::vector<std::size_t>& extents, bool fortran, std::endian order) {
  std::size_t count = 1;
  for (const std::size_t extent : extents) count *= extent;
  std::vector<std::string> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t to = i;
    if (fortran) {
      to = 0;
      std::size_t rest = i, step = count;
      for (std::size_t k = extents.size(); k-- > 0; rest /= extents[k]) to += rest % extents[k] * (step /= extents[k]);
    }
    values[to] = bytes_of(static_cast<Number>(i), order);
  }
  std::string all;
  for (const auto& value : values) all += value;
  std::string shape = "(";
  for (const std::size_t extent : extents) shape += std::to_string(extent) + ", ";
  shape.replace(shape.size() - 2, 2, ")");
  return npy((order == std::endian::big ? ">f" : "<f") + std::to_string(sizeof(Number)), fortran, shape, all);
}

}  // namespace

TEST_CASE("every format of doubles keeps every bit of every query") {
  constexpr std::uint64_t kSeed = 20261124;
  CAPTURE(kSeed);
  Rng rng(kSeed);
  const TemporaryFolder folder;
  for (const Kind kind : kKinds) {
    const std::vector<Query> queries = sample_queries(kind, rng);
    for (const io::QueryFormat format : {io::QueryFormat::binary, io::QueryFormat::npy}) {
      const bool with_claims = format == io::QueryFormat::binary;
      io::WrittenFile written{format, kind, with_claims, std::nullopt, true};
      const std::string content = file_of(folder, queries, written);
      for (const std::size_t chunk : kChunks) {
        CAPTURE(name_of(kind), io::format_name(format), chunk);
        const ReadFile file = read_queries(content, kind, chunk);
        REQUIRE(file.error == "");
        REQUIRE(file.queries.size() == queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i) {
          const ReadQuery& read = file.queries[i];
          CAPTURE(i, cpp_initializer(queries[i]));
          REQUIRE(same_bits(std::get<Query>(read.query), queries[i]));
          REQUIRE(read.truth == (with_claims ? std::optional(i % 2 == 1) : std::nullopt));
          REQUIRE(read.number == i);
          REQUIRE(read.first_row == i * io::rows_per_query(kind) + 1);
          REQUIRE(read.last_row == (i + 1) * io::rows_per_query(kind));
        }
      }
    }
  }
}

TEST_CASE("hexfloats keep every bit too, and claims and separations are kept where there is room") {
  constexpr std::uint64_t kSeed = 5;
  CAPTURE(kSeed);
  Rng rng(kSeed);
  const TemporaryFolder folder;
  const std::vector<Query> queries = sample_queries(Kind::vertex_face, rng);
  const Separation separation{0x1p-3, Metric::max};
  for (const io::QueryFormat format : {io::QueryFormat::hexfloat, io::QueryFormat::binary}) {
    CAPTURE(io::format_name(format));
    const std::string content = file_of(folder, queries, {format, Kind::vertex_face, true, separation, true});
    io::QueryChunkReader reader(io::InputFile::from_memory("q", content), Kind::vertex_face, io::kChunkBytes,
                                io::Motions::any);
    const auto chunk = reader.next();
    REQUIRE(chunk);
    const auto stated = io::stated_separation(*chunk);
    REQUIRE(stated);
    CHECK(stated->distance == separation.distance);
    CHECK(stated->metric == separation.metric);
    io::QueryParser parser(*chunk);
    io::QueryRecord record;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      REQUIRE(parser.next(record));
      REQUIRE(record.truth == (i % 2 == 1));
      if (const auto* const curved = std::get_if<CurvedQuery>(&record.query)) {
        for (std::size_t k = 0; k < 4; ++k) {
          REQUIRE(same_bits(curved->corners[k].points[0], queries[i].start[k]));
          REQUIRE(same_bits(curved->corners[k].points[1], queries[i].end[k]));
        }
        continue;
      }
      REQUIRE(same_bits(std::get<Query>(record.query), queries[i]));
    }
  }
}

TEST_CASE("arrays are read in each order, type and dimension") {
  for (const bool fortran : {false, true}) {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      for (const bool single : {false, true}) {
        for (const std::size_t dimension : {2, 3}) {
          for (const Kind kind : kKinds) {
            CAPTURE(fortran, order == std::endian::big, single, dimension, name_of(kind));
            const std::size_t corners = corner_count(kind);
            std::vector<std::vector<std::size_t>> shapes = {{5, 2, corners, dimension}, {5, 2 * corners, dimension}};
            if (dimension == 3) shapes.push_back({5, 6 * corners});
            for (const auto& shape : shapes) {
              const ReadFile file = read_queries(
                  single ? counting_npy<float>(shape, fortran, order) : counting_npy<double>(shape, fortran, order),
                  kind, 1);
              REQUIRE(file.error == "");
              REQUIRE(file.queries.size() == 5);
              double next = 0;
              for (const ReadQuery& read : file.queries) {
                const Query& query = std::get<Query>(read.query);
                for (const auto& times : {query.start, query.end}) {
                  for (std::size_t i = 0; i < corners; ++i) {
                    REQUIRE(times[i].x == next++);
                    REQUIRE(times[i].y == next++);
                    REQUIRE(times[i].z == (dimension == 3 ? next++ : 0));
                  }
                }
              }
            }
          }
        }
      }
    }
  }
}

TEST_CASE("a damaged header of a binary file is named with its byte, its value and what is right") {
  Rng rng(7);
  const TemporaryFolder folder;
  const std::vector<Query> queries = sample_queries(Kind::point_point, rng);
  const std::string good =
      file_of(folder, queries, {io::QueryFormat::binary, Kind::point_point, true, std::nullopt, true});
  REQUIRE(error_of(good, Kind::point_point) == "");
  const std::string header = "q.csv: the header of the binary query file: ";
  const std::vector<std::pair<std::string, std::string>> damaged = {
      {with_bytes(good, 8, "\2"), header + "the version, at byte 8, is 2; version 1 is read"},
      {with_bytes(good, 12, "\4"),
       header + "the kind, at byte 12, is 4; 0 is edge-edge, 1 vertex-face, 2 point-edge and 3 point-point"},
      {with_bytes(good, 16, "\1"), header + "the dimension, at byte 16, is 1; it must be 2 or 3"},
      {with_bytes(good, 20, "\4"), header + "the sum of the flags, at byte 20, is 4; known are 1 (there is a column "
                                            "of claims) and 2 (the claims' separation is given)"},
      {with_bytes(good, 39, "\x3F"), header + "the separation, at byte 32, is given; without the flag 2 these eight "
                                              "bytes must be 0"},
      {with_bytes(good, 40, "\1"), header + "the metric, at byte 40, is 1; without the flag 2 it must be 0"},
      {with_bytes(good, 63, "\xFF"), header + "a reserved byte, at byte 63, is 255; it must be 0"},
      {with_bytes(with_bytes(good, 20, "\3"), 39, "\xBF"),
       header + "the separation, at byte 32, is -0x1p-15; it must be 0 or greater"},
      {with_bytes(with_bytes(good, 20, "\3"), 38, "\xF0\x7F"),
       header + "the separation, at byte 32, is not finite; it must be 0 or greater"},
      {with_bytes(with_bytes(good, 20, "\3"), 40, "\2"),
       header + "the metric, at byte 40, is 2; 0 is euclidean and 1 max"},
  };
  for (const auto& [content, reason] : damaged) {
    CHECK(error_of(content, Kind::point_point) == reason);
  }
  CHECK(error_of(good, Kind::edge_edge) == "q.csv: its queries are of the kind point-point; edge-edge was asked for");
  const std::string count = std::to_string(queries.size());
  CHECK(error_of(good + "x", Kind::point_point) ==
        "q.csv: the header promises " + count + " queries of 97 bytes, and the file has " +
            std::to_string(97 * queries.size() + 1) + " bytes for them: it is cut off or damaged");
  CHECK(
      error_of(with_bytes(good, 24, std::string(8, '\xFF')), Kind::point_point).find("promises 18446744073709551615") !=
      std::string::npos);
  CHECK(error_of(with_bytes(good.substr(0, 64), 24, std::string(8, '\0')), Kind::point_point) ==
        "q.csv: holds no query");
}

TEST_CASE("claims and coordinates that cannot be are named with their query") {
  Rng rng(8);
  const TemporaryFolder folder;
  std::vector<Query> queries = sample_queries(Kind::vertex_face, rng);
  const io::WrittenFile written{io::QueryFormat::binary, Kind::vertex_face, true, std::nullopt, true};
  std::string content = file_of(folder, queries, written);
  content[content.size() - queries.size() + 2] = '\2';
  ReadFile file = read_queries(content, Kind::vertex_face, 1);
  CHECK(file.queries.size() == 2);
  CHECK(file.error == "q.csv: query 2: the byte of its claim is neither 0 nor 1");

  queries[3].end[2].y = std::numeric_limits<double>::quiet_NaN();
  CHECK(error_of(file_of(folder, queries, written), Kind::vertex_face) ==
        "q.csv: query 3: y of f1 at t = 1 is no number (NaN); a coordinate must be a finite number");
  queries[3].start[0].z = -std::numeric_limits<double>::infinity();
  CHECK(error_of(file_of(folder, queries, written), Kind::vertex_face) ==
        "q.csv: query 3: z of v at t = 0 is infinite; a coordinate must be a finite number");
}

TEST_CASE("arrays of other shapes and types are refused") {
  const std::string three(8 * 2 * 3 * 3, '\0');
  CHECK(error_of(npy("<f8", false, "(1, 2, 3, 3)", three), Kind::point_edge) == "");
  CHECK(error_of(npy("<f8", false, "(1, 2, 3, 3)", three), Kind::edge_edge) ==
        "q.csv: its queries are of the kind point-edge; edge-edge was asked for");
  CHECK(error_of(npy("<f8", false, "(1, 2, 4, 3)", std::string(192, '\0')), Kind::point_edge) ==
        "q.csv: its queries have 4 corners: edge-edge or vertex-face; point-edge was asked for");
  CHECK(error_of(npy("<i8", false, "(1, 2, 3, 3)", three), Kind::point_edge) ==
        "q.csv: holds integers; coordinates have the type float64 or float32");
  CHECK(error_of(npy("<f8", false, "(0, 2, 3, 3)", ""), Kind::point_edge) == "q.csv: holds no query");
  for (const std::string shape :
       {"(2, 3, 3)", "(1, 1, 6, 3)", "(1, 2, 9, 1)", "(1, 2, 1, 9)", "(18,)", "(2, 9)", "(1, 3, 6)", "(1, 18, 1)"}) {
    const std::string error = error_of(npy("<f8", false, shape, three), Kind::point_edge);
    CAPTURE(shape, error);
    CHECK(error.find("an array of shape " + shape + "; queries have the shape (n, 2, corners, 3)") !=
          std::string::npos);
  }
  CHECK(error_of(npy("<f8", false, "(1, 2, 3, 3)", three.substr(1)), Kind::point_edge) ==
        "q.csv: an array of shape (1, 2, 3, 3) has 18 values of 8 bytes, and the file has 143 bytes for them");
}

TEST_CASE("a file that is cut off anywhere, or has any one byte changed, is read or refused in one line") {
  Rng rng(9);
  const TemporaryFolder folder;
  const std::vector<Query> queries(3, make(Family::simulation, Kind::point_edge, rng));
  std::size_t refused = 0;
  for (const io::QueryFormat format : {io::QueryFormat::binary, io::QueryFormat::npy}) {
    const bool claims = format == io::QueryFormat::binary;
    const std::string good = file_of(folder, queries, {format, Kind::point_edge, claims, std::nullopt, true});
    const auto check = [&](const std::string& content) {
      const std::string error = error_of(content, Kind::point_edge);
      CAPTURE(error);
      CHECK((error.empty() || error.rfind("q.csv:", 0) == 0));
      CHECK(error.find('\n') == std::string::npos);
      refused += !error.empty();
    };
    for (std::size_t size = 0; size < good.size(); ++size) {
      check(good.substr(0, size));
      CHECK(refused == size + 1);  // no shorter file is whole
    }
    refused = 0;
    for (std::size_t at = 0; at < good.size(); ++at) {
      for (const char c : {'\0', '\1', '\xFF', static_cast<char>(good[at] ^ 16)}) check(with_bytes(good, at, {c}));
    }
    CHECK(refused > 100);
    refused = 0;
  }
}

TEST_CASE("the kind of a file's queries is the one that it states") {
  Rng rng(10);
  const TemporaryFolder folder;
  const std::vector<Query> queries(2, make(Family::simulation, Kind::point_edge, rng));
  const io::WrittenFile written{io::QueryFormat::binary, Kind::point_edge, true, std::nullopt, true};
  const std::string binary = folder.write("edge-edge/a.tsq", file_of(folder, queries, written));
  CHECK(io::kind_of_queries(binary, std::nullopt) == Kind::point_edge);
  CHECK(io::kind_of_queries(binary, Kind::point_edge) == Kind::point_edge);
  CHECK_THROWS_AS(io::kind_of_queries(binary, Kind::edge_edge), FileError);
  const std::string four = counting_npy<double>({1, 2, 4, 3}, false, std::endian::little);
  CHECK(io::kind_of_queries(folder.write("vertex-face/a.npy", four), std::nullopt) == Kind::vertex_face);
  CHECK_THROWS_AS(io::kind_of_queries(folder.write("a.npy", four), std::nullopt), FileError);
  CHECK(io::kind_of_queries(folder.path("a.npy"), Kind::edge_edge) == Kind::edge_edge);
  const std::string two = counting_npy<double>({1, 2, 2, 3}, false, std::endian::little);
  // Corners of two edges at one time look like two points at both.
  const std::string b = folder.write("edge-edge/b.npy", two);
  CHECK_THROWS_AS(io::kind_of_queries(b, std::nullopt), FileError);
  CHECK(io::kind_of_queries(b, Kind::point_point) == Kind::point_point);
  CHECK(io::kind_of_queries(folder.write("b.npy", two), std::nullopt) == Kind::point_point);
  CHECK(io::kind_of_queries(folder.write("edge-edge/c.csv", "anything"), std::nullopt) == Kind::edge_edge);
  CHECK(io::kind_of_queries(folder.write("edge-edge/d.csv", ""), std::nullopt) == Kind::edge_edge);
}

TEST_CASE("what a format does not hold is refused, with its row and column") {
  const auto refusal = [](io::QueryFormat format, const std::string& rows) -> std::string {
    const io::WrittenFile written{format, Kind::point_point, true, std::nullopt, true};
    const ReadFile file = read_queries(rows, Kind::point_point, io::kChunkBytes, io::Motions::any);
    io::EncodedQueries encoded(written);
    try {
      for (const ReadQuery& read : file.queries) {
        encoded.add("a.csv", {read.query, read.truth, read.number, read.first_row, read.last_row, read.text},
                    read.truth);
      }
    } catch (const FileError& error) {
      return error.what();
    }
    return file.error;
  };
  const std::string third = "0,1,0,1,0,1,0\n# a comment\n0,1,1,3,0,1,0\n0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n";
  for (const io::QueryFormat format : {io::QueryFormat::hexfloat, io::QueryFormat::binary, io::QueryFormat::npy}) {
    CHECK(refusal(format, third) == "a.csv:3: y_num,y_den (y of q at t = 0 in query 0) is 1/3, which is no double; " +
                                        std::string(io::format_name(format)) +
                                        " holds doubles alone, and csv holds every fraction");
  }
  CHECK(refusal(io::QueryFormat::csv, third) == "");
  const std::string zero = "touchstone-curved,1\nquery,0\ncurve,0,0,0,1,1,-0x0p+0\ncurve,1,1,1\n";
  CHECK(refusal(io::QueryFormat::csv, zero) ==
        "a.csv:4: z of p at t = 1 in query 0 is -0, and a fraction has no sign of zero; the other formats hold it, or "
        "--unsigned-zeros writes 0");
  CHECK(refusal(io::QueryFormat::binary, zero) == "");
  const std::string parabola = "touchstone-curved,1\nquery,0\ncurve,0,0,0,1,1,1,2,0,0\ncurve,1,1,1\n";
  for (const io::QueryFormat format : {io::QueryFormat::csv, io::QueryFormat::binary, io::QueryFormat::npy}) {
    CHECK(refusal(format, parabola) == "a.csv:2: query 0 has curved motion; " + std::string(io::format_name(format)) +
                                           " holds straight motion alone, and hexfloat holds both");
  }
  CHECK(refusal(io::QueryFormat::hexfloat, parabola) == "");
}

TEST_CASE("a pipe cannot be mapped") {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(io::kind_of_queries(pipe, Kind::edge_edge) == Kind::edge_edge);  // it is not read
}
