// answers.csv: rows as they are written, and as claims are read from them.
// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "io/answers/answer_reader.hpp"
#include "io/answers/answer_writer.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;

namespace {

constexpr std::array<std::size_t, 4> kChunks = {1, 3, 100, io::kChunkBytes};

constexpr std::uint64_t kNone = ~std::uint64_t{0};

struct ReadRow {
  std::string file;
  bool has_file;
  std::uint64_t query;
  bool contact;
  std::optional<double> toi;
  std::uint64_t row;
};

struct ReadAnswers {
  std::vector<ReadRow> rows;
  std::string error;
};

ReadAnswers read(std::string_view content, std::size_t chunk) {
  ReadAnswers result;
  try {
    io::AnswerReader reader(io::InputFile::from_memory("a.csv", content), {}, chunk);
    io::AnswerRow row;
    while (reader.next(row)) {
      result.rows.push_back({std::string(row.file.value_or("")), row.file.has_value(), row.query.value_or(kNone),
                             row.contact, row.toi, row.row});
    }
  } catch (const FileError& error) {
    result.error = error.what();
  }
  return result;
}

std::string error_of(std::string_view content) {
  const std::string error = read(content, kChunks[0]).error;
  for (const std::size_t chunk : kChunks) CHECK(read(content, chunk).error == error);
  return error;
}

}  // namespace

TEST_CASE("an answer is one row, empty where there is nothing to say") {
  Answer answer;
  answer.contact = true;
  answer.level = Level::exact;
  answer.nature = Nature::grazing;
  answer.feature_a = Feature::a0;
  answer.feature_b = Feature::b;
  answer.toi = 0.375;
  answer.toi_upper = 0x1.8000000000001p-2;
  std::string text(io::kAnswerHeader);
  io::append_answer(text, "x.csv", 12, answer, io::Numbers::hexfloats);
  io::append_answer(text, "x.csv", 13, answer, io::Numbers::decimals);
  Answer none;
  none.level = Level::filter;
  io::append_answer(text, io::csv_field("a,\"b\".csv"), 14, none, io::Numbers::decimals);
  CHECK(text ==
        "file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level\n"
        "x.csv,12,1,0x1.8p-2,0x1.8000000000001p-2,grazing,a0,b,exact\n"
        "x.csv,13,1,0.375,0.37500000000000006,grazing,a0,b,exact\n"
        "\"a,\"\"b\"\".csv\",14,0,,,,,,filter\n");
}

TEST_CASE("a field that a spreadsheet would run has an apostrophe before it") {
  for (const char* const plain : {"", "a=1", "edge-edge/a.csv", "'", "'a", "1"}) CHECK(io::csv_field(plain) == plain);
  CHECK(io::csv_field("=1+1") == "'=1+1");
  CHECK(io::csv_field("+1") == "'+1");
  CHECK(io::csv_field("-x") == "'-x");
  CHECK(io::csv_field("@x") == "'@x");
  CHECK(io::csv_field("\t=") == "\"'\t=\"");
  CHECK(io::csv_field(" =1") == "\" =1\"");  // readers take blanks away
  CHECK(io::csv_field("\r=") == "\"'\r=\"");
  CHECK(io::csv_field("=HYPERLINK(\"a\",1)") == "\"'=HYPERLINK(\"\"a\"\",1)\"");
  CHECK(io::csv_field("'=1") == "''=1");  // so that a reader can take it away
}

TEST_CASE("written answers are read back as claims, whatever the files are called") {
  const std::array<std::string, 13> names = {
      "edge-edge/a.csv", "",     "with, comma", "\"quoted\"", "line\nend", "cr\r\nlf", "\"",
      " blank ",         "=1+1", "'=1+1",       "''-a",       "'a",        "@\"b\""};
  constexpr std::uint64_t kSeed = 11;
  CAPTURE(kSeed);
  tests::Rng rng(kSeed);
  std::string text(io::kAnswerHeader);
  std::vector<ReadRow> expected;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const std::string& name = rng.pick(names);
    Answer answer;
    answer.contact = rng.one_in(2);
    if (answer.contact) answer.toi = answer.toi_upper = rng.unit();
    io::append_answer(text, io::csv_field(name), i, answer,
                      i % 2 == 0 ? io::Numbers::decimals : io::Numbers::hexfloats);
    expected.push_back({name, true, i, answer.contact, std::nullopt, 0});
    if (answer.contact) expected.back().toi = answer.toi;
  }
  for (const std::size_t chunk : kChunks) {
    CAPTURE(chunk);
    const ReadAnswers answers = read(text, chunk);
    REQUIRE(answers.error == "");
    REQUIRE(answers.rows.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      REQUIRE(answers.rows[i].file == expected[i].file);
      REQUIRE(answers.rows[i].query == expected[i].query);
      REQUIRE(answers.rows[i].contact == expected[i].contact);
      REQUIRE(answers.rows[i].toi == expected[i].toi);
    }
  }
}

TEST_CASE("only contact is needed, in any order and layout") {
  for (const std::size_t chunk : kChunks) {
    const ReadAnswers answers = read(
        "\xEF\xBB\xBF"
        "contact,query\r\n1,0\r\n\r\n0,1\r\n\n1,2",
        chunk);
    REQUIRE(answers.error == "");
    REQUIRE(answers.rows.size() == 3);
    CHECK(answers.rows[0].contact);
    CHECK_FALSE(answers.rows[1].contact);
    CHECK_FALSE(answers.rows[0].has_file);
    CHECK_FALSE(answers.rows[0].toi);
    CHECK(answers.rows[2].query == 2);
    CHECK(answers.rows[0].row == 2);
    CHECK(answers.rows[1].row == 4);
    CHECK(answers.rows[2].row == 6);
  }
  const ReadAnswers decimal = read("query,toi,contact,level,nature\n7,0.375,1,mine,\"whatever, it is skipped\"\n", 10);
  REQUIRE(decimal.error == "");
  CHECK(decimal.rows.at(0).toi == 0.375);
}

TEST_CASE("a time is handed on as it is written when it may be no double") {
  const auto written = [](const std::string& toi) {
    std::string text;
    double nearest = 0;
    io::AnswerReader reader(io::InputFile::from_memory("a.csv", "query,contact,toi\n0,1," + toi + "\n1,0,\n"));
    io::AnswerRow row;
    REQUIRE(reader.next(row));
    text = row.toi_as_written;
    nearest = row.toi.value();
    REQUIRE(reader.next(row));
    CHECK(row.toi_as_written.empty());
    return std::pair(text, nearest);
  };
  using Written = std::pair<std::string, double>;
  CHECK(written("0x1.8p-2") == Written("", 0.375));
  CHECK(written("0x0p+0") == Written("", 0.0));
  CHECK(written("-0x1.fffffffffffffp-1") == Written("", -0x1.fffffffffffffp-1));
  CHECK(written("0.1") == Written("0.1", 0.1));
  CHECK(written("0.50000000000000000001") == Written("0.50000000000000000001", 0.5));
  CHECK(written("0x1.00000000000008p-1") == Written("0x1.00000000000008p-1", 0.5));
  CHECK(written("1e-400") == Written("1e-400", 0.0));
  CHECK(written("-1e-400") == Written("-1e-400", 0.0));
}

TEST_CASE("a row in quotes that spans lines counts them") {
  const ReadAnswers answers = read("file,query,contact\n\"a\nb\",0,1\n\"a\nb\",1,2\n", 7);
  REQUIRE(answers.rows.size() == 1);
  CHECK(answers.rows[0].file == "a\nb");
  CHECK(answers.rows[0].row == 2);
  CHECK(answers.error == "a.csv:4: contact is '2'; it must be 0 or 1, true or false, or yes or no");
}

TEST_CASE("faults of a claims file are named with file, row and reason", "[slow]") {
  CHECK(error_of("") == "a.csv: is empty; its first line may name the columns, for example query,contact,toi");
  CHECK(error_of("query,contact,query\n") == "a.csv:1: two columns are a 'query'; --columns says which one is read");
  CHECK(error_of("query,ns\n0,1\n")
            .starts_with("a.csv:1: no column is a 'contact' or a 'toi'; known names are file (or filename"));
  CHECK(error_of("0,1\n1,1\n") ==
        "a.csv:1: no names of columns; --columns says what they are, for example --columns contact,toi or "
        "query,contact");
  CHECK(error_of("metric,contact\nmax,1\n") == "a.csv:1: column 'metric' needs column 'separation'");

  const std::string head = "query,contact,toi\n0,0,\n";
  CHECK(error_of(head + "1,0\n") == "a.csv:3: 2 columns where the first line has 3");
  CHECK(error_of(head + "1,0,,\n") == "a.csv:3: 4 columns where the first line has 3");
  CHECK(error_of(head + "x,0,\n") == "a.csv:3: query is 'x'; it must be a number counted from 0");
  CHECK(error_of(head + "-1,0,\n") == "a.csv:3: query is '-1'; it must be a number counted from 0");
  CHECK(error_of(head + "1.0,0,\n") == "");
  CHECK(error_of(head + "99999999999999999999,0,\n").substr(0, 18) == "a.csv:3: query is ");
  CHECK(error_of(head + "1,on,\n") == "a.csv:3: contact is 'on'; it must be 0 or 1, true or false, or yes or no");
  CHECK(error_of(head + "1, 1 1,\n").substr(0, 27) == "a.csv:3: contact is '1 1'; ");
  const std::string digits(10'000, '1');
  CHECK(error_of(head + "1,1,0." + digits + "\n") == "a.csv:3: toi has 10002 characters; at most 4096 are read");
  CHECK(error_of(head + "1,1,1e-5000\n") == "a.csv:3: toi is '1e-5000'; as a fraction it has more than 4096 digits");
  CHECK(error_of(head + "1,1,1" + digits + "\n") ==
        "a.csv:3: toi is '1111111111111111111111111111111111111111...'; it is beyond the greatest double");
  CHECK(error_of(head + "1,1,x" + digits + "\n").size() < 200);
  const std::string finite = "; of a contact it must be a finite number such as 0x1.8p-2 or 0.375, or empty";
  CHECK(error_of(head + "1,1,nan\n") == "a.csv:3: toi is 'nan'" + finite);
  CHECK(error_of(head + "1,1,inf\n") == "a.csv:3: toi is 'inf'" + finite);
  CHECK(error_of(head + "1,1,-inf\n") == "a.csv:3: toi is '-inf'" + finite);
  CHECK(error_of(head + "1,1,1e400\n") == "a.csv:3: toi is '1e400'; it is beyond the greatest double");
  CHECK(error_of(head + "1,0,soon\n") == "");  // without contact it is not read
}

TEST_CASE("broken quotes, zero bytes and endless rows of a claims file are refused") {
  using namespace std::string_literals;
  const std::string head = "file,query,contact\n";
  CHECK(error_of(head + "\"a\"b,0,1\n") == "a.csv:2: text after a closing quote");
  CHECK(error_of(head + "a\"b\",0,1\n") == "a.csv:2: a quote inside a field that does not start with one");
  CHECK(error_of(head + "\"a,0,1\nb,1,1\n") == "a.csv:2: the file ends inside quotes");
  CHECK(error_of(head + "a\0,0,1\n"s) == "a.csv:2: a zero byte; this is no text file");
  const std::string longest(io::kLongestLine + 1, 'x');
  CHECK(read(head + longest, io::kChunkBytes).error == "a.csv:2: the row is longer than 1048576 bytes");
  CHECK(read(head + "\"\n" + longest, io::kChunkBytes).error ==
        "a.csv:2: the row is longer than 1048576 bytes; is a quote not closed?");
}
