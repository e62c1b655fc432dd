// touchstone explain: one query's story.
// SPDX-License-Identifier: MIT
#include <string>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "io/times.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("the story of a query tells its corners, its cubic, its candidates and its answer") {
  const TemporaryFolder folder;
  // Edge a stands still along x; edge b, along y, comes down through its middle at t = 1/2: V = 2 - 4 t times 4.
  const Query query(EdgeEdge{{Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, -1, 1}, Vec3{0, 1, 1}},
                             {Vec3{-1, 0, 0}, Vec3{1, 0, 0}, Vec3{0, -1, -1}, Vec3{0, 1, -1}}});
  std::string text = "# one comment\n";
  io::append_query(text, query, true);
  const std::string file = folder.write("edge-edge/a.csv", text);
  const Run run = run_program({"explain", "--query", "0", file});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(run.err == "");
  CHECK(run.out.rfind("query 0 of " + file + " (rows 2 to 9), edge-edge\n", 0) == 0);
  for (const char* part :
       {"  a0 at 0 x  -1  -0x1p+0\n", "  b1 at 1 x  0   0x0p+0\n",
        "\nthe coplanarity cubic V(t), times a positive number, exactly\n  1     4\n  t     -8\n  t^2   0\n  t^3   0\n",
        "\ncandidate times in [0, 1]: 1\n", "  1. t = 0x1p-1 (0.5), a simple root of V\n", "     exactly 1/2\n",
        "     they touch\n", "\nanswer: crossing contact, first at t = 0x1p-1 (0.5)\n",
        "  a        at 0.5 a0 + 0.5 a1\n", "  b        at 0.5 b0 + 0.5 b1\n",
        "the file's truth column says 1: holds\n"}) {
    CAPTURE(part);
    CHECK(occurrences(run.out, part) == 1);
  }
  CHECK((occurrences(run.out, "  positive\n") + occurrences(run.out, "  negative\n")) >= 3);

  const Run before = run_program({"explain", "--query", "0", "--t-max", "0.25", file});
  CHECK(occurrences(before.out, "\nanswer: no contact for t in [0, 0.25]\n") == 1);
}

TEST_CASE("any query of a file can be told, of every kind, with the answer that solve gives") {
  for (const Kind kind : kKinds) {
    const TemporaryFolder folder;
    const SampleFile sample = sample_file(kind, 21, 1);
    const std::string file = folder.write(std::string(name_of(kind)) + "/a.csv", sample.text);
    for (std::size_t i = 0; i < sample.queries.size(); i += 5) {
      const Run run = run_program({"explain", "--query", std::to_string(i), file});
      CAPTURE(run.out, run.err, i);
      CHECK(run.status == 0);
      const Answer& answer = sample.answers[i];
      CHECK(occurrences(run.out, "\nanswer: no contact\n") == (answer.contact ? 0 : 1));
      if (answer.contact) {
        CHECK(occurrences(run.out, "\nanswer: " + std::string(name_of(answer.nature)) + " contact, first at t ") == 1);
        CHECK(occurrences(run.out.substr(run.out.find("\nanswer: ")), io::hexfloat(answer.toi)) == 1);
      }
      CHECK(occurrences(run.out, " says " + std::string(answer.contact ? "1" : "0") + ": holds\n") == 1);
      CHECK(occurrences(run.out, "coplanarity cubic V(t), times a positive number, exactly") ==
            (kind == Kind::edge_edge || kind == Kind::vertex_face ? 1 : 0));
    }
  }
}

TEST_CASE("rational coordinates are told as given") {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("point-point/a.csv", "1,3,0,1,0,1,0\n1,3,-1,2,0,1,0\n1,3,0,1,0,1,0\n1,3,1,2,0,1,0\n");
  const Run run = run_program({"explain", "--query", "0", file});
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "  p at 0  x  1/3   no double\n") == 1);
  CHECK(occurrences(run.out, "the file's truth column says 0: missed\n") == 1);
}

TEST_CASE("a query that is not there is refused, and one in a damaged file is named") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const Run run = run_program({"explain", "--query", "2", file});
  CHECK(run.status == 2);
  CHECK(run.err == file + ": has no query 2; it has 2 queries, counted from 0\n");
  const std::string damaged = folder.write("point-point/b.csv", two_point_queries() + "0,1\n");
  const Run cut = run_program({"explain", "--query", "2", damaged});
  CHECK(cut.status == 2);
  CHECK(cut.err ==
        damaged + ":9: 2 columns; a row has 7: x_num,x_den,y_num,y_den,z_num,z_den,truth, or 6 without truth\n");
}
