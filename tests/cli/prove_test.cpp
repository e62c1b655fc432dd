// touchstone prove: the text of proofs, whatever the number of threads.
// SPDX-License-Identifier: MIT
#include <string>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "io/sha256.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("proofs are in input order, file by file, and the number of threads changes no byte") {
  const TemporaryFolder folder;
  const SampleFile edges = sample_file(Kind::edge_edge, 5, 12);
  const std::string first = folder.write("edge-edge/a.csv", edges.text);
  const std::string second = folder.write("point-point/b c.csv", two_point_queries());
  std::string proofs;
  for (const char* threads : {"1", "2", "7"}) {
    const std::string out = folder.path("proofs.txt");
    const Run run = run_program({"prove", "--threads", threads, "--out", out, first, second});
    CAPTURE(run.out, run.err);
    REQUIRE(run.status == 0);
    CHECK(run.out.find(std::to_string(edges.queries.size() + 2) + " queries in 2 files proved in " + out + "\n") == 0);
    const std::string text = folder.read("proofs.txt");
    if (proofs.empty()) proofs = text;
    CHECK((text == proofs));
  }
  CHECK(proofs.rfind("touchstone-proofs 1\nfile edge-edge ", 0) == 0);
  CHECK(occurrences(proofs, "\nfile point-point " + io::sha256(two_point_queries()) + " " + second + "\n") == 1);
  CHECK(occurrences(proofs, "b c.csv\n0 contact 0x1.5555555555555p-2 0x1.5555555555556p-2\n") == 1);
  CHECK(occurrences(proofs, "\n1 none\n") == 2);
  std::size_t contacts = 1;
  for (const Answer& answer : edges.answers) contacts += answer.contact ? 1 : 0;
  const std::string end = "\nend " + std::to_string(edges.queries.size() + 2) + " " + std::to_string(contacts) + "\n";
  CHECK(proofs.size() > end.size());
  CHECK(proofs.substr(proofs.size() - end.size()) == end);
}

TEST_CASE("prove refuses what it cannot read, and leaves no file") {
  const TemporaryFolder folder;
  const std::string bad = folder.write("point-point/bad.csv", "0,1,0,1,0,1,1\n");
  const Run run = run_program({"prove", "--out", folder.path("p.txt"), bad});
  CHECK(run.status == 2);
  CHECK(run.err.find("bad.csv:") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path("p.txt")));
  CHECK(run_program({"prove", folder.path("none.csv")}).status == 2);
  CHECK(run_program({"prove", "--out", bad, bad}).status == 2);
}
