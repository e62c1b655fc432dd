// touchstone fuzz: status, table, files, reproduction.
// SPDX-License-Identifier: MIT
#include <regex>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "fuzz/printed.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

TEST_CASE("ours is found right: status 0") {
  const Run run = run_program({"fuzz", "--cases", "5000", "--threads", "1"});
  CHECK(run.status == 0);
  CHECK(run.err == "");
  CHECK(run.out.rfind("touchstone judged by exact, seed 1: 5,000 queries in ", 0) == 0);
  CHECK(occurrences(run.out, "\nnothing found\n") == 1);
}

TEST_CASE("every inexact solver is broken, and the findings certify, explain and repeat themselves", "[slow]") {
  const auto solver = GENERATE("paper", "closed_form", "newton", "interval", "conservative_advancement");
  CAPTURE(solver);
  const TemporaryFolder folder;
  const Run run = run_program({"fuzz", "--solver", solver, "--cases", "4000", "--findings", "6", "--family", "lattice2",
                               "--family", "near_hit", "--family", "parallel", "--out", folder.path("out")});
  CAPTURE(run.out, run.err);
  REQUIRE(run.status == 1);
  CHECK(run.err == "");
  CHECK(occurrences(run.out, "\n  all ") == 1);

  std::vector<std::string> certify = {"certify"};
  std::size_t queries = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("out"))) {
    if (!entry.is_regular_file()) continue;
    certify.push_back(entry.path().string());
    queries += occurrences(folder.read(std::filesystem::relative(entry.path(), folder.path("")).string()), "# query ");
  }
  const Run certified = run_program(certify);
  CHECK(certified.status == 0);
  CHECK(occurrences(certified.out, "all " + std::to_string(queries) + " claim") == 1);

  const auto explanations = lines_with(run.out, "touchstone explain ");
  CHECK(explanations.size() == queries);
  for (const auto& command : explanations) CHECK(run_program(arguments_of(command)).status == 0);
  const auto cases = lines_with(run.out, "touchstone fuzz --solver");
  CHECK(cases.size() == queries);
  for (const auto& command : cases) {
    const Run again = run_program(arguments_of(command));
    CAPTURE(command, again.out, again.err);
    CHECK(again.status == 1);
    CHECK(occurrences(again.out, command.substr(command.find("--case"))) == 1);
  }
}

TEST_CASE("the same cases and seed give the same output for any number of threads") {
  const TemporaryFolder folder;
  const auto run_on = [&](const char* threads) {
    const Run run = run_program({"fuzz", "--solver", "paper", "--cases", "6000", "--seed", "9", "--climb", "1",
                                 "--findings", "5", "--threads", threads});
    CHECK(run.status == 1);
    return without_time(run.out);
  };
  const std::string one = run_on("1");
  CHECK(run_on("2") == one);
  CHECK(run_on("5") == one);
}

TEST_CASE("a case that is right has status 0") {
  const Run run = run_program({"fuzz", "--solver", "touchstone", "--case", "near_hit edge-edge 1 2"});
  CHECK(run.status == 0);
  CHECK(run.out == "near_hit edge-edge 1 2: touchstone is right\n");
}

TEST_CASE("early claims count only when asked for") {
  const std::vector<std::string> search = {"fuzz",     "--solver",       "interval", "--kind",     "point-point",
                                           "--family", "random_doubles", "--family", "prescribed", "--cases",
                                           "500"};
  const Run any = run_program(search);
  CHECK(occurrences(any.out, "early") == 0);
  auto strict = search;
  strict.insert(strict.end(), {"--early", "0ulps"});
  const Run run = run_program(strict);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "early") > 0);
  const auto commands = lines_with(run.out, "--early 0ulps --case");
  REQUIRE_FALSE(commands.empty());
  CHECK(run_program(arguments_of(commands.front())).status == 1);
}

TEST_CASE("an interrupt ends the search with its table and its files") {
  const TemporaryFolder folder;
  RunOptions options;
  options.interrupt_after = 1;
  const Run run = run_program({"fuzz", "--solver", "paper", "--seconds", "1000", "--out", folder.path("out")}, options);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "; interrupted\n") == 1);
  CHECK(occurrences(run.out, "\n  all ") == 1);
  CHECK(std::filesystem::exists(folder.path("out/edge-edge/missed.csv")));
}

TEST_CASE("bad usage ends with status 2 and one line, and writes nothing") {
  const TemporaryFolder folder;
  const auto check_refused = [&](std::vector<std::string> arguments, const std::string& part) {
    arguments.insert(arguments.begin(), "fuzz");
    const Run run = run_program(arguments);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(occurrences(run.err, part) > 0);
    CHECK(folder.names().empty());
  };
  check_refused({"--solver", "oraculum"},
                "'oraculum' is no solver; they are touchstone, exact, oracle, fast-cgal, batch, paper, ");
  check_refused({"--solver", "./no/such.so"}, "./no/such.so");
  check_refused({"--solver", "paper", "--kind", "point-edge", "--cases", "10", "--out", folder.path("x")},
                "paper takes no queries of this kind: point-edge");
  check_refused({"--kind", "edge"}, "edge is no kind");
  check_refused({"--family", "lattice9"}, "lattice9 is no family");
  check_refused({"--cases", "0"}, "--cases");
  check_refused({"--climb", "1000001"}, "--climb");
  check_refused({"--solver-command", ""}, "the command is empty");
  check_refused({"--solver-command", "  "}, "the command is empty");
  check_refused({"--seconds", "1e-300"}, "no query was asked");
  check_refused({"--cases", "-1"}, "--cases");
  check_refused({"--cases", "99999999999999999999"}, "--cases");
  check_refused({"--seconds", "0"}, "--seconds");
  check_refused({"--seconds", "nan"}, "--seconds");
  check_refused({"--seed", "x"}, "--seed");
  check_refused({"--early", "16"}, "--early");
  check_refused({"--early", "ulps"}, "--early");
  check_refused({"--judge", "me"}, "--judge");
  check_refused({"--threads", "0"}, "--threads");
  check_refused({"--case", "lattice1"}, "lattice1 is no case");
  check_refused({"--case", "lattice1 edge-edge 1 1", "--cases", "5"}, "--case");
  check_refused({"--case", "given edge-edge 1 1"}, "needs the files");
  check_refused({"--from", "none.csv"}, "none.csv");
  check_refused({"--from", "none.csv", "--family", "lattice1"}, "--f");
  check_refused({"--solver", "paper", "--solver-command", "cat"}, "--solver");
}

TEST_CASE("queries of files are asked, with what lies around them, and a finding repeats itself") {
  const TemporaryFolder folder;
  // Without its radii: pairs that keep a distance are in files of their own.
  REQUIRE(run_program({"simulate", "hoop", "--size", "200", "--scene-out", folder.path("thick.json")}).status == 0);
  std::string scene =
      std::regex_replace(folder.read("thick.json"), std::regex("\"radius\":[^,}]*\\}"), "\"radius\":0}");
  scene = std::regex_replace(scene, std::regex("\"solid\":true,"), "");
  REQUIRE(run_program({"simulate", folder.write("thin.json", scene), "--steps", "60", "--queries", folder.path("q")})
              .status == 0);
  const std::string edges = folder.path("q/edge-edge/candidates.csv"),
                    faces = folder.path("q/vertex-face/candidates.csv");
  const auto asked = [](const Run& run, const std::string& before) {
    const std::size_t at = run.out.find(before) + before.size();
    return run.out.substr(at, run.out.find(' ', at) - at);
  };
  const Run once = run_program({"fuzz", "--from", edges, faces, "--threads", "1"});
  CAPTURE(once.out, once.err);
  CHECK(once.status == 0);
  CHECK(occurrences(once.out, "\nnothing found\n") == 1);
  CHECK(asked(once, "seed 1: ").size() >= 5);  // thousands

  const std::vector<std::string> broken{"fuzz",    "--solver", "paper",      "--from", edges,
                                        "--climb", "3",        "--findings", "1"};
  auto with_threads = [&](const char* threads) {
    std::vector<std::string> arguments = broken;
    arguments.insert(arguments.end(), {"--threads", threads});
    return run_program(arguments);
  };
  const Run run = with_threads("1");
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "\n  given ") == 1);
  CHECK(without_time(run.out) == without_time(with_threads("3").out));
  const auto again = lines_with(run.out, " --case ");
  REQUIRE(again.size() == 1);
  const Run repeated = run_program(arguments_of(again[0]));
  CAPTURE(again[0], repeated.out, repeated.err);
  CHECK(repeated.status == 1);
  CHECK(repeated.out.find("   exact: ") != std::string::npos);
  CHECK(run_program({"fuzz", "--from", edges, "--case", "lattice1 edge-edge 1 1"}).status == 2);
  CHECK(run_program({"fuzz", "--from", edges, "--case", "given edge-edge 1 999999999"}).status == 2);
}

TEST_CASE("a place where nothing can be written is found out at once") {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "mine");
  const Run run = run_program({"fuzz", "--seconds", "1000", "--out", file});
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(folder.read("file") == "mine");
}
