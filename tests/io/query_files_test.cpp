// Query files: queries are read as they were written, for any size of chunks and any layout.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/queries/query_row.hpp"
#include "io/queries/query_writer.hpp"
#include "io/read_queries.hpp"
#include "numbers/fraction.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::array<std::size_t, 6> kChunks = {1, 7, 100, 1000, 4096, io::kChunkBytes};

/// A digit string of 1 to `most` digits that does not start with zero.
std::string random_digits(Rng& rng, int most) {
  std::string digits(1, static_cast<char>('0' + rng.between(1, 9)));
  for (int n = rng.between(0, most - 1); n > 0; --n) digits += static_cast<char>('0' + rng.between(0, 9));
  return digits;
}

std::string row_of(const std::string& numerator, const std::string& denominator) {
  return numerator + "," + denominator + ",0,1,0,1,0\n";
}

/// A point-point query whose first coordinate is the given fraction.
std::string query_with(const std::string& numerator, const std::string& denominator) {
  return row_of(numerator, denominator) + row_of("1", "1") + row_of("2", "1") + row_of("3", "1");
}

/// Rows laid out as people and programs do: comments, blank lines, blanks around numbers, CRLF, a byte order mark.
std::string decorated(const std::string& rows, Rng& rng) {
  std::string out = rng.one_in(2) ? "\xEF\xBB\xBF" : "";
  const std::string line_end = rng.one_in(2) ? "\r\n" : "\n";
  for (std::size_t start = 0; start < rows.size();) {
    const std::size_t end = rows.find('\n', start);
    std::string row = rows.substr(start, end - start);
    if (rng.one_in(4)) out += "# x,y,z: not a row" + line_end;
    if (rng.one_in(4)) out += std::string(static_cast<std::size_t>(rng.between(0, 2)), ' ') + line_end;
    if (rng.one_in(4)) row.insert(row.find(',') + 1, " \t");
    if (rng.one_in(8)) row = "  " + row + " ";
    out += row + line_end;
    start = end + 1;
  }
  if (rng.one_in(2)) out.resize(out.size() - line_end.size());
  return out;
}

}  // namespace

TEST_CASE("queries of every family survive a round trip through a file, at any chunk size") {
  constexpr std::uint64_t kSeed = 20240611;
  CAPTURE(kSeed);
  Rng rng(kSeed);
  for (const Kind kind : kKinds) {
    std::string plain;
    std::vector<Query> queries;
    std::vector<bool> truths;
    for (const auto& family : all_families()) {
      for (int i = 0; i < 4; ++i) {
        queries.push_back(make(family.family, kind, rng));
        truths.push_back(rng.one_in(2));
        io::append_query(plain, queries.back(), truths.back());
      }
    }
    for (const std::size_t chunk : kChunks) {
      for (const std::string& text : {plain, decorated(plain, rng)}) {
        CAPTURE(chunk, name_of(kind));
        const ReadFile file = read_queries(text, kind, chunk);
        REQUIRE(file.error == "");
        REQUIRE(file.queries.size() == queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i) {
          const auto& read = file.queries[i];
          CAPTURE(i, cpp_initializer(queries[i]));
          REQUIRE(std::holds_alternative<Query>(read.query));
          REQUIRE(same(std::get<Query>(read.query), queries[i]));
          REQUIRE(read.truth == truths[i]);
          REQUIRE(read.number == i);
        }
      }
    }
  }
}

TEST_CASE("every power of two, its neighbours and the ends of the doubles survive a round trip") {
  std::vector<double> values = {0.0,     DBL_MAX, DBL_MIN, std::numeric_limits<double>::denorm_min(),
                                1.0 / 3, 1e300,   1e-300};
  for (int k = -1074; k < 1024; ++k) {
    const double power = std::ldexp(1.0, k);
    for (const double value : {power, std::nextafter(power, 0.0), std::nextafter(power, DBL_MAX)})
      values.push_back(value);
  }
  std::string text;
  for (const double value : values) io::append_query(text, Query(PointPoint{{Vec3{value, -value, 0}}, {}}), false);
  const ReadFile file = read_queries(text, Kind::point_point, io::kChunkBytes);
  REQUIRE(file.error == "");
  REQUIRE(file.queries.size() == values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto& query = std::get<Query>(file.queries[i].query);
    CAPTURE(hexfloat(values[i]));
    REQUIRE(query.start[0].x == values[i]);
    REQUIRE(query.start[0].y == -values[i]);
    REQUIRE_FALSE(std::signbit(query.start[0].z));
  }
}

TEST_CASE("fractions of doubles are in lowest terms") {
  const auto text = [](double value) {
    const Fraction f = io::fraction_of(value);
    return f.numerator + "/" + f.denominator;
  };
  CHECK(text(0.0) == "0/1");
  CHECK(text(-0.0) == "0/1");
  CHECK(text(-0.75) == "-3/4");
  CHECK(text(1e22) == "10000000000000000000000/1");
  CHECK(text(0x1p-64) == "1/18446744073709551616");
  CHECK(text(0x1.5555555555555p-2) == "6004799503160661/18014398509481984");
  CHECK(io::fraction_of(DBL_MAX).numerator.size() == 309);
  CHECK(io::fraction_of(std::numeric_limits<double>::denorm_min()).denominator.size() == 324);
  CHECK(io::fraction_of(0x1p90).numerator == "1237940039285380274899124224");  // zeros inside a limb
}

TEST_CASE("any fraction is read as the double that it is, or as the rational that it is", "[slow]") {
  constexpr std::uint64_t kSeed = 7;
  CAPTURE(kSeed);
  Rng rng(kSeed);
  std::size_t doubles = 0;
  std::size_t rationals = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string numerator = random_digits(rng, rng.one_in(3) ? 45 : 17);
    if (rng.one_in(3)) numerator.insert(0, 1, '-');
    if (rng.one_in(20)) numerator = rng.one_in(2) ? "-0" : "000";
    std::string denominator = io::fraction_of(std::ldexp(1.0, -rng.between(0, rng.one_in(4) ? 1074 : 130))).denominator;
    if (rng.one_in(4)) denominator = random_digits(rng, 40);
    if (rng.one_in(9)) denominator.insert(0, "00");
    const auto expected = numbers::exact_double(numerator, denominator);
    const ReadFile file = read_queries(query_with(numerator, denominator), Kind::point_point, 4096);
    CAPTURE(numerator, denominator);
    REQUIRE(file.error == "");
    REQUIRE(file.queries.size() == 1);
    if (expected) {
      ++doubles;
      REQUIRE(std::holds_alternative<Query>(file.queries[0].query));
      REQUIRE(std::get<Query>(file.queries[0].query).start[0].x == *expected);
    } else {
      ++rationals;
      REQUIRE(std::holds_alternative<RationalQuery>(file.queries[0].query));
      const auto& corner = std::get<RationalQuery>(file.queries[0].query).start[0];
      REQUIRE(corner[0].numerator == numerator);
      REQUIRE(corner[0].denominator == denominator);
    }
  }
  CHECK(doubles > 5000);
  CHECK(rationals > 5000);
}

TEST_CASE("minus zero in a file is plain zero, on the fast path and beside it") {
  for (const char* numerator : {"-0", " -0", "-000"}) {
    CAPTURE(numerator);
    const ReadFile file = read_queries(query_with(numerator, "4"), Kind::point_point, io::kChunkBytes);
    REQUIRE(file.error == "");
    const double x = std::get<Query>(file.queries.at(0).query).start[0].x;
    CHECK(x == 0);
    CHECK_FALSE(std::signbit(x));
  }
}

TEST_CASE("a row of the usual sort takes the fast path, and what is not such a row does not") {
  const auto usual = [](std::string row) {
    row.append(16, '\0');
    io::DoubleRow read;
    return io::read_usual_row(row.data(), read) != nullptr;
  };
  CHECK(usual("1,1,-3,4,6004799503160661,81129638414606681695789005144064,1\n"));
  CHECK(usual("9007199254740992,1,9223372036854775808,9223372036854775808,0,1,0\r\n"));
  CHECK(usual("0,1,0,1,0,1,0"));
  CHECK(usual("1,1,-3,4,6004799503160661,81129638414606681695789005144064\n"));
  CHECK(usual("1,1,-3,4,0,134217728\r\n"));
  CHECK(usual("0,1,0,1,0,1"));
  for (const char* row :
       {"9007199254740993,1,0,1,0,1,0\n", "1,3,0,1,0,1,0\n", "1,0,0,1,0,1,0\n", "1,-1,0,1,0,1,0\n", "+1,1,0,1,0,1,0\n",
        " 1,1,0,1,0,1,0\n", "1,1,0,1,0,1,2\n", "1,1,0,1,0,1,0,\n", "1,1,0,1,0\n", "1,1,0,1,0,1,\n", "1,1,0,1\n0,1,0\n",
        "-,1,0,1,0,1,0\n", "1,,0,1,0,1,0\n", "1,1,0,1,0,1,00\n", ""}) {
    CAPTURE(row);
    CHECK_FALSE(usual(row));
  }
}

TEST_CASE("rational queries are kept as they are written, whatever stands between their rows") {
  RationalQuery query;
  query.kind = Kind::point_edge;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      query.start[i][axis] = {std::to_string(i) + std::string(40, '7'), "30" + std::to_string(axis)};
      query.end[i][axis] = {"-" + std::to_string(axis + 1), "3"};
    }
  }
  std::string text;
  io::append_query(text, query, true);
  Rng rng(3);
  for (int i = 0; i < 20; ++i) {
    const ReadFile file = read_queries(decorated(text, rng), Kind::point_edge, io::kChunkBytes);
    REQUIRE(file.error == "");
    REQUIRE(file.queries.size() == 1);
    REQUIRE(std::holds_alternative<RationalQuery>(file.queries[0].query));
    CHECK(same(std::get<RationalQuery>(file.queries[0].query), query));
    CHECK(same(io::query_as_given(Kind::point_edge, file.queries[0].text), query));
    CHECK(file.queries[0].truth == true);
  }
}

TEST_CASE("queries of six columns are those of seven without their truth") {
  std::string given, bare;
  for (const Kind kind : kKinds) {
    Rng rng(7);
    given.clear();
    bare.clear();
    for (int i = 0; i < 12; ++i) {
      Query query;
      query.kind = kind;
      for (std::size_t c = 0; c < corner_count(kind); ++c) {
        query.start[c] = {rng.symmetric(), 4 * rng.symmetric(), std::ldexp(rng.symmetric(), -80)};
        query.end[c] = {1, rng.symmetric() * 1e17, -0.5};
      }
      io::append_query(given, query, i % 2 == 0);
      io::append_query(bare, query, std::nullopt);
    }
    const std::string third = "1,3,0,1,0,1";
    for (std::size_t row = 0; row < 2 * corner_count(kind); ++row) {
      given += third + ",1\n";
      bare += third + "\n";
    }
    CHECK(std::count(bare.begin(), bare.end(), ',') * 6 == std::count(given.begin(), given.end(), ',') * 5);
    for (const std::size_t chunk : kChunks) {
      const ReadFile with = read_queries(given, kind, chunk), without = read_queries(bare, kind, chunk),
                     laid_out = read_queries(decorated(bare, rng), kind, chunk);
      CAPTURE(chunk, without.error);
      REQUIRE(with.queries.size() == 13);
      REQUIRE(without.queries.size() == 13);
      REQUIRE(laid_out.queries.size() == 13);
      for (std::size_t i = 0; i < 13; ++i) {
        CHECK_FALSE(without.queries[i].truth.has_value());
        CHECK_FALSE(laid_out.queries[i].truth.has_value());
        CHECK(without.queries[i].last_row == with.queries[i].last_row);
        REQUIRE(without.queries[i].query.index() == with.queries[i].query.index());
        if (i == 12) {
          CHECK(
              same(std::get<RationalQuery>(without.queries[i].query), std::get<RationalQuery>(with.queries[i].query)));
        } else {
          CHECK(same(std::get<Query>(without.queries[i].query), std::get<Query>(with.queries[i].query)));
          CHECK(same(std::get<Query>(laid_out.queries[i].query), std::get<Query>(with.queries[i].query)));
        }
      }
    }
  }
}

TEST_CASE("rows are counted as lines of the file, queries from 0") {
  const std::string row = "0,1,0,1,0,1,1\n";
  const std::string text =
      "# head\n\n" + row + row + "# between\n" + row + row + "\r\n# tail\n" + row + row + row + row;
  for (const std::size_t chunk : kChunks) {
    CAPTURE(chunk);
    const ReadFile file = read_queries(text, Kind::point_point, chunk);
    REQUIRE(file.error == "");
    REQUIRE(file.queries.size() == 2);
    CHECK(file.queries[0].number == 0);
    CHECK(file.queries[0].first_row == 3);
    CHECK(file.queries[0].last_row == 7);
    CHECK(file.queries[1].number == 1);
    CHECK(file.queries[1].first_row == 10);
    CHECK(file.queries[1].last_row == 13);
  }
}

TEST_CASE("comments between queries may be of any length") {
  std::string text;
  while (text.size() <= io::kLongestQuery) text += "#" + std::string(100'000, ' ') + "\n";
  text += query_with("1", "1") + text;
  const ReadFile file = read_queries(text, Kind::point_point, io::kChunkBytes);
  CHECK(file.error == "");
  CHECK(file.queries.size() == 1);
}
