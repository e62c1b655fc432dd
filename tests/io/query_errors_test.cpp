// Damaged query files: each fault is named with its file, row and reason, whatever the chunk size.
// SPDX-License-Identifier: MIT
#include <sys/stat.h>

#include <array>
#include <string>

#include "io/input_file.hpp"
#include "io/queries/kind_of_file.hpp"
#include "io/queries/query_row.hpp"
#include "io/read_queries.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

const std::string kRow = "0,1,0,1,0,1,0\n";
const std::string kQuery = kRow + kRow + kRow + kRow;  // point-point

/// Reads point-point queries by chunks of several sizes; the queries before the error must be the same each time.
std::string error_of(const std::string& content, std::size_t queries_before) {
  std::string error;
  bool first = true;
  for (const std::size_t chunk :
       {std::size_t{1}, std::size_t{5}, std::size_t{4096}, io::kChunkBytes, content.size() + 1}) {
    if (content.size() / chunk > 100'000'000) continue;
    const ReadFile file = read_queries(content, Kind::point_point, chunk);
    CAPTURE(chunk, file.error);
    CHECK(file.queries.size() == queries_before);
    if (!first) CHECK(file.error == error);
    error = file.error;
    first = false;
  }
  return error;
}

/// The second query's second row, which is row 6, is replaced.
std::string error_of_row(const std::string& row) { return error_of(kQuery + kRow + row + "\n" + kRow + kRow, 1); }

std::string message_of(const std::exception& error) { return error.what(); }

}  // namespace

TEST_CASE("a file without a query is refused") {
  const std::string reason =
      "q.csv: holds no query; a row is a corner as fractions, with 7 columns: "
      "x_num,x_den,y_num,y_den,z_num,z_den,truth, "
      "or 6 without truth; a corner as decimals, x,y,z with 3, or 4 with truth; or a whole point-point query, with 12 "
      "decimals, and truth or not";
  CHECK(error_of("", 0) == reason);
  CHECK(error_of("\n\n", 0) == reason);
  CHECK(error_of("\xEF\xBB\xBF# nothing\r\n", 0) == reason);
}

TEST_CASE("a file that ends within a query is refused") {
  CHECK(error_of(kQuery + kRow, 1) ==
        "q.csv:5: the file ends within query 1, which has 1 row; a point-point query has 4");
  CHECK(error_of(kQuery + kRow + "# comment\n" + kRow + "\n", 1) ==
        "q.csv:8: the file ends within query 1, which has 2 rows; a point-point query has 4");
  CHECK(error_of(kQuery + kRow + kRow + "0,1,0", 1) ==
        "q.csv:7: 3 columns; a row has 7: x_num,x_den,y_num,y_den,z_num,z_den,truth, or 6 without truth");
  CHECK(error_of(kQuery + kRow + kRow + kRow + "0,1,0,1,0,1,", 1) ==
        "q.csv:8: truth is ''; it must be 0 or 1, true or false, or yes or no");
}

TEST_CASE("an edge-edge query has eight rows") {
  const ReadFile file = read_queries(kQuery, Kind::edge_edge, io::kChunkBytes);
  CHECK(file.error == "q.csv:4: the file ends within query 0, which has 4 rows; an edge-edge query has 8");
}

TEST_CASE("wrong column counts are refused") {
  const std::string columns = "; a row has 7: x_num,x_den,y_num,y_den,z_num,z_den,truth, or 6 without truth";
  CHECK(error_of_row("0,1,0,1,0") == "q.csv:6: 5 columns" + columns);
  CHECK(error_of_row("0,1,0,1,0,1,0,0") == "q.csv:6: 8 columns" + columns);
  CHECK(error_of_row("0,1,0,1,0,1,0,") == "q.csv:6: 8 columns" + columns);
  CHECK(error_of_row("0;1;0;1;0;1;0") == "q.csv:6: 1 column" + columns);
  CHECK(error_of_row("0") == "q.csv:6: 1 column" + columns);
}

TEST_CASE("a truth in some rows of a query alone is refused") {
  const auto error = [](const std::string& row, const std::string& here, const std::string& first) {
    return "q.csv:" + row + ": truth is " + here + " here and " + first +
           ", where the same query 1 starts; all 4 rows of a point-point query must agree";
  };
  CHECK(error_of_row("0,1,0,1,0,1") == error("6", "missing", "0 in row 5"));
  CHECK(error_of_row(" 0,1,0,1,0,1") == error("6", "missing", "0 in row 5"));
  const std::string bare = "0,1,0,1,0,1\n";
  CHECK(error_of(kQuery + bare + kRow + kRow + kRow, 1) == error("6", "0", "missing in row 5"));
  CHECK(error_of(kQuery + kRow + kRow + kRow + bare, 1) == error("8", "missing", "0 in row 5"));
  CHECK(error_of(kQuery + bare + bare + bare + bare, 2) == "");
}

TEST_CASE("text where a number belongs is refused") {
  const auto integer = [](const std::string& name, const std::string& text) {
    return "q.csv:6: " + name + " is " + text + "; it must be a decimal integer";
  };
  CHECK(error_of_row("abc,1,0,1,0,1,0") == integer("x_num", "'abc'"));
  CHECK(error_of_row("0,1,1.5,1,0,1,0") == integer("y_num", "'1.5'"));
  CHECK(error_of_row("0,1,0,1,0,1e3,0") == integer("z_den", "'1e3'"));
  CHECK(error_of_row("+1,1,0,1,0,1,0") == integer("x_num", "'+1'"));
  CHECK(error_of_row(",1,0,1,0,1,0") == integer("x_num", "''"));
  CHECK(error_of_row("0, ,0,1,0,1,0") == integer("x_den", "''"));
  CHECK(error_of_row("1 2,1,0,1,0,1,0") == integer("x_num", "'1 2'"));
  CHECK(error_of_row("-,1,0,1,0,1,0") == integer("x_num", "'-'"));
  CHECK(error_of_row("--1,1,0,1,0,1,0") == integer("x_num", "'--1'"));
  CHECK(error_of_row("nan,1,0,1,0,1,0") == integer("x_num", "'nan'"));
  CHECK(error_of_row("0x10,1,0,1,0,1,0") == integer("x_num", "'0x10'"));
  CHECK(error_of_row("\"1\",1,0,1,0,1,0") == integer("x_num", "'\"1\"'"));
  CHECK(error_of_row("\xC3\xBC\x1B,1,0,1,0,1,0") == integer("x_num", "'\\xc3\\xbc\\x1b'"));
  CHECK(error_of_row(std::string(50, 'a') + ",1,0,1,0,1,0") == integer("x_num", "'" + std::string(40, 'a') + "...'"));
  CHECK(error_of_row("0,1,0,1,0,1,0 # no comments here") ==
        "q.csv:6: truth is '0 # no comments here'; it must be 0 or 1, true or false, or yes or no");
}

TEST_CASE("denominators must be positive") {
  CHECK(error_of_row("0,0,0,1,0,1,0") == "q.csv:6: x_den is zero; a denominator must be positive");
  CHECK(error_of_row("0,1,0,-0,0,1,0") == "q.csv:6: y_den is zero; a denominator must be positive");
  CHECK(error_of_row("0,1,0,1,0,000,0") == "q.csv:6: z_den is zero; a denominator must be positive");
  CHECK(error_of_row("0,1,0,1,0,-2,0") == "q.csv:6: z_den is '-2'; a denominator must be positive");
}

TEST_CASE("truth is 0 or 1 and the same in all rows of a query") {
  for (const std::string text : {"2", "11", "1e-400", "truth", "inf"}) {
    CHECK(error_of_row("0,1,0,1,0,1," + text) ==
          "q.csv:6: truth is '" + text + "'; it must be 0 or 1, true or false, or yes or no");
  }
  CHECK(error_of_row("0,1,0,1,0,1,1") ==
        "q.csv:6: truth is 1 here and 0 in row 5, where the same query 1 starts; all 4 rows of a point-point query "
        "must agree");
  CHECK(error_of_row("1,3,0,1,0,1,1") ==  // a rational row, which is read by other code
        "q.csv:6: truth is 1 here and 0 in row 5, where the same query 1 starts; all 4 rows of a point-point query "
        "must agree");
}

TEST_CASE("zero bytes are refused wherever they stand") {
  using namespace std::string_literals;
  const std::string reason = "q.csv:6: a zero byte; this is no text file";
  CHECK(error_of_row("0,1,0\0,1,0,1,0"s) == reason);
  CHECK(error_of_row("0,1,0,1,0,1,0\0"s) == reason);
  CHECK(error_of_row("0,1,0,1,0,1,0\0\0\0\0"s) == reason);
  CHECK(error_of_row("\0"s) == reason);
  CHECK(error_of_row("# \0"s) == "q.csv:6: a zero byte; this is no text file");
  CHECK(error_of(kQuery + "0\0,\0"s, 1) == "q.csv:5: a zero byte; this is no text file");
}

TEST_CASE("what could exhaust memory is refused", "[slow]") {
  SECTION("digits") {
    const std::string most(io::kMostDigits, '1');
    const ReadFile file = read_queries(kRow + "-" + most + ",1,0,1,0,1,0\n" + kRow + kRow, Kind::point_point, 4096);
    CHECK(file.error == "");
    CHECK(error_of_row("-1" + most + ",1,0,1,0,1,0") == "q.csv:6: x_num has 4097 digits; at most 4096 are read");
    CHECK(error_of_row("1,1,0," + most + "1,0,1,0") == "q.csv:6: y_den has 4097 digits; at most 4096 are read");
  }
  SECTION("lines") {
    const std::string reason = "q.csv:6: the line is longer than 1048576 bytes";
    const std::string blanks(io::kLongestLine - kRow.size() + 1, ' ');
    CHECK(read_queries(kRow + blanks + kRow + kRow + kRow, Kind::point_point, 5000).error == "");
    CHECK(error_of(kQuery + kRow + " " + blanks + kRow + kRow + kRow, 1) == reason);
    CHECK(error_of(kQuery + kRow + "#" + std::string(io::kLongestLine, 'x'), 1) == reason);
    CHECK(error_of(kQuery + kRow + std::string(3 * io::kLongestLine, '1'), 1) == reason);
  }
  SECTION("comments within a query") {
    std::string comments;
    while (comments.size() <= io::kLongestQuery) comments += "#" + std::string(io::kLongestLine - 10, 'x') + "\n";
    const std::string reason = "q.csv:5: this query and the comments in it are longer than 16777216 bytes";
    CHECK(error_of(kQuery + kRow + comments + kRow + kRow + kRow, 1) == reason);
    CHECK(error_of(kQuery + kRow + comments, 1) == reason);
    CHECK(error_of(kQuery + kRow + comments + std::string(3 * io::kLongestLine, 'x'), 1) == reason);
  }
}

TEST_CASE("the first fault in the file is the one that is named") {
  CHECK(error_of(kQuery + "a,1,0,1,0,1,0\n" + kRow + kRow + kRow + "b,1,0,1,0,1,0\n" + kRow, 1) ==
        "q.csv:5: x_num is 'a'; it must be a decimal integer");
  CHECK(error_of(kQuery + "a,1,0,1,0,1,0\n" + kRow + kRow + kRow + std::string(2 * io::kLongestLine, '1'), 1) ==
        "q.csv:5: x_num is 'a'; it must be a decimal integer");
  CHECK(error_of(kQuery + kRow + kRow + kRow + "0,1,0,1,0,1,1\n" + kRow, 1).substr(0, 27) ==
        "q.csv:8: truth is 1 here an");
}

TEST_CASE("files that cannot be opened are refused, in one line") {
  const TemporaryFolder folder;
  const std::string missing = folder.path("no.csv");
  CHECK_THROWS_MATCHES(io::InputFile::open(missing), FileError,
                       Catch::Matchers::Predicate<FileError>([&](const FileError& e) {
                         return message_of(e) == missing + ": cannot be opened: No such file or directory";
                       }));
  CHECK_THROWS_AS(io::InputFile::check(missing), FileError);
  const std::string is_folder = folder.path("") + ": is a folder; name the files in it: " + folder.path("*");
  for (const auto& attempt : {+[](const std::string& path) { io::InputFile::open(path); },
                              +[](const std::string& path) { io::InputFile::check(path); }}) {
    CHECK_THROWS_MATCHES(
        attempt(folder.path("")), FileError,
        Catch::Matchers::Predicate<FileError>([&](const FileError& e) { return message_of(e) == is_folder; }));
  }
  try {
    io::InputFile::open("a\nb\x1B.csv");
    FAIL("opened");
  } catch (const FileError& error) {
    CHECK(message_of(error) == "a\\nb\\x1b.csv: cannot be opened: No such file or directory");
  }
}

TEST_CASE("a file's size is known, a pipe's is not") {
  const TemporaryFolder folder;
  CHECK(io::InputFile::check(folder.write("a.csv", "12345")) == 5u);
  const std::string pipe = folder.path("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_FALSE(io::InputFile::check(pipe).has_value());
}

TEST_CASE("a file's kind is its folder's name, or what the caller says") {
  CHECK(io::kind_of_file("data/edge-edge/a.csv", std::nullopt) == Kind::edge_edge);
  CHECK(io::kind_of_file("vertex-face/a.csv", std::nullopt) == Kind::vertex_face);
  CHECK(io::kind_of_file("/x/point-edge/./a.csv", std::nullopt) == Kind::point_edge);
  CHECK(io::kind_of_file("x/../point-point/a.csv", std::nullopt) == Kind::point_point);
  CHECK(io::kind_of_file("edge-edge/a.csv", Kind::point_point) == Kind::point_point);
  CHECK(io::kind_of_file("queries/227ee.csv", std::nullopt) == Kind::edge_edge);
  CHECK(io::kind_of_file("3036vf.csv", std::nullopt) == Kind::vertex_face);
  CHECK(io::kind_of_file("edge-edge/227vf.csv", std::nullopt) == Kind::edge_edge);
  for (const char* name :
       {"queries/ee.csv", "queries/a1ee.csv", "queries/1eee.csv", "queries/1ee.old.csv", "1ee/a.csv"}) {
    CHECK_FALSE(io::kind_of_path(name));
  }
  CHECK(from_name<Kind>("edge-edge") == Kind::edge_edge);
  CHECK_FALSE(from_name<Kind>("Edge-Edge"));
  CHECK_FALSE(from_name<Kind>(""));
  try {
    io::kind_of_file("edge-edge/old/a.csv", std::nullopt);
    FAIL("a kind was found");
  } catch (const FileError& error) {
    CHECK(message_of(error) ==
          "edge-edge/old/a.csv: of which kind are its queries? Its folder 'old' is not called edge-edge, vertex-face, "
          "point-edge or point-point, its name is not like 227ee.csv or 227vf.csv, and no kind was given (--kind)");
  }
}
