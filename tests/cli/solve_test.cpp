// touchstone solve: one row a query, in input order, the same bytes for any number of threads and any chunk size.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "cli/solve.hpp"
#include "io/answers/answer_writer.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

std::string expected_rows(const std::string& file, const std::vector<Answer>& answers) {
  std::string rows;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    io::append_answer(rows, io::csv_field(file), i, answers[i], io::Numbers::decimals);
  }
  return rows;
}

}  // namespace

TEST_CASE("answers are those of the library, for any number of threads and any chunk size") {
  constexpr std::uint64_t kSeed = 31;
  CAPTURE(kSeed);
  const TemporaryFolder folder;
  std::string expected(io::kAnswerHeader);
  cli::SolveCommandOptions options;
  for (const Kind kind : kKinds) {
    const SampleFile sample = sample_file(kind, kSeed, 2);
    options.files.push_back(folder.write(std::string(name_of(kind)) + "/a.csv", sample.text));
    expected += expected_rows(options.files.back(), sample.answers);
  }
  options.out = folder.path("answers.csv");
  for (const int threads : {1, 2, 5}) {
    for (const std::size_t chunk : {std::size_t{3}, std::size_t{5000}, io::kChunkBytes}) {
      CAPTURE(threads, chunk);
      options.threads = threads;
      options.chunk_bytes = chunk;
      const Run run = run_here([&] { return cli::run_solve(options); });
      CHECK(run.status == 0);
      REQUIRE(folder.read("answers.csv") == expected);
    }
  }
}

TEST_CASE("answers as decimals and as lines of JSON read back as the same answers") {
  const TemporaryFolder folder;
  for (const bool apart : {false, true}) {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
      const SampleFile sample = sample_file(kind, 9, 2);
      const std::string file = folder.write(std::string(name_of(kind)) + "/\"a\"\n.csv", sample.text);
      const auto run_with = [&](std::vector<std::string> words) {
        if (apart) words.insert(words.end(), {"--separation", "0.1", "--metric", "max"});
        words.push_back(file);
        return run_program(words);
      };
      const std::string hexfloats = run_with({"solve", "--numbers", "hex"}).out;
      const std::string decimals = run_with({"solve"}).out;
      CHECK(hexfloats.find("0x1") != std::string::npos);
      CHECK(decimals.find("0x") == std::string::npos);
      const std::string lines = run_with({"solve", "--json"}).out;
      std::size_t count = 0;
      for (std::size_t at = 0; at < lines.size(); ++count) {
        const std::size_t end = lines.find('\n', at);
        const auto line = nlohmann::json::parse(lines.substr(at, end - at));
        at = end + 1;
        const Separation separation = apart ? Separation{0.1, Metric::max} : Separation{};
        const Answer answer = solve(sample.queries[count], {.separation = separation});
        REQUIRE(line["file"] == file);
        REQUIRE(line["query"] == count);
        REQUIRE(line["contact"] == answer.contact);
        REQUIRE(line["toi"] == (answer.contact ? nlohmann::json(answer.toi) : nlohmann::json()));
        REQUIRE(line["toi_upper"] == (answer.contact ? nlohmann::json(answer.toi_upper) : nlohmann::json()));
        REQUIRE(line["level"] == name_of(answer.level));
        REQUIRE(line.contains("metric") == apart);
      }
      CHECK(count == sample.queries.size());
      for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
               {"hex.csv", hexfloats}, {"decimal.csv", decimals}, {"lines.jsonl", lines}}) {
        const Run judged = run_program({"certify", "--claims", folder.write(name, text), file});
        CAPTURE(name, judged.out, judged.err);
        CHECK(judged.status == 0);
        CHECK(judged.out.starts_with("all " + std::to_string(count) + " claims hold"));
        CHECK(occurrences(judged.out, "0 to 0 doubles before the exact time") == 1);
      }
    }
  }
}

TEST_CASE("every level gives the same answers but for its own name") {
  const TemporaryFolder folder;
  const SampleFile sample = sample_file(Kind::vertex_face, 8, 1);
  const std::string file = folder.write("vertex-face/a.csv", sample.text);
  const auto rows = [&](const std::string& level) {
    const Run run = run_program({"solve", "--level", level, file});
    CHECK(run.status == 0);
    CHECK(run.err == "");
    std::string text;
    for (std::size_t start = 0; start < run.out.size();) {
      const std::size_t end = run.out.find('\n', start);
      const std::string row = run.out.substr(start, end - start);
      text += row.substr(0, row.rfind(',')) + "\n";
      start = end + 1;
    }
    if (level == "exact" || level == "oracle") {
      CHECK(occurrences(run.out, "," + level + "\n") == sample.queries.size());
    } else {
      // The same filters; below them the level that the name says, and no other.
      CHECK(occurrences(run.out, level == "fast" ? ",exact\n" : ",oracle\n") > 0);
      CHECK(occurrences(run.out, level == "fast" ? ",oracle\n" : ",exact\n") == 0);
    }
    return text;
  };
  const std::string fast = rows("fast");
  CHECK(rows("exact") == fast);
  CHECK(rows("oracle") == fast);
  CHECK(rows("fast-cgal") == fast);
}

TEST_CASE("standard output and a named file get the same bytes, and the summary goes beside the latter only") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a, \"b\".csv", two_point_queries());
  const Run direct = run_program({"solve", file});
  CHECK(direct.status == 0);
  std::string name = file;
  name.replace(name.find("\"b\""), 3, "\"\"b\"\"");
  CHECK(direct.out == std::string(io::kAnswerHeader) + "\"" + name +
                          "\",0,1,0.3333333333333333,0.33333333333333337,isolated,p,q,exact\n"
                          "\"" +
                          name + "\",1,0,,,,,," + (occurrences(direct.out, "filter") > 0 ? "filter\n" : "exact\n"));
  const Run dash = run_program({"solve", "--out", "-", file});
  CHECK(dash.out == direct.out);
  const Run named = run_program({"solve", "--out", folder.path("answers.csv"), file});
  CHECK(folder.read("answers.csv") == direct.out);
  CHECK(named.out.rfind("2 queries in 1 file answered in " + folder.path("answers.csv") + "\n", 0) == 0);
  CHECK(occurrences(named.out, "microseconds a query") == 1);
}

TEST_CASE("coordinates that are no doubles are solved as the rationals that they are") {
  const TemporaryFolder folder;
  // The points meet at t = 1/2 in 1/3, which no double is; one part in 3e20 beside it they do not.
  const std::string rows = "1,3,0,1,0,1,1\n1,3,-1,2,0,1,1\n1,3,0,1,0,1,1\n1,3,1,2,0,1,1\n";
  std::string near = rows;
  near.replace(near.find("1,3"), 3, "100000000000000000001,300000000000000000000");
  const std::string file = folder.write("point-point/a.csv", rows + near);
  const Run run = run_program({"solve", file});
  CHECK(run.out ==
        std::string(io::kAnswerHeader) + file + ",0,1,0.5,0.5,isolated,p,q,exact\n" + file + ",1,0,,,,,,exact\n");
}
