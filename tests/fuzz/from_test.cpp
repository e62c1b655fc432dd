// touchstone fuzz --from: the queries of the files that are asked, and the report about the others.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// A point that meets another, at a third of the step; its first coordinate is no double.
const std::string kNoDouble = "1,3,0,1,0,1,0\n1,1,0,1,0,1,0\n1,1,0,1,0,1,0\n1,1,0,1,0,1,0\n";

Run fuzz_from(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"fuzz", "--threads", "1", "--from"});
  return run_program(arguments);
}

void check_refused(const Run& run, const std::string& part) {
  CAPTURE(run.out, run.err, part);
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(occurrences(run.err, part) == 1);
}

}  // namespace

TEST_CASE("a given file that --out would overwrite is refused, and stays as it was") {
  const TemporaryFolder folder;
  const std::string file = folder.write("out/edge-edge/missed.csv", sample_file(Kind::edge_edge, 1, 20).text);
  const std::string before = folder.read("out/edge-edge/missed.csv");
  const std::string out = folder.path("out");
  check_refused(fuzz_from({file, "--solver", "paper", "--out", out}),
                "missed.csv: is also an input; writing there would destroy it; give --out another folder");
  check_refused(fuzz_from({folder.path("out/./edge-edge/../edge-edge/missed.csv"), "--out", out}), "another folder");
  check_refused(fuzz_from({file, "--case", "given edge-edge 1 0", "--out", out}), "another folder");
  CHECK(folder.read("out/edge-edge/missed.csv") == before);
  CHECK(fuzz_from({file, "--out", folder.path("other")}).status == 0);
}

TEST_CASE("queries whose coordinates are no doubles are counted aloud, and nothing else being there is an error") {
  const TemporaryFolder folder;
  const std::string some = folder.write("point-point/some.csv", two_point_queries() + kNoDouble + kNoDouble);
  const std::string none = folder.write("other/point-point/none.csv", kNoDouble);
  const Run run = fuzz_from({some});
  CHECK(run.status == 0);
  CHECK(run.err == "2 of 4 queries of " + some +
                       " have coordinates that are no doubles and are not asked; the first is query 2, in row 9\n");
  CHECK(occurrences(run.out, ": 2 queries in ") == 1);
  const Run both = fuzz_from({some, none});
  CHECK(both.status == 0);
  CHECK(occurrences(both.err, "1 of 1 query of " + none + " has coordinates that are no doubles and is not asked") ==
        1);
  check_refused(fuzz_from({none}), "the only query is given with coordinates that are no doubles");
}

TEST_CASE("what does not count is said beside the verdict, and a case's command asks alike") {
  const auto fuzz = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"fuzz", "--solver", "newton", "--cases", "3000"});
    return run_program(arguments);
  };
  const Run none = fuzz({"--class", "hang,crash"});
  CHECK(none.status == 0);
  CHECK(occurrences(none.out, "\nnothing found; ") == 1);
  CHECK(occurrences(none.out, " wrong answers did not count: of other classes than hang, crash\n") == 1);
  const Run some = fuzz({"--late", "16ulps", "--near", "1e-3", "--class", "late", "--findings", "1"});
  CHECK(some.status == 1);
  CHECK(occurrences(some.out,
                    " did not count: late by at most 16ulps, or phantom within 0.001 of the greatest coordinate, "
                    "or of other classes than late\n") == 1);
  const Run allowed = run_program(
      {"fuzz", "--solver", "newton", "--late", "1", "--class", "missed", "--case", "triple_root vertex-face 1 7"});
  CHECK(allowed.status == 0);
  CHECK(occurrences(allowed.out, "newton is wrong, which the options allow\n") == 1);
  CHECK(occurrences(some.out, "touchstone fuzz --solver newton --late 16ulps --near 0.001 --case ") == 1);
}

TEST_CASE("given queries that were not asked are told, and --cases counts those that were") {
  const TemporaryFolder folder;
  const SampleFile edges = sample_file(Kind::edge_edge, 1, 1), faces = sample_file(Kind::vertex_face, 2, 1);
  const std::string first = folder.write("edge-edge/x.csv", edges.text);
  const std::string second = folder.write("vertex-face/x.csv", faces.text);
  const std::string all = std::to_string(edges.queries.size() + faces.queries.size());
  CHECK(occurrences(fuzz_from({first, second}).out, "asked ") == 0);
  CHECK(occurrences(fuzz_from({first, second, "--cases", "3"}).out, "\nasked 3 of the " + all + " given queries\n") ==
        1);

  // None of the first file's places counts.
  const Run run = fuzz_from({first, second, "--kind", "vertex-face", "--cases", "3"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, ": 3 queries in ") == 1);
  CHECK(occurrences(run.out, "\nasked 3 of the " + std::to_string(faces.queries.size()) + " given queries\n") == 1);

  // So many steps of climbing from the first one take longer than this.
  const Run in_time = fuzz_from({first, "--seconds", "1", "--climb", "1000000"});
  CAPTURE(in_time.out, in_time.err);
  CHECK(occurrences(in_time.out, "\nasked 1 of the " + std::to_string(edges.queries.size()) + " given queries\n") == 1);
}

TEST_CASE("a file outside a folder of a kind is of the one kind asked for, and its cases repeat themselves") {
  const TemporaryFolder folder;
  const std::string loose = folder.write("loose/x.csv", sample_file(Kind::edge_edge, 1, 10).text);
  const Run run = fuzz_from({loose, "--kind", "edge-edge", "--solver", "paper", "--findings", "1"});
  CAPTURE(run.out, run.err);
  REQUIRE(run.status == 1);
  const std::size_t at = run.out.find("'given edge-edge ");
  REQUIRE(at != std::string::npos);
  const std::string name = run.out.substr(at + 1, run.out.find('\'', at + 1) - at - 1);
  CHECK(fuzz_from({loose, "--solver", "paper", "--case", name}).status == 1);
  check_refused(fuzz_from({loose}), "of which kind are its queries?");
  check_refused(fuzz_from({loose, "--kind", "edge-edge", "--kind", "vertex-face"}), "of which kind are its queries?");
}

TEST_CASE("nothing given being of the kind asked for, or of one that the solver takes, is an error that says so") {
  const TemporaryFolder folder;
  const std::string edges = folder.write("edge-edge/x.csv", sample_file(Kind::edge_edge, 1, 1).text);
  const std::string points = folder.write("point-point/x.csv", two_point_queries());
  check_refused(fuzz_from({edges, "--kind", "vertex-face"}),
                "no query that is given is of the kind asked for: vertex-face");
  check_refused(fuzz_from({points, "--solver", "paper"}), "paper takes no queries of the kinds that are given");
  const Run both = fuzz_from({points, edges, "--solver", "paper"});
  CHECK(occurrences(both.out, "; 2 are of a kind that the solver does not take\n") == 1);
}
