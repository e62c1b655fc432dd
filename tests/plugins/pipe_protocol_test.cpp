// The lines that programs read and write.
// SPDX-License-Identifier: MIT
#include "pipes/protocol.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "support/catch.hpp"

using namespace touchstone;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("a query's line is its kind and its coordinates, and can be read back") {
  PointPoint points;
  points.start = {{{0, -0.0, 1}, {0.1, 0x1p-1074, -0x1.fffffffffffffp+1023}}};
  points.end = {{{2, 3, 4}, {5, 6, 0.5}}};
  const std::string line = pipes::query_line(points);
  CHECK(line ==
        "point-point 0x0p+0 -0x0p+0 0x1p+0 0x1.999999999999ap-4 0x0.0000000000001p-1022 -0x1.fffffffffffffp+1023 "
        "0x1p+1 0x1.8p+1 0x1p+2 0x1.4p+2 0x1.8p+2 0x1p-1\n");
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}) {
    Query query;
    query.kind = kind;
    double value = 0.1;
    for (auto* corners : {&query.start, &query.end}) {
      for (std::size_t i = 0; i < corner_count(kind); ++i) {
        (*corners)[i] = {value, -value * 1e300, value * 1e-310};
        value += 1;
      }
    }
    std::string text = pipes::query_line(query);
    REQUIRE(text.back() == '\n');
    text.pop_back();
    const auto read = pipes::read_query_line(text);
    REQUIRE(read);
    CHECK(read->kind == kind);
    for (std::size_t i = 0; i < corner_count(kind); ++i) {
      CHECK(same_bits(read->start[i].x, query.start[i].x));
      CHECK(same_bits(read->start[i].y, query.start[i].y));
      CHECK(same_bits(read->end[i].z, query.end[i].z));
    }
    CHECK_FALSE(pipes::read_query_line(text + " 0x1p+0"));
    CHECK_FALSE(pipes::read_query_line(text.substr(0, text.rfind(' '))));
    CHECK_FALSE(pipes::read_query_line("edge" + text));
  }
}

TEST_CASE("answers that can be read") {
  const auto read = [](const char* line) { return pipes::read_answer_line(line); };
  CHECK_FALSE(read("0")->contact);
  CHECK_FALSE(read(" 0 \r")->contact);
  CHECK_FALSE(read("unknown")->known);
  CHECK(read("0")->known);
  CHECK_FALSE(read("unknown 1"));
  CHECK(read("1")->contact);
  CHECK_FALSE(read("1")->toi);
  CHECK(read("1 0.5")->toi == 0.5);
  CHECK(read("1\t0x1p-1\r")->toi == 0.5);
  CHECK(read("1 0X1.8P+1")->toi == 3.0);
  CHECK(read("1 +.5")->toi == 0.5);
  CHECK(read("1 -2e-1")->toi == -0.2);
  CHECK(read("1 5")->toi == 5.0);
  CHECK(std::isnan(*read("1 nan")->toi));
  CHECK(std::isnan(*read("1 -NaN")->toi));
  CHECK(read("1 inf")->toi == std::numeric_limits<double>::infinity());
  CHECK(read("1 -Infinity")->toi == -std::numeric_limits<double>::infinity());
  CHECK(read("1 1e999")->toi == std::numeric_limits<double>::infinity());
  CHECK(read("1 1e-999")->toi == 0.0);
  const std::string many(800, '0');
  CHECK(pipes::read_answer_line("1 1" + many + "e-100")->toi == std::numeric_limits<double>::infinity());
  CHECK(pipes::read_answer_line("1 0." + many + "1e100")->toi == 0.0);
  CHECK(pipes::read_answer_line("1 0x1" + many + "p-10")->toi == std::numeric_limits<double>::infinity());
  CHECK(pipes::read_answer_line("1 0x." + many + "1p10")->toi == 0.0);
  CHECK_FALSE(read("unsupported")->supported);
  CHECK(read("0")->supported);
}

TEST_CASE("a time that is no double is kept as it is written") {
  const auto written = [](const std::string& time) { return pipes::read_answer_line("1 " + time)->toi_as_written; };
  for (const char* time :
       {"0.5", "0x1p-1", "0x1.8000000000000p-2", "5e-1", "0", "-0.0", "inf", "nan", "1e999", "+0.25"}) {
    CAPTURE(time);
    CHECK(written(time).empty());
  }
  CHECK(written("0.1") == "0.1");
  CHECK(written("+0.1") == "0.1");
  CHECK(written("-0.1 \r") == "-0.1");
  CHECK(written("0.50000000000000000001") == "0.50000000000000000001");
  CHECK(written("1e-400") == "1e-400");
  // Closer to 0 than any time of a query of doubles.
  CHECK(written("3e-9999999999") == "1e-4000");
  CHECK(written("-0x1p-99999") == "-1e-4000");
}

TEST_CASE("answers that cannot be read") {
  for (const char* line :
       {"",        " ",    "2",      "01",    "-1",    "yes",     "0 0",   "0 0.5",         "1 0.5 0.5",
        "1 half",  "1 0x", "1 0.5x", "1 --5", "1 +-5", "1 0xnan", "1,0.5", "unsupported 1", "Unsupported",
        "1 0.5\n", "10.5", "1 nan(", "1 e5"}) {
    CAPTURE(line);
    CHECK_FALSE(pipes::read_answer_line(line));
  }
  CHECK_FALSE(pipes::read_answer_line(std::string_view("0\0", 2)));
  CHECK_FALSE(pipes::read_answer_line(std::string(100000, '1')));
}
