// Tables as spreadsheets and other programs write them: separators that are no commas, quoted fields, words for truth.
// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <vector>

#include "io/answers/answer_reader.hpp"
#include "io/read_queries.hpp"
#include "io/separators.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// `text` with `separator` in place of each comma.
std::string with(std::string text, const std::string& separator) {
  for (std::size_t at = 0; (at = text.find(',', at)) != std::string::npos; at += separator.size()) {
    text.replace(at, 1, separator);
  }
  return text;
}

/// `text` with each field of its lines in quotes.
std::string quoted(const std::string& text) {
  std::string all;
  for (const char c : text) all += c == ',' ? std::string("\",\"") : c == '\n' ? std::string("\"\n\"") : std::string{c};
  return "\"" + all.substr(0, all.size() - 1);
}

ReadFile read_all(const std::string& text, io::Motions motions = io::Motions::straight) {
  const ReadFile whole = read_queries(text, Kind::point_point, io::kChunkBytes, motions);
  const ReadFile pieces = read_queries(text, Kind::point_point, 1, motions);
  CHECK(pieces.error == whole.error);
  CHECK(pieces.queries.size() == whole.queries.size());
  return whole;
}

}  // namespace

TEST_CASE("the first row of a table tells its separator") {
  CHECK(io::separator_of("0,1,0.5") == ',');
  CHECK(io::separator_of("0; 1; 0.5\r") == ';');
  CHECK(io::separator_of("0,5;1,0") == ';');
  CHECK(io::separator_of("1\t") == ',');  // a tab at the end separates nothing
  CHECK(io::separator_of("0\t1 ms") == '\t');
  CHECK(io::separator_of("  0  1 \r") == ' ');
  CHECK(io::separator_of("\"a;b\",\"c\"") == ',');
  CHECK(io::separator_of("1") == ',');
}

TEST_CASE("queries are the same whatever stands between their numbers, and in quotes") {
  const std::vector<std::string> files = {
      "0.5,1,0,1\n0.25,0,-1e-3,1\n0,1,0x1p-2,1\n1,1,1,1\n",
      "x,y,z,truth\n0.5,1,0,0\n0.25,0,1,0\n0,1,0,0\n1,1,1,0\n",
      "1,2,0,1,0,3,1\n1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n",
      "0,1,2,3,4,5,6,7,8,9,10,12\n0,1,2,3,4,5,6,7,8,9,10,11\n",
      "touchstone-curved,1\nquery,1\ncurve,1,2,3\ncurve,1,2,3,4,5,6\n",
  };
  for (const std::string& text : files) {
    const ReadFile expected = read_all(text, io::Motions::any);
    CAPTURE(text);
    REQUIRE(expected.error == "");
    std::string windows = with(text, ";");
    for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) windows.insert(at, "\r");
    for (const std::string& same_file :
         {with(text, ";"), with(text, "\t"), with(text, " "), with(text, "   "), with(text, " ;\t"), windows,
          quoted(text), with(quoted(text), ";"), with(quoted(text), "\t"), with(quoted(text), "  ")}) {
      CAPTURE(same_file);
      const ReadFile file = read_all(same_file, io::Motions::any);
      REQUIRE(file.error == "");
      REQUIRE(file.queries.size() == expected.queries.size());
      for (std::size_t i = 0; i < file.queries.size(); ++i) {
        const ReadQuery &a = file.queries[i], &b = expected.queries[i];
        REQUIRE(a.query.index() == b.query.index());
        if (const auto* const query = std::get_if<Query>(&a.query)) REQUIRE(same(*query, std::get<Query>(b.query)));
        if (const auto* const query = std::get_if<RationalQuery>(&a.query)) {
          REQUIRE(same(*query, std::get<RationalQuery>(b.query)));
        }
        if (const auto* const query = std::get_if<CurvedQuery>(&a.query)) {
          REQUIRE(same(query->corners[1].points[1], Vec3{4, 5, 6}));
        }
        REQUIRE(a.truth == b.truth);
        REQUIRE(a.first_row == b.first_row);
      }
    }
  }
  // pandas quotes the names alone, with csv.QUOTE_NONNUMERIC.
  CHECK(read_all("\"x\",\"y\",\"z\"\n1,2,3\n1,2,3\n1,2,3\n1,2,3\n").queries.size() == 1);
}

TEST_CASE("a decimal comma and broken quotes are named, and never read as something else") {
  const std::string comma = "; a number has a point, such as 0.5, and no comma";
  CHECK(read_all("0,5;1,0;2\n").error == "q.csv:1: column 1 is '0,5'" + comma);
  CHECK(read_all("1;2;3\n0;1,5;2\n").error == "q.csv:2: column 2 is '1,5'" + comma);
  CHECK(read_all("\"0,5\",\"1,0\",\"2,5\"\n").error == "q.csv:1: column 1 is '0,5'" + comma);
  CHECK(read_all("0,5\t1,0\t2\n").error == "q.csv:1: y is '5\\t1'; it must be a number such as -0.25, 1e-3 or 0x1p-2");
  CHECK(read_all("1\t\t2\t3\n").error == "q.csv:1: y is ''; it must be a number such as -0.25, 1e-3 or 0x1p-2");
  CHECK(read_all("1;2;3;\n").error == "q.csv:1: truth is ''; it must be 0 or 1, true or false, or yes or no");
  CHECK(read_all("\"1\",\"2,3\n").error == "q.csv:1: column 2 has a quote that is not closed");
  CHECK(read_all("\"1\"2,2,3\n").error == "q.csv:1: column 1 has text after a closing quote");
  CHECK(read_all("1\",2,\"3\"\n").error == "q.csv:1: column 1 has a quote, and does not start with one");
  CHECK(read_all("1 2 3\n1\t2\t3\n").error == "q.csv:2: 1 column; the first row has 3 decimals, x,y,z and no truth");
}

TEST_CASE("a truth may be a word, or 1.0 among decimals") {
  for (const std::string word : {"True", "true", "TRUE", "1.0", "1.000000000000000000e+00", "yes"}) {
    std::string corners, fractions, whole = "0,1,2,3,4,5,6,7,8,9,10,11," + word + "\n";
    for (int i = 0; i < 4; ++i) {
      corners += "1,2,3," + word + "\n";
      fractions += "1,2,3,1,0,1," + word + "\n";
    }
    for (const std::string& text : {corners, fractions, whole}) {
      const ReadFile file = read_all(text);
      CAPTURE(text);
      REQUIRE(file.error == "");
      CHECK(file.queries.at(0).truth == true);
    }
  }
  CHECK(read_all("1,2,3,False\n1,2,3,0\n1,2,3,0.0\n1,2,3,no\n").queries.at(0).truth == false);
  CHECK(read_all("1,2,3,True\n1,2,3,False\n").error.starts_with("q.csv:2: truth is 0 here and 1 in row 1"));
}

TEST_CASE("claims are the same whatever stands between their columns") {
  const std::string table = "query,contact,toi\n0,1,0.5\n1,False,-1\n2.0,1.000e+00,0.25\n";
  for (const std::string& text : {table, with(table, ";"), with(table, "\t"), with(table, " "), with(table, "  \t "),
                                  quoted(table), with(quoted(table), ";"), with(quoted(table), "\t"),
                                  with(quoted(table), "   "), table.substr(table.find('\n') + 1)}) {
    for (const std::size_t chunk : {std::size_t{1}, io::kChunkBytes}) {
      CAPTURE(text, chunk);
      io::AnswerReader reader(io::InputFile::from_memory("a.csv", text), {}, chunk);
      io::AnswerRow row;
      for (std::uint64_t i = 0; i < 3; ++i) {
        REQUIRE(reader.next(row));
        CHECK(row.query == i);
        CHECK(row.contact == (i != 1));
        CHECK(row.toi == (i == 0 ? std::optional(0.5) : i == 2 ? std::optional(0.25) : std::nullopt));
      }
      CHECK_FALSE(reader.next(row));
    }
  }
  const auto last_error = [](const std::string& text) {
    try {
      io::AnswerReader reader(io::InputFile::from_memory("a.csv", text));
      for (io::AnswerRow row; reader.next(row);) {
      }
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(last_error("query;contact;toi\n0;1;0,5\n").starts_with("a.csv:2: toi is '0,5'; of a contact it must be"));
  CHECK(last_error("query\tcontact\ttoi\n0\t1\t\n1\t\t0.5\n").starts_with("a.csv:3: contact is ''; it must be"));
  CHECK(last_error("is colliding\n1\n") == "");
  CHECK(last_error("id hit\n0.5 1\n") == "a.csv:2: query is '0.5'; it must be a number counted from 0");
}
