// `touchstone audit` with an engine that is right, and with engines that are wrong in one way each.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone::tests;

namespace {

const std::string kToy = std::string("toy=") + TOUCHSTONE_TOY_ENGINE;

Run audit(const TemporaryFolder& folder, std::vector<std::string> arguments) {
  std::vector<std::string> all{"audit", "--out", folder.path("out"), "--engine", kToy};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run_program(all);
}

/// The numbers of a row of the table: queries, missed, phantom, late, tolerated.
std::vector<long> numbers_of(const std::string& out, const std::string& question, const std::string& kind) {
  std::smatch found;
  if (!std::regex_search(out, found, std::regex(question + " +" + kind + "(( +[0-9,]+){5})"))) return {};
  std::vector<long> numbers;
  std::string text = found[1];
  text.erase(std::remove(text.begin(), text.end(), ','), text.end());
  std::istringstream words(text);
  for (long number = 0; words >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace

TEST_CASE("an engine that is right has no finding in ten thousand") {
  const TemporaryFolder folder;
  const Run run = audit(folder, {"toy/right", "--cases", "5000"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  for (const char* const kind : {"edge-edge", "vertex-face"}) {
    CHECK(numbers_of(run.out, "toy/right", kind) == std::vector<long>{5000, 0, 0, 0, 0});
  }
}

TEST_CASE("an answer within the engine's tolerance is counted apart, and one beyond it is not") {
  const TemporaryFolder folder;
  const Run within = audit(folder, {"toy/moved", "--cases", "2000"});
  CAPTURE(within.out, within.err);
  CHECK(within.status == 0);
  const auto tolerated = numbers_of(within.out, "toy/moved", "vertex-face");
  REQUIRE(tolerated.size() == 5);
  CHECK(tolerated[1] + tolerated[2] + tolerated[3] == 0);
  CHECK(tolerated[4] > 100);
  const Run beyond = audit(folder, {"toy/strict", "--cases", "2000", "--findings", "1"});
  CAPTURE(beyond.out, beyond.err);
  CHECK(beyond.status == 1);
  CHECK(occurrences(beyond.out, " more kinds of failure not shown; --findings 0 shows all\n") >= 1);
  const auto found = numbers_of(beyond.out, "toy/strict", "vertex-face");
  REQUIRE(found.size() == 5);
  CHECK(found[1] + found[2] + found[3] > 100);
}

TEST_CASE("an engine that drops contacts is found, shrunk, and asked again by the command that is printed") {
  const TemporaryFolder folder;
  for (const std::string question : {"drops", "casts"}) {
    const Run run = audit(folder, {"toy/" + question, "--cases", "2000", "--findings", "1", "--html",
                                   folder.path("page.html"), "--kind", "vertex-face"});
    CAPTURE(run.out, run.err);
    CHECK(run.status == 1);
    CHECK(occurrences(run.out, "toy/" + question + " missed") == 1);
    const std::string file = folder.path("out/toy-" + question + "/vertex-face/missed.csv");
    CHECK(occurrences(run.out, "touchstone audit toy/" + question + " --out again --engine ") == 1);
    CHECK(occurrences(run.out, " --from " + file) == 1);
    CHECK(std::filesystem::file_size(folder.path("page.html")) > 1000);
    CHECK(std::filesystem::file_size(folder.path("out/audit.txt")) > 500);
    const Run again =
        run_program({"audit", "toy/" + question, "--out", folder.path("again"), "--engine", kToy, "--from", file});
    CAPTURE(again.out, again.err);
    CHECK(again.status == 1);
    CHECK(numbers_of(again.out, "toy/" + question, "vertex-face") == std::vector<long>{1, 1, 0, 0, 0});
  }
}

TEST_CASE("an engine's failures and crashes are counted") {
  const TemporaryFolder folder;
  const Run fails = audit(folder, {"toy/fails", "--cases", "300", "--kind", "edge-edge", "--findings", "1"});
  CAPTURE(fails.out, fails.err);
  CHECK(fails.status == 1);
  CHECK(occurrences(fails.out, "it says 'unknown'") == 1);
  const Run crashes = audit(folder, {"toy/crashes", "--cases", "40", "--kind", "edge-edge", "--findings", "1"});
  CAPTURE(crashes.out, crashes.err);
  CHECK(crashes.status == 1);
  CHECK(occurrences(crashes.out, "signal 6") == 1);
}

TEST_CASE("an engine that cannot be asked is named with the reason") {
  const TemporaryFolder folder;
  const Run nowhere = run_program({"audit", "--out", folder.path("out"), "--engine", "none=/nowhere/engine"});
  CHECK(nowhere.status == 2);
  CHECK(occurrences(nowhere.err, "none: '/nowhere/engine': the solver's command cannot be started") == 1);
  const Run silent = run_program({"audit", "--out", folder.path("out"), "--engine", "none=true"});
  CHECK(occurrences(silent.err, "none: it describes no question") == 1);
  const Run fails = run_program({"audit", "--out", folder.path("out"), "--engine", "none=false"});
  CHECK(occurrences(fails.err, "none: exit status 1") == 1);
  const Run endless = run_program({"audit", "--out", folder.path("out"), "--engine", "none=yes --"});
  CHECK(occurrences(endless.err, "none: it writes more than 65536 bytes") == 1);
  const Run both = audit(folder, {"--engine", "none=false", "--cases", "10", "--kind", "vertex-face"});
  CHECK(occurrences(both.out, "none: not asked: exit status 1") == 1);
  CHECK(occurrences(both.out, "toy/right") > 0);
  CHECK(audit(folder, {"toy/unheard-of"}).status == 2);
  const Run twice = audit(folder, {"--engine", "toy=true"});
  CHECK(twice.status == 2);
  CHECK(occurrences(twice.err, "there is an engine toy; name it otherwise") == 1);
  CHECK(run_program({"audit", "--out", folder.path("out"), "--engine", "Toy"}).status == 2);
  CHECK(run_program({"audit", "unheard-of", "--out", folder.path("out")}).status == 2);
  CHECK(run_program({"audit"}).status == 2);
}

TEST_CASE("each engine that is installed answers all that it claims") {
  std::ifstream list(std::string(TOUCHSTONE_ENGINES) + "/engines.txt");
  if (!list) return skip("the engines are not built");
  for (std::string line; std::getline(list, line);) {
    const std::string name = line.substr(0, line.find(' '));
    const TemporaryFolder folder;
    const Run run =
        run_program({"audit", name, "--out", folder.path("out"), "--cases", "80", "--findings", "1", "--threads", "1"});
    CAPTURE(name, run.out, run.err);
    if (run.status == 2) {
      skip(run.err);
      continue;
    }
    CHECK((run.status == 0 || run.status == 1));
    CHECK(occurrences(run.out, "crash") == 1);  // the column
    CHECK(occurrences(run.out, "is no answer") == 0);
  }
}
