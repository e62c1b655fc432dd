// touchstone merge: the reports of shards, by the program.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "io/sealed_json.hpp"
#include "sequence/needle.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

struct Sample {
  TemporaryFolder folder;
  std::vector<std::string> files;

  Sample() : files(write_needles(folder, "f", 5, 10, falling_tip)) {}

  Run mesh(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "mesh");
    arguments.insert(arguments.end(), files.begin(), files.end());
    return run_program(arguments);
  }
  std::vector<std::string> shards(int count, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> reports;
    for (int i = 1; i <= count; ++i) {
      reports.push_back(folder.path(std::string("part-").append(std::to_string(i)).append(".json")));
      std::vector<std::string> arguments = {"--report", reports.back(), "--shard",
                                            std::to_string(i).append("/").append(std::to_string(count))};
      arguments.insert(arguments.end(), more.begin(), more.end());
      REQUIRE(mesh(arguments).status < 2);
    }
    return reports;
  }
  Run merge(std::vector<std::string> reports, const std::vector<std::string>& more = {}) const {
    reports.insert(reports.begin(), {"merge", "--out", folder.path("merged.json")});
    reports.insert(reports.end(), more.begin(), more.end());
    return run_program(reports);
  }
  void check_refused(const std::vector<std::string>& reports, const std::string& part) const {
    const Run run = merge(reports);
    CAPTURE(run.err, part);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err, part) == 1);
    CHECK_FALSE(std::filesystem::exists(folder.path("merged.json")));
  }
};

}  // namespace

TEST_CASE("shards and merge give the files of one run, byte for byte") {
  const Sample sample;
  const std::string pairs = sample.folder.path("pairs.csv"), merged_pairs = sample.folder.path("merged.csv");
  for (const std::vector<std::string>& question : {std::vector<std::string>{}, std::vector<std::string>{"--check"}}) {
    auto arguments = question;
    arguments.insert(arguments.end(), {"--report", sample.folder.path("whole.json"), "--pairs", pairs});
    const Run whole = sample.mesh(arguments);
    CHECK(whole.status == 1);
    for (const int count : {1, 4, 9}) {
      auto reports = sample.shards(count, question);
      std::swap(reports.front(), reports.back());
      const Run run = sample.merge(reports, {"--pairs", merged_pairs});
      CAPTURE(run.err, count);
      CHECK(run.status == 1);
      CHECK(whole.out.ends_with(run.out));
      CHECK(occurrences(run.out, "\n") == 1);
      CHECK(sample.folder.read("merged.json") == sample.folder.read("whole.json"));
      CHECK(sample.folder.read("merged.csv") == sample.folder.read("pairs.csv"));
    }
  }
  const auto reports = sample.shards(3);
  const Run to_output = run_program({"merge", reports[0], reports[1], reports[2], "--out", "-"});
  CHECK(sample.mesh({"--report", "-"}).out == to_output.out);
}

TEST_CASE("shards of a copy in another folder fit") {
  const Sample one, two;
  auto reports = one.shards(4);
  reports[2] = two.shards(4)[2];
  CHECK(one.merge(reports).status == 1);
}

TEST_CASE("free shards merge with status 0") {
  Sample sample;
  sample.files = write_needles(sample.folder, "r", 4, 5, rising_tip);
  const Run run = sample.merge(sample.shards(2));
  CHECK(run.status == 0);
  CHECK(run.out == "4 steps, all free (19 vertices, 36 edges, 19 faces)\n");
}

TEST_CASE("shards that do not fit together are refused") {
  const Sample sample;
  const auto reports = sample.shards(4);
  const TemporaryFolder other_folder;
  sample.check_refused({reports[0], reports[1], reports[3]}, "is one of 4 shards, and only 3 are given; missing: 3");
  sample.check_refused({reports[0], reports[1], reports[2], reports[3], reports[1]}, "is shard 2/4, and so is ");
  const std::string foreign = other_folder.path("foreign.json");
  REQUIRE(sample.mesh({"--shard", "3/4", "--separation", "0.125", "--report", foreign}).status < 2);
  sample.check_refused({reports[0], reports[1], foreign, reports[3]},
                       "foreign.json: is about separation 0x1p-3, euclidean, and ");
  REQUIRE(sample.mesh({"--check", "--shard", "3/4", "--report", foreign}).status < 2);
  sample.check_refused({reports[0], reports[1], foreign, reports[3]}, "foreign.json: is about rest, and ");
  const std::string whole = other_folder.path("whole.json");
  REQUIRE(sample.mesh({"--report", whole}).status == 1);
  sample.check_refused({whole}, "whole.json: is the report of a whole run, and no shard");
  sample.check_refused({other_folder.path("none.json")}, "none.json: cannot be opened");
  sample.check_refused({sample.files[0]}, "f-0.obj: the report's digest does not match its content");

  std::string damaged = sample.folder.read("part-2.json");
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  sample.check_refused({reports[0], other_folder.write("d.json", damaged), reports[2], reports[3]},
                       "d.json: the report's digest does not match its content");
  std::string forged = sample.folder.read("part-2.json");
  const std::size_t at = forged.find("\"free\": 2");
  REQUIRE(at != std::string::npos);
  forged[at + 8] = '9';
  sample.check_refused(
      {reports[0],
       other_folder.write("f.json", io::sealed_json(std::string("{").append(forged.substr(forged.find('\n') + 1)))),
       reports[2], reports[3]},
      "f.json: the report is not as touchstone mesh writes it");

  // The frame that shards 2 and 3 share is another one when shard 3 runs.
  sample.folder.write("f-5.obj", sample.folder.read("f-5.obj") + "# changed\n");
  REQUIRE(sample.mesh({"--shard", "3/4", "--report", reports[2]}).status < 2);
  sample.check_refused(reports, "part-3.json: read another f-5.obj than ");
}

TEST_CASE("merge refuses to write over its input") {
  const Sample sample;
  const auto reports = sample.shards(2);
  const Run run = run_program({"merge", reports[0], reports[1], "--out", reports[0]});
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "is also an input") == 1);
  CHECK(run_program({"merge", "--out", sample.folder.path("m.json")}).status == 2);
  CHECK(run_program({"merge", reports[0]}).status == 2);
}
