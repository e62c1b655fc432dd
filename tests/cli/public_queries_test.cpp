// The public benchmark's queries with known truth through the program: every claim holds.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone::tests;

TEST_CASE("every claim of the public queries holds") {
  const std::string data = TOUCHSTONE_QUERY_DATA;
  if (data.empty()) {
    skip("TOUCHSTONE_QUERY_DATA names no folder with the public benchmark's queries");
    return;
  }
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data + "/sample-queries")) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() == 22);
  std::vector<std::string> arguments = {"certify"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  const Run run = run_program(arguments);
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(run.out.rfind("all 4,884 claims hold (claims of the truth column, 22 files)\n", 0) == 0);

  SECTION("and those that the scenes' lists of booleans make of their queries") {
    std::size_t lists = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data + "/scenes")) {
      const std::string name = entry.path().stem().string();  // 227ee
      if (entry.path().extension() != ".csv") continue;
      const auto scene = entry.path().parent_path().parent_path();
      const Run judged = run_program(
          {"certify", "--claims", (scene / "mma_bool" / (name + "_mma_bool.json")).string(), entry.path().string()});
      CAPTURE(entry.path().string(), judged.out, judged.err);
      CHECK(judged.status == 0);
      ++lists;
    }
    CHECK(lists == 3);
  }

  SECTION("and one flipped bit among them is found") {
    const TemporaryFolder folder;
    const std::string original = *std::find_if(files.begin(), files.end(), [](const std::string& name) {
      return name.find("unit-tests/vertex-face") != std::string::npos;
    });
    std::filesystem::create_directories(folder.path("vertex-face"));
    std::filesystem::copy_file(original, folder.path("vertex-face/a.csv"));
    std::string text = folder.read("vertex-face/a.csv");
    std::size_t row = 0;
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1), ++row) {
      if (row / 8 == 12) text[at - 1] = text[at - 1] == '1' ? '0' : '1';
    }
    const std::string file = folder.write("vertex-face/a.csv", text);
    const Run refuted = run_program({"certify", file});
    CHECK(refuted.status == 1);
    CHECK(refuted.out.rfind("1 of 125 claims refuted", 0) == 0);
    CHECK(occurrences(refuted.out, file + " query 12 (rows 97 to 104): missed\n") == 1);
  }
}
