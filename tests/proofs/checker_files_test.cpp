// Files of proofs and of queries as text: what the checker reads, and what it refuses.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "io/sha256.hpp"
#include "proofs/run_checker.hpp"
#include "proofs/small_proofs.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {
constexpr int kMostExponent = 20000;
}

TEST_CASE("the lines of a file of proofs") {
  const std::string first = "touchstone-proofs 1\n", file = "file point-point - a name\n";
  const std::string proof = "0 none\nd 1 0 0\n", end = "end 1 0\n";
  const std::string digest(64, 'a');
  CHECK(check_texts(first + file + proof + end, {kApart}).status == 0);
  CHECK(check_texts("# x\n\n \t\n\t# y\n" + first + " file  point-point -  b \r\n0 none \n\nd  1 0 0\r\nend 1 0",
                    {kApart})
            .status == 0);
  refuse_with(2, "touchstone-proofs 1", "", {kApart});
  refuse_with(2, "touchstone-proofs 1", "touchstone-proofs 2\n" + file + proof + end, {kApart});
  refuse_with(2, "touchstone-proofs 1", file + proof + end, {kApart});
  refuse_with(1, "file KIND", first + proof + end, {kApart});
  refuse_with(1, "file KIND", first + "file point-point -\n" + proof + end, {kApart});
  refuse_with(1, "file KIND", first + "file point-point " + digest + "a a\n" + proof + end, {kApart});
  refuse_with(1, "is no kind", first + "file points - a\n" + proof + end, {kApart});
  for (const char* const wrong : {"1 none", "00 none", "none", "0", "0 no", "0 none 1", "0\tnone", "x none"}) {
    refuse_with(1, "query 0: ", first + file + wrong + "\nd 1 0 0\n" + end, {kApart});
  }
  for (const char* const wrong :
       {"", "end", "end 0 0\n", "end 1 1\n", "end 01 0\n", "end 1 0 0\n", "end 1 0\n0 none\n"}) {
    refuse_with(1, "here must be ", first + file + proof + wrong, {kApart});
  }
  refuse_with(1, "query 1: ", first + file + proof + end, {kApart + kApart});
  refuse_with(1, "\"end\"", first + file + proof + "1 none\nd 1 0 0\nend 2 0\n", {kApart});
  refuse_with(1, "file KIND", first + file + proof + end, {kApart, kApart});
  refuse_with(1, "\"end\"", first + file + proof + file + proof + "end 2 0\n", {kApart});
  // Proofs of nothing say nothing.
  for (const char* const nothing : {"", "# nothing\n", "\n"}) {
    refuse_with(2, "there is nothing to check: the file has no query", first + file + "end 0 0\n", {nothing});
    refuse_with(2, "file1: there is nothing to check", first + file + proof + file + "end 1 0\n", {kApart, nothing});
  }
  refuse_with(2, "the file has no query", first + file + "end 0 0\n", {"touchstone-curved,1\n"});
}

TEST_CASE("proofs hold for the file that they name, and nothing is printed before all hold") {
  const auto proofs = [](const std::string& digest) {
    return "touchstone-proofs 1\nfile point-point " + digest + " a\n0 none\nd 1 0 0\nend 1 0\n";
  };
  // Of all sizes around that of a block, by another reader.
  for (std::size_t size = 0; size < 140; ++size) {
    const std::string query = kApart + "#" + std::string(size, 'x');
    const std::string digest = touchstone::io::sha256(query);
    CHECK(check_texts(proofs(digest), {query}).status == 0);
    refuse_with(1, "the proofs are about another file", proofs(digest), {query + "x"});
  }
  const std::string long_query = kApart + std::string("#").append(200000, 'y') + "\r\n \n";
  CHECK(check_texts(proofs(touchstone::io::sha256(long_query)), {long_query}).status == 0);
  // The reason is the other file, where its queries are others, too.
  refuse_with(1, "the proofs are about another file", proofs(touchstone::io::sha256(kApart)), {kMeeting});
  const std::string two =
      "touchstone-proofs 1\nfile point-point - a\n0 none\nd 1 0 0\nfile point-point - b\n0 none\n"
      "d 1 0 0\nend 2 0\n";
  const CheckerRun run = check_texts(two, {kApart, kMeeting});
  CHECK(run.status == 1);
  CHECK(run.text.rfind("rejected: ", 0) == 0);
}

TEST_CASE("numbers of proofs") {
  for (const char* const one :
       {"1", "001", "0x1p0", "0x.8p1", "0x8.p-3", "0x0.80p+1", "0x10p-004", "0xAp-1", "0xap-3"}) {
    accept(kPoints, kApart, {"0 none", std::string("d ") + one + " 0 -0"});
  }
  for (const char* const wrong :
       {"+1",  "1.0", "1e0",  "0x",      "0x1",     "0xp1",   "0x.p1", "0x1.1.1p0", "0X1p0", "0x1P0",
        "--1", "-",   "0x1p", "0x1p+-1", "0x1p0x1", "0x-1p0", "1\t",   "0x1gp0",    "inf",   "\"1\""}) {
    call_bad("was expected", kPoints, kApart, {"0 none", std::string("d ") + wrong + " 0 0"});
  }
  accept(kPoints, kApart, {"0 none", "d " + std::string(4096, '9') + " 0 0"});
  call_bad("4,096 or", kPoints, kApart, {"0 none", "d " + std::string(4097, '9') + " 0 0"});
  accept(kPoints, kApart, {"0 none", "d 0x." + std::string(16384, 'f') + "p0 0 0"});
  call_bad("16,384 digits", kPoints, kApart, {"0 none", "d 0x." + std::string(16385, 'f') + "p0 0 0"});
}

TEST_CASE("exponents and lines have limits") {
  const std::string most = std::to_string(kMostExponent);
  const std::string beyond = std::to_string(kMostExponent + 1);
  accept(kPoints, kApart, {"0 none", "d 0x1p" + most + " 0x1p-" + most + " 0"});
  for (const std::string sign : {"", "-", "+"}) {
    call_bad("exponent", kPoints, kApart, {"0 none", "d 0x1p" + sign + beyond + " 0 0"});
  }
  call_bad("exponent", kPoints, kApart, {"0 none", "d 0x1p" + std::string(300, '9') + " 0 0"});
  const std::string full = std::string("#").append((1U << 20) - 1, 'x');
  accept(kPoints, kApart, {full, full + "\r", "0 none", "d 1 0 0"});
  accept(kPoints, full + "\r\n" + kApart + full, {"0 none", "d 1 0 0"});
  for (const char* const rest : {"x", "xx", "x\r", "x and more"}) {
    call_bad("2^20 bytes", kPoints, kApart, {"0 none", full + rest, "d 1 0 0"});
    call_bad("2^20 bytes", kPoints, full + rest + "\n" + kApart, {"0 none", "d 1 0 0"});
  }
}

TEST_CASE("times have few places, however they are written") {
  const std::string zeros(100, '0');
  accept(kPoints, kApart, {"0 none", "d 1 0 0 to 0x1." + zeros + "p-20000", "d 1 0 0"});
  accept(kPoints, kMeeting, Lines{"0 contact 0x1." + zeros + "p-1 0x1" + zeros + "p-401", "d -1 0 0"} + kWeights);
  const std::string beyond = "multiple of 2^-20,000", tiny = "0x0.8p-20000";
  call_bad(beyond, kPoints, kApart, {"0 none", "d 1 0 0 to " + tiny, "d 1 0 0"});
  call_bad(beyond, kPoints, kMeeting, Lines{"0 contact " + tiny + " 0x1p-1", "d -1 0 0"} + kWeights);
  call_bad(beyond, kPoints, kMeeting, Lines{"0 contact 0x1p-1 " + tiny, "d -1 0 0"} + kWeights);
  for (const std::string& ends : {"0x1.5555555555555p-1 " + tiny, tiny + " 1"}) {
    call_bad(beyond, kPoints, kPassing, Lines{kTwoThirds, "d -1 0 0", "root -2 3 between " + ends} + kWeights);
  }
}

TEST_CASE("query files with an error") {
  const std::string row = "0,1,0,1,0,1,0\n";
  const auto with = [&](const std::string& bad) { return row + row + row + bad; };
  for (const auto& [bad, message] :
       std::vector<std::pair<std::string, std::string>>{{"0,1,0,1,0\n", "6 or 7 columns"},
                                                        {"0,1,0,1,0,1,0,0\n", "6 or 7 columns"},
                                                        {"0 1 0 1 0 1 0\n", "6 or 7 columns"},
                                                        {"0,0,0,1,0,1,0\n", "must be positive"},
                                                        {"0,-1,0,1,0,1,0\n", "must be positive"},
                                                        {"0.5,1,0,1,0,1,0\n", "decimal integer"},
                                                        {"0,1,,1,0,1,0\n", "decimal integer"},
                                                        {"0,1,1 1,1,0,1,0\n", "decimal integer"},
                                                        {"0,1,+1,1,0,1,0\n", "decimal integer"},
                                                        {"0,1,-,1,0,1,0\n", "decimal integer"},
                                                        {"0,1,0x1,1,0,1,0\n", "decimal integer"},
                                                        {std::string("0,1,0\0,1,0,1,0\n", 15), "decimal integer"},
                                                        {std::string(4097, '1') + ",1,0,1,0,1,0\n", "decimal integer"},
                                                        {"0,1,0,1,0,1,2\n", "0 or 1"},
                                                        {"0,1,0,1,0,1,\n", "0 or 1"},
                                                        {"0,1,0,1,0,1,1\n", "the same in all rows"},
                                                        {"0,1,0,1,0,1\n", "the same in all rows"},
                                                        {"", "ends within a query"}}) {
    call_bad(message, kPoints, with(bad), {"0 none", "d 1 0 0"});
    call_bad("file0:", kPoints, with(bad), {"0 none", "d 1 0 0"});
  }
  accept(kPoints, kApart + "\n#\n", {"0 none", "d 1 0 0"});
  // Without the truth.
  accept(kPoints, "0,1,0,1,0,1\n2,1,0,1,0,1\n0,1,0,1,0,1\n3,1,0,1,0,1", {"0 none", "d 1 0 0"});
}

TEST_CASE("files that cannot be read, and a wrong call") {
  const TemporaryFolder folder;
  const std::string proofs = folder.write("proofs.txt", proofs_of(kPoints, {"0 none", "d 1 0 0"}));
  const std::string queries = folder.write("queries.csv", kApart);
  CHECK(run_checker(proofs + " " + queries).status == 0);
  for (const std::string& words :
       {proofs + " " + folder.path("no.csv"), folder.path("no.txt") + " " + queries, proofs + " " + folder.path("."),
        folder.path(".") + " " + queries, proofs, std::string(), proofs + " " + queries + " " + queries + "x"}) {
    const CheckerRun run = run_checker(words);
    INFO(words << ": " << run.text);
    CHECK(run.status == (words.back() == 'x' ? 1 : 2));
    CHECK_FALSE(run.text.empty());
  }
  const auto text_of = [](const std::string& words) { return run_checker(words).text; };
  CHECK(text_of(folder.path("no.txt") + " x") ==
        "touchstone-check: " + folder.path("no.txt") + ": cannot be opened for reading: No such file or directory\n");
  CHECK(text_of(folder.path("") + " x") ==
        "touchstone-check: " + folder.path("") + ": cannot be read to its end: Is a directory\n");
}

TEST_CASE("names and words from files only show") {
  const TemporaryFolder folder;
  const std::string hostile = "a\x1b]0;b\x07\xe2\x80\xae\xc2\x9b\xff\xef\xbb\xbf \xc3\xa9";
  const std::string shown = "a\\x1b]0;b\\x07\\xe2\\x80\\xae\\xc2\\x9b\\xff\\xef\\xbb\\xbf \xc3\xa9";
  const std::string proofs = folder.write("proofs.txt", proofs_of(kPoints, {"0 none", "d 1 0 0"}));
  const std::string queries = folder.write(hostile, kApart),
                    bad = folder.write(hostile + ".bad", "x\x1b[1m\xe2\x80\xae\n");
  const CheckerRun good = run_checker(proofs + " '" + queries + "'");
  CHECK(good.status == 0);
  CHECK(good.text == folder.path(shown) +
                         ": 1 point-point query; the proofs name no digest of the file\n1 query checked: 0 contacts, 1 "
                         "without contact\n");
  const CheckerRun missing = run_checker("'" + queries + "x' '" + queries + "'");
  CHECK(missing.text.find("touchstone-check: " + folder.path(shown) + "x: cannot be opened") == 0);
  CHECK(run_checker(proofs + " '" + bad + "'").text.find(folder.path(shown) + ".bad:1: ") != std::string::npos);
  call_bad("\"1\\x1b[1m\\xe2\\x80\\xae\"", kPoints, kApart, {"0 none", "d 1\x1b[1m\xe2\x80\xae 0 0"});
  // What has no width or direction of its own is shown as it is; half a character, and a long form, are not.
  for (const char* const plain : {"\xe2\x82\xac", "\xf0\x9f\x8e\x88", "\xd9\x85\xe2\x80\x8c\xd9\x85"}) {
    call_bad(plain, kPoints, kApart, {"0 none", std::string("d ") + plain + " 0 0"});
  }
  for (const auto& [bytes, escaped] :
       std::vector<std::pair<std::string, std::string>>{{"\xc0\xaf", "\\xc0\\xaf"},
                                                        {"\xed\xa0\x80", "\\xed\\xa0\\x80"},
                                                        {"\xe2\x82", "\\xe2\\x82"},
                                                        {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},
                                                        {"\xe0\x82\xac", "\\xe0\\x82\\xac"},
                                                        {"\xe2\x81\xa6", "\\xe2\\x81\\xa6"},
                                                        {"\xe2\x80\x8f", "\\xe2\\x80\\x8f"},
                                                        {"\x7f", "\\x7f"}}) {
    call_bad("\"" + escaped + "\"", kPoints, kApart, {"0 none", "d " + bytes + " 0 0"});
  }
}

TEST_CASE("a person who asks for help gets it on standard output") {
  for (const char* option : {"--help", "-h"}) {
    const CheckerRun run = run_checker(std::string(option) + " 2>/dev/null #");
    CHECK(run.status == 0);
    CHECK(run.text.rfind("usage: touchstone-check [OPTION]... PROOFS FILE...\n", 0) == 0);
    CHECK(run.text.find("Exit status: 0 ") != std::string::npos);
  }
  const CheckerRun silent = run_checker("2>/dev/null #");  // a wrong call writes it to standard error
  CHECK(silent.status == 2);
  CHECK(silent.text.empty());
  CHECK(run_checker("2>&1 #").text.starts_with("touchstone-check: the file of proofs is missing, and behind it "));
  CHECK(
      run_checker("proofs.txt 2>&1 #")
          .text.starts_with("touchstone-check: behind the proofs, the query files or the motion file that they are "));
}
