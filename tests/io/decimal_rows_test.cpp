// Query files of decimals: a corner a row, or a whole query.
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "io/queries/decimal_rows.hpp"
#include "io/queries/query_writer.hpp"
#include "io/read_queries.hpp"
#include "io/times.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::array<std::size_t, 5> kChunks = {1, 7, 100, 1000, io::kChunkBytes};

/// The corners of a query, each as text by `write`, joined by commas or line ends.
template <class Write>
std::string rows_of(const Query& query, const std::string& separator, const std::string& truth, const Write& write) {
  std::string text;
  for (const bool at_end : {false, true}) {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      const Vec3& x = at_end ? query.end[i] : query.start[i];
      const bool last = at_end && i + 1 == corner_count(query.kind);
      text += write(x.x) + "," + write(x.y) + "," + write(x.z);
      if (separator == "\n" || last) text += truth;
      text += last ? "\n" : separator;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("decimals and hexfloats of doubles are read as these doubles, in rows of corners and of queries") {
  constexpr std::uint64_t kSeed = 2026;
  CAPTURE(kSeed);
  Rng rng(kSeed);
  const auto hexfloat = [](double x) { return io::hexfloat(x); };
  const auto shortest = [](double x) {  // which needs --as-doubles
    std::array<char, 40> text;
    return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr);
  };
  for (const Kind kind : kKinds) {
    for (const std::string separator : {"\n", ","}) {
      for (const std::string truth : {"", ",1"}) {
        std::string hexfloats = "# a comment\n", decimals;
        const std::size_t numbers = separator == "," ? 6 * corner_count(kind) : 3;
        for (std::size_t i = 0; i < numbers; ++i) {
          decimals += (i > 0 ? " ," : "") + std::string(1, "xyZ"[i % 3]) + std::to_string(i / 3);
        }
        decimals += (truth.empty() ? "" : ",Truth") + std::string("\r\n");
        std::vector<Query> queries;
        for (const auto& family : all_families()) {
          queries.push_back(make(family.family, kind, rng));
          hexfloats += rows_of(queries.back(), separator, truth, hexfloat);
          decimals += rows_of(queries.back(), separator, truth, shortest);
        }
        for (const std::size_t chunk : kChunks) {
          CAPTURE(kind, separator, truth, chunk);
          for (const bool nearest : {false, true}) {
            const ReadFile file = read_queries(nearest ? decimals : hexfloats, kind, chunk, io::Motions::straight,
                                               nearest ? io::Decimals::nearest_double : io::Decimals::exact);
            REQUIRE(file.error == "");
            REQUIRE(file.queries.size() == queries.size());
            for (std::size_t i = 0; i < queries.size(); ++i) {
              REQUIRE(same(std::get<Query>(file.queries[i].query), queries[i]));
              REQUIRE(file.queries[i].truth == (truth.empty() ? std::nullopt : std::optional(true)));
            }
          }
        }
      }
    }
  }
}

TEST_CASE("a decimal that is no double is a rational, and the nearest double when it is asked for") {
  const std::string rows = "0.1,0,0\n1,0,0\n.5,+0,-0\n1e-1,0,0\n";
  const ReadFile exact = read_queries(rows, Kind::point_point, io::kChunkBytes);
  REQUIRE(exact.error == "");
  const auto& rational = std::get<RationalQuery>(exact.queries.at(0).query);
  CHECK(rational.start[0][0].numerator == "1");
  CHECK(rational.start[0][0].denominator == "10");
  CHECK(rational.end[1][0].numerator == "1");
  CHECK(rational.end[1][0].denominator == "10");
  const ReadFile nearest =
      read_queries(rows, Kind::point_point, io::kChunkBytes, io::Motions::straight, io::Decimals::nearest_double);
  CHECK(std::get<Query>(nearest.queries.at(0).query).start[0].x == 0.1);
}

TEST_CASE("faults of decimals are named with what would be right") {
  const auto error = [](const std::string& text, io::Decimals decimals = io::Decimals::exact) {
    const std::string whole =
        read_queries(text, Kind::point_point, io::kChunkBytes, io::Motions::straight, decimals).error;
    for (const std::size_t chunk : kChunks) {
      CHECK(read_queries(text, Kind::point_point, chunk, io::Motions::straight, decimals).error == whole);
    }
    return whole.substr(whole.find(':'));
  };
  CHECK(error("1,2,x\n") == ":1: z is 'x'; it must be a number such as -0.25, 1e-3 or 0x1p-2");
  CHECK(error("1,2,nan\n") == ":1: z is 'nan'; it must be a number such as -0.25, 1e-3 or 0x1p-2");
  CHECK(error("1,+-2,3\n") == ":1: y is '+-2'; it must be a number such as -0.25, 1e-3 or 0x1p-2");
  CHECK(error("1,2,3\n1,2\n") == ":2: 2 columns; the first row has 3 decimals, x,y,z and no truth");
  CHECK(error("1,2,3,1\n1,2,3\n") == ":2: 3 columns; the first row has 3 decimals, x,y,z and truth");
  const std::string cut = ": the last row does not end with an end of line, so that the file may be cut off here";
  CHECK(error("1,2,3\n1,2,3\n1,2,3\n1,2,-2") == ":4" + cut);
  CHECK(error("id,x,y,z\n0,1,2,0\n") == ":1: column 1 is called 'id'; the columns are x, y and z");
  CHECK(error("x,y,z,w\n0,1,2,0\n").starts_with(":1: column 4 is called 'w'; the last of so many columns is truth"));
  CHECK(error("truth,x,y,z\n0,1,2,0\n") ==
        ":1: column 1 is called 'truth'; the truth stands last, behind the coordinates");
  for (const char* const names : {"vz,vy,vx", "pos_z,pos_y,pos_x", "position_x,position_z,position_y"}) {
    CHECK(error(names + std::string("\n0,1,2\n")).find("; the columns are x, y and z") != std::string::npos);
  }
  CHECK(error("z,y,x\n0,1,2\n") == ":1: column 1 is called 'z'; the columns are x, y and z");
  CHECK(error("x,y\n0,1,2\n") == ":1: the line names 2 columns, and the first row has 3");
  CHECK(error("NAN,Inf,none\n").starts_with(":1: x is 'NAN'; it must be a number"));
  CHECK(error("1,2,3\n") == ":1: the file ends within query 0, which has 1 row; a point-point query has 4");
  CHECK(error("1,2,3,1\n1,2,3,0\n").starts_with(":2: truth is 0 here and 1 in row 1"));
  CHECK(error("1,2,3,2\n") == ":1: truth is '2'; it must be 0 or 1, true or false, or yes or no");
  CHECK(error("1,2,3,4,5\n").starts_with(":1: 5 columns; a row is a corner as fractions, with 7 columns: x_num"));
  CHECK(error("1,2,3,4,5,6,7,8,9,0,1,inf\n") ==
        ":1: z of q at t = 1 is 'inf'; it must be a number such as -0.25, 1e-3 or 0x1p-2");
  CHECK(error("1,2,1e-5000\n") == ":1: z is '1e-5000'; as a fraction it has more than 4096 digits");
  CHECK(error("1,2,1e400\n", io::Decimals::nearest_double) == ":1: z is '1e400'; it is beyond the greatest double");
  CHECK(error("x,y,z\nx,y,z\n1,2,3\n").starts_with(":2: x is 'x'; it must be a number"));
  CHECK(error("x,y,z\n").starts_with(": holds no query"));
  CHECK(error("a\ntouchstone-curved,1\nquery,1\n") ==
        ":1: a line of words stands before the row touchstone-curved,1, which must be the first");
}
