// Files of curved queries: what is written reads back bit for bit, for any size of chunks and any layout, and damaged
// files are refused with the line, the column and what would be right.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "io/queries/curved_rows.hpp"
#include "io/queries/separation_text.hpp"
#include "io/read_queries.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/curved_query.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::array<Kind, 4> kEveryKind = {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point};
const std::string kHeader = std::string(io::kCurvedHeader) + "\n";
const std::string kMotion = "motion,0,1,0,0,0,1,0,0,1,0,0,0,0,0,0\n";
/// A point-point query of four rows.
const std::string kGood = "query,0\n" + kMotion + "body,0,5,0,0\ncurve,1,2,3\n";

/// Any finite double: all exponents, both zeros.
double any_double(seeded::Rng& rng) {
  if (rng.one_in(5)) return rng.one_in(2) ? 0.0 : -0.0;
  return std::ldexp(rng.symmetric(), rng.between(-1074, 1023));
}

Vec3 any_vector(seeded::Rng& rng) {
  const double x = any_double(rng), y = any_double(rng), z = any_double(rng);
  return {x, y, z};
}

CurvedQuery any_query(Kind kind, seeded::Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  for (RigidMotion& motion : query.motions) {
    for (double& c : motion.q0) c = any_double(rng);
    motion.q0[static_cast<std::size_t>(rng.between(0, 3))] = 1;
    for (std::size_t i = 0; i < 4; ++i) motion.q1[i] = motion.q0[i] * rng.between(1, 2);
    motion.p0 = any_vector(rng);
    motion.p1 = any_vector(rng);
    for (double& c : motion.q1) {
      if (!std::isfinite(c)) c = 1;
    }
  }
  for (CurvedCorner& corner : query.corners) {
    corner.motion = rng.one_in(2) ? CurvedCorner::kOnCurve : rng.between(0, 3);
    if (corner.motion == CurvedCorner::kOnCurve) corner.control_points = rng.between(1, 4);
    for (Vec3& point : corner.points) point = any_vector(rng);
  }
  return query;
}

/// Rows as people lay them out: comments, blank lines, blanks around columns, CRLF, a byte order mark.
std::string decorated(const std::string& rows, seeded::Rng& rng) {
  std::string out = rng.one_in(2) ? "\xEF\xBB\xBF" : "";
  const std::string line_end = rng.one_in(2) ? "\r\n" : "\n";
  for (std::size_t start = 0; start < rows.size();) {
    const std::size_t end = rows.find('\n', start);
    std::string row = rows.substr(start, end - start);
    if (rng.one_in(4)) out += "# query,1: not a row" + line_end;
    if (rng.one_in(4)) out += std::string(static_cast<std::size_t>(rng.between(0, 2)), ' ') + line_end;
    if (rng.one_in(4)) row.insert(row.find(',') + 1, " \t");
    if (rng.one_in(8)) row = "  " + row + " ";
    out += row + line_end;
    start = end + 1;
  }
  return out + (rng.one_in(2) ? "# no end of line after this" : "");
}

std::string error_of(const std::string& content, std::size_t queries_before = 0, Kind kind = Kind::point_point) {
  std::string error;
  bool first = true;
  for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, std::size_t{4096}, io::kChunkBytes}) {
    if (content.size() / chunk > 10'000'000) continue;
    const ReadFile file = read_queries(content, kind, chunk, io::Motions::any);
    CAPTURE(chunk, file.error);
    CHECK(file.queries.size() == queries_before);
    if (!first) CHECK(file.error == error);
    error = file.error;
    first = false;
  }
  return error;
}

/// A good query, and one whose rows are these.
std::string error_of_rows(const std::string& rows) { return error_of(kHeader + kGood + rows, 1); }

}  // namespace

TEST_CASE("curved queries survive a round trip through a file, at any chunk size") {
  constexpr std::uint64_t kSeed = 20261123;
  CAPTURE(kSeed);
  seeded::Rng rng(kSeed);
  for (const Kind kind : kEveryKind) {
    std::string plain = kHeader;
    std::vector<CurvedQuery> queries;
    std::vector<bool> truths;
    for (int i = 0; i < 40; ++i) {
      queries.push_back(any_query(kind, rng));
      truths.push_back(rng.one_in(2));
      io::append_query(plain, queries.back(), truths.back());
    }
    for (const std::string& text : {plain, decorated(plain, rng), decorated(plain, rng)}) {
      for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, std::size_t{1000}, io::kChunkBytes}) {
        const ReadFile file = read_queries(text, kind, chunk, io::Motions::any);
        CAPTURE(name_of(kind), chunk, file.error);
        REQUIRE(file.error == "");
        REQUIRE(file.queries.size() == queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i) {
          const ReadQuery& read = file.queries[i];
          CAPTURE(i);
          REQUIRE(std::holds_alternative<CurvedQuery>(read.query));
          CHECK(same(std::get<CurvedQuery>(read.query), queries[i]));
          CHECK(read.truth == truths[i]);
          CHECK(read.number == i);
          CHECK(read.first_row < read.last_row);
          CHECK(read.text.substr(read.text.find_first_not_of(' '), 6) == "query,");
        }
      }
    }
  }
}

TEST_CASE("decimals are the nearest doubles, and rows are counted as lines") {
  const ReadFile file = read_queries("# first\n\n" + kHeader + "# second\nquery,1\ncurve,0.1,-2.5e-1,0x1.8p-2\n\n" +
                                         "curve,1,2,3,4,5,6,7,8,9\n" + kGood,
                                     Kind::point_point, 64, io::Motions::any);
  REQUIRE(file.error == "");
  REQUIRE(file.queries.size() == 2);
  const auto& query = std::get<CurvedQuery>(file.queries[0].query);
  CHECK(same(query.corners[0].points[0], {0.1, -0.25, 0.375}));
  CHECK(query.corners[0].control_points == 1);
  CHECK(query.corners[1].control_points == 3);
  CHECK(same(query.corners[1].points[2], {7, 8, 9}));
  CHECK(file.queries[0].truth == true);
  CHECK(file.queries[0].first_row == 5);
  CHECK(file.queries[0].last_row == 8);
  CHECK(file.queries[1].first_row == 9);
  CHECK(file.queries[1].last_row == 12);
}

TEST_CASE("a file of curved queries is known by its first row, and is not read as straight ones") {
  CHECK(io::holds_curved_queries("# a comment\n\n " + kHeader + kGood));
  CHECK(io::holds_curved_queries("\xEF\xBB\xBF" + kHeader));
  CHECK_FALSE(io::holds_curved_queries("# touchstone-curved,1\n0,1,0,1,0,1,1\n"));
  CHECK_FALSE(io::holds_curved_queries("query,1\n" + kHeader));
  CHECK_FALSE(io::holds_curved_queries(""));
  for (const std::size_t chunk : {std::size_t{1}, io::kChunkBytes}) {
    const ReadFile file = read_queries("# a comment\n" + kHeader + kGood, Kind::point_point, chunk);
    CHECK(file.queries.empty());
    CHECK(file.error ==
          "q.csv:2: the queries of this file have curved motion, which is not read here; solve, certify, explain, "
          "judge, prove, fuzz, bench and report read it");
  }
  const std::string straight = "0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n";
  CHECK(read_queries(straight, Kind::point_point, 5, io::Motions::any).error == "");
  CHECK(error_of(straight + kHeader + kGood, 1) ==
        "q.csv:5: 2 columns; a row has 7: x_num,x_den,y_num,y_den,z_num,z_den,truth, or 6 without truth");
  CHECK(error_of("touchstone-curved,2\n" + kGood) ==
        "q.csv:1: the version of this file of curved queries is '2'; version 1 is read, whose row is "
        "touchstone-curved,1");
  CHECK(error_of("touchstone-curved\n" + kGood) ==
        "q.csv:1: the version of this file of curved queries is ''; version 1 is read, whose row is "
        "touchstone-curved,1");
  const auto separation = io::separation_of_comments(kHeader + "# separation 0x1p-3 euclidean\n" + kGood);
  REQUIRE(separation.has_value());
  CHECK(separation->distance == 0.125);
}

TEST_CASE("missing rows and rows too many are refused") {
  CHECK(error_of(kHeader) == "q.csv: holds no query; a query starts with a row query,truth");
  CHECK(error_of(kHeader + kGood + "query,1\n", 1) ==
        "q.csv:6: the query ends here with 0 corners; a point-point query has 2: p q");
  CHECK(error_of(kHeader + kGood + "query,1\ncurve,1,2,3\n# comment\n\n", 1) ==
        "q.csv:7: the query ends here with 1 corner; a point-point query has 2: p q");
  CHECK(error_of(kHeader + "query,1\ncurve,1,2,3\n" + kGood) ==
        "q.csv:3: the query ends here with 1 corner; a point-point query has 2: p q");
  CHECK(
      error_of(kHeader + kGood + "curve,1,2,3\n") ==
      "q.csv:6: one corner too many; a point-point query has 2: p q, and the next query starts with a row query,truth");
  CHECK(error_of(kHeader + "curve,1,2,3\n" + kGood) ==
        "q.csv:2: column 1 is 'curve'; a query starts with a row query,truth");
  CHECK(error_of(kHeader + kGood, 0, Kind::edge_edge) ==
        "q.csv:5: the query ends here with 2 corners; an edge-edge query has 4: a0 a1 b0 b1");
  CHECK(error_of(kHeader + kHeader + kGood) ==
        "q.csv:2: column 1 is 'touchstone-curved'; a query starts with a row query,truth");
  CHECK(error_of_rows("query,1\n0,1,0,1,0,1,0\n") ==
        "q.csv:7: column 1 is '0'; it must be query, motion, body or curve");
}

TEST_CASE("a file that is cut off is refused, wherever") {
  const std::string text = kHeader + kGood + "query,1\ncurve,0.25,1,2\ncurve,1,2,3.5\n";
  CHECK(read_queries(text, Kind::point_point, 64, io::Motions::any).queries.size() == 2);
  CHECK(error_of(text.substr(0, text.size() - 1), 1) ==
        "q.csv:8: the last row does not end with an end of line, so that the file may be cut off here");
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    if (size == kHeader.size() + kGood.size()) continue;
    INFO("cut after " << size << " bytes");
    CHECK(read_queries(text.substr(0, size), Kind::point_point, 64, io::Motions::any).error != "");
  }
}

TEST_CASE("numbers that are none, or no finite doubles, are refused with their column") {
  const std::string advice = "; it must be a decimal or a hexfloat, such as 0.25 or 0x1p-2";
  const auto number = [&](const std::string& text) {
    return error_of_rows("query,1\ncurve,1," + text + ",3\ncurve,1,2,3\n");
  };
  const auto none = [&](const std::string& shown) {
    return "q.csv:7: column 3 (y of control point 0) is " + shown + ", which is no finite number" + advice;
  };
  for (const std::string text :
       {"nan", "inf", "-inf", "infinity", "", "abc", "1.2.3", "+1", "1e", "0x", "1 2", "--1"}) {
    CHECK(number(text) == none("'" + text + "'"));
  }
  CHECK(number("1e999") ==
        "q.csv:7: column 3 (y of control point 0) is '1e999', which is beyond the greatest double" + advice);
  CHECK(number("0x1p-2000") ==
        "q.csv:7: column 3 (y of control point 0) is '0x1p-2000', which is closer to 0 than any "
        "double that is not 0" +
            advice);
  CHECK(number(std::string(5000, '1')) ==
        "q.csv:7: column 3 (y of control point 0) has 5000 characters; at most 4096 are read");
  CHECK(error_of_rows("query,1\nmotion,0,1,0,0,0,1,0,0,nan,0,0,0,0,0,0\n") ==
        "q.csv:7: column 10 (q1_z) is 'nan', which is no finite number" + advice);
  CHECK(error_of_rows("query,1\n" + kMotion + "body,0,1,2,x\n") ==
        "q.csv:8: column 5 (z) is 'x', which is no finite number" + advice);
  using namespace std::string_literals;
  CHECK(error_of_rows("query,1\ncurve,1,\0,3\n"s) == "q.csv:7: a zero byte; this is no text file");
  // The query before may go on after the comment, so it is not handed out.
  CHECK(error_of(kHeader + kGood + "# \0\n"s) == "q.csv:6: a zero byte; this is no text file");
}

TEST_CASE("wrong columns, indices and motions are refused") {
  CHECK(error_of_rows("query\n") == "q.csv:6: 1 column; this row has 2: query,truth");
  CHECK(error_of_rows("query,2\n") == "q.csv:6: column 2 (truth) is '2'; it must be 0 or 1");
  CHECK(error_of_rows("query,1\nbody,0,1,2,3\n") ==
        "q.csv:7: column 2 (index) is 0, but the query has no motion 0; a row motion,0,... must come before");
  CHECK(error_of_rows("query,1\n" + kMotion + "body,4,1,2,3\n") ==
        "q.csv:8: column 2 (index) is '4'; the motions of a query are numbered 0 to 3");
  for (const std::string index : {"-1", "00", "99999999999999999999", "1.0", ""}) {
    CHECK(error_of_rows("query,1\nmotion," + index + ",1,0,0,0,1,0,0,1,0,0,0,0,0,0\n") ==
          "q.csv:7: column 2 (index) is '" + index + "'; the motions of a query are numbered 0 to 3");
  }
  CHECK(error_of_rows("query,1\n" + kMotion + kMotion) ==
        "q.csv:8: column 2 (index) is 0 for the second time in this query; row 7 gives motion 0");
  CHECK(error_of_rows("query,1\n" + kMotion + "curve,1,2,3\ncurve,1,2,3\n") ==
        "q.csv:7: no corner of the query is on motion 0; leave this row out, or give a corner as body,0,x,y,z");
  CHECK(error_of_rows("query,1\nmotion,0,1,0,0,0,1,0,0,1,0,0,0,0,0\n") ==
        "q.csv:7: 15 columns; this row has 16: "
        "motion,index,q0_w,q0_x,q0_y,q0_z,q1_w,q1_x,q1_y,q1_z,p0_x,p0_y,p0_z,p1_x,p1_y,p1_z");
  CHECK(error_of_rows("query,1\n" + kMotion + "body,0,1,2,3,4\n") ==
        "q.csv:8: 6 columns; this row has 5: body,index,x,y,z");
  for (const int columns : {1, 2, 3, 5, 6, 8, 9, 11, 12, 14, 16, 100000}) {
    std::string row = "curve";
    for (int i = 1; i < columns; ++i) row += ",1";
    CHECK(error_of_rows("query,1\n" + row + "\n") ==
          "q.csv:7: " + std::to_string(columns) + (columns == 1 ? " column" : " columns") +
              "; a curve has 4, 7, 10 or 13, with 1 to 4 control points: curve,x,y,z and three columns more for each "
              "further control point");
  }
}

TEST_CASE("a quaternion that is zero at an end or between is refused") {
  const auto motion = [](const std::string& q0, const std::string& q1) {
    return error_of_rows("query,1\nmotion,0," + q0 + "," + q1 + ",0,0,0,0,0,0\nbody,0,1,2,3\n");
  };
  CHECK(motion("0,0,0,-0", "1,0,0,0") ==
        "q.csv:7: the quaternion in columns 3 to 6 is zero; an orientation needs a component that is not 0");
  CHECK(motion("1,0,0,0", "0,0,0,0") ==
        "q.csv:7: the quaternion in columns 7 to 10 is zero; an orientation needs a component that is not 0");
  CHECK(motion("1,0,-2,0", "-3,0,6,0") ==
        "q.csv:7: columns 7 to 10 (q1) are columns 3 to 6 (q0) times a negative number, so that (1 - t) q0 + t q1 is "
        "zero near t = 0.25; change the sign of all components of q1: the orientation at t = 1 stays the same");
  // The next double is no multiple.
  const ReadFile near = read_queries(
      kHeader + "query,1\nmotion,0,1,0,-2,0,-3,0,0x1.8000000000001p+2,0,0,0,0,0,0,0\nbody,0,1,2,3\ncurve,0,0,0\n",
      Kind::point_point, 64, io::Motions::any);
  CHECK(near.error == "");
}

TEST_CASE("longer turns are counted, and the shorter ones are of the same poses") {
  const std::string text = kHeader + "query,1\nmotion,0,1,0,0,0,-1,0,0,-2,0,0,0,0,0,0\nbody,0,1,2,3\ncurve,0,0,0\n" +
                           "query,1\nmotion,1,1,0,0,0,1,0,0,-2,0,0,0,0,0,0\nbody,1,1,2,3\ncurve,0,0,0\n" +
                           "query,1\nmotion,3,1,0,-2,0,-3,0,6,0,0,0,0,0,0,0\nbody,3,1,2,3\ncurve,0,0,0\n";
  io::QueryChunkReader reader(io::InputFile::from_memory("q.csv", text), Kind::point_point, 1 << 16, io::Motions::any);
  const auto chunk = reader.next();
  REQUIRE(chunk);
  io::QueryParser parser(*chunk, io::Turns::shorter);
  io::QueryRecord record;
  std::vector<std::uint64_t> counts;
  io::LongerTurns all;
  std::vector<CurvedQuery> queries;
  while (parser.next(record)) {
    counts.push_back(record.longer_turns.count);
    all.merge(record.longer_turns);
    queries.push_back(std::get<CurvedQuery>(record.query));
  }
  CHECK(counts == std::vector<std::uint64_t>{1, 0, 1});
  CHECK(all.count == 2);
  CHECK(all.first_row == static_cast<std::uint64_t>(std::count(kHeader.begin(), kHeader.end(), '\n')) + 2);
  REQUIRE(queries.size() == 3);
  CHECK(queries[0].motions[0].q1 == std::array<double, 4>{1, 0, 0, 2});
  CHECK(queries[1].motions[1].q1 == std::array<double, 4>{1, 0, 0, -2});
  // As it is given, this one is refused.
  CHECK(queries[2].motions[3].q1 == std::array<double, 4>{3, 0, -6, 0});
}

TEST_CASE("what could exhaust memory in a file of curved queries is refused") {
  CHECK(error_of_rows("query,1\ncurve,1,2,3" + std::string(io::kLongestLine, ' ') + "\n") ==
        "q.csv:7: the line is longer than 1048576 bytes");
  std::string comments;
  while (comments.size() <= io::kLongestQuery) comments += "#" + std::string(io::kLongestLine - 10, 'x') + "\n";
  CHECK(error_of(kHeader + kGood + "query,1\n" + comments + "curve,1,2,3\n", 1) ==
        "q.csv:6: this query and the comments in it are longer than 16777216 bytes");
}
