// Files of curved queries on the command line: solve, certify and explain take them beside straight ones, and the other
// commands refuse them.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include <touchstone/curved.hpp>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "io/answers/answer_writer.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/separation_text.hpp"
#include "io/times.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using nlohmann::json;

namespace {

const std::string kHeader = std::string(io::kCurvedHeader) + "\n";

/// A spinning tip that meets a wall at t = 1/2, and one whose wall is on the other side.
const std::string kTip = kHeader +
                         "# the tip of a rod\nquery,1\nmotion,0,1,0,0,0,1,0,0,1,0,0,0,0,0,0\nbody,0,5,0,0\n"
                         "curve,2,4,0\ncurve,4,4,-1\ncurve,4,4,1\n"
                         "query,0\nmotion,2,1,0,0,0,1,0,0,1,0,0,0,0,0,0\nbody,2,5,0,0\n"
                         "curve,-2,-4,0\ncurve,-4,-4,-1\ncurve,-4,-4,1\n";

/// Bodies that turn about axes through small integers, and curves through them: many of them touch.
std::vector<CurvedQuery> some_queries(Kind kind, std::size_t count) {
  std::vector<CurvedQuery> queries;
  seeded::Rng rng(7);
  const auto vector = [&](int size) {
    const double x = rng.between(-size, size), y = rng.between(-size, size), z = rng.between(-size, size);
    return Vec3{x, y, z};
  };
  while (queries.size() < count) {
    CurvedQuery query;
    query.kind = kind;
    for (RigidMotion& motion : query.motions) {
      motion.q1[static_cast<std::size_t>(rng.between(1, 3))] = rng.between(-1, 1);
      motion.p0 = vector(1);
      motion.p1 = vector(1);
    }
    for (std::size_t i = 0; i < corner_count(kind); ++i) {
      const bool second = kind == Kind::edge_edge ? i >= 2 : i >= 1;
      query.corners[i] = CurvedCorner::on_body(second ? 1 : 0, vector(2));
      if (second && queries.size() % 3 == 0)
        query.corners[i] = CurvedCorner::on_curve({vector(1), vector(2), vector(1)});
    }
    queries.push_back(query);
  }
  return queries;
}

std::string text_of(const std::vector<CurvedQuery>& queries, bool flipped = false, const Separation& separation = {}) {
  std::string text = separation.distance > 0 ? io::separation_comment(separation) + kHeader : kHeader;
  for (const CurvedQuery& query : queries)
    io::append_query(text, query, solve(query, {.separation = separation}).contact != flipped);
  return text;
}

/// The program with the options that ask for the separation.
Run run_with(const Separation& separation, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--separation", io::hexfloat(separation.distance), "--metric",
                                     std::string(name_of(separation.metric))});
  return run_program(arguments);
}

}  // namespace

TEST_CASE("solve answers curved files beside straight ones, as the library does") {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  std::string expected = std::string(io::kAnswerHeader);
  for (const Kind kind : kKinds) {
    const std::string name(name_of(kind));
    const std::vector<CurvedQuery> queries = some_queries(kind, effort(60));
    files.push_back(folder.write(name + "/curved.csv", text_of(queries)));
    for (std::size_t i = 0; i < queries.size(); ++i) {
      io::append_answer(expected, files.back(), i, solve(queries[i]), io::Numbers::decimals);
    }
    const SampleFile sample = sample_file(kind, 3, 1);
    files.push_back(folder.write(name + "/straight.csv", sample.text));
    for (std::size_t i = 0; i < sample.queries.size(); ++i) {
      io::append_answer(expected, files.back(), i, sample.answers[i], io::Numbers::decimals);
    }
  }
  for (const std::string threads : {"1", "2", "7"}) {
    std::vector<std::string> arguments = {"solve", "--threads", threads};
    arguments.insert(arguments.end(), files.begin(), files.end());
    const Run run = run_program(arguments);
    CAPTURE(threads, run.err);
    CHECK(run.status == 0);
    CHECK(run.out == expected);
  }
  const Run judged = run_program({"certify", files[0], files[1], files[2], files[3]});
  CAPTURE(judged.out);
  CHECK(judged.status == 0);
  // The kind of a file in another folder.
  const std::string other = folder.write("else/where.csv", text_of(some_queries(Kind::point_edge, 5)));
  CHECK(run_program({"solve", other}).status == 2);
  CHECK(run_program({"certify", "--kind", "point-edge", other}).status == 0);
}

TEST_CASE("longer turns are told once a file, and --shorter-turn takes the shorter ones") {
  const TemporaryFolder folder;
  // The tip turns by 5.7 degrees. With the other sign of q1 it goes nearly once around, through a wall.
  const auto query = [](const char* q1) {
    return "query,0\nmotion,0,1,0,0,0," + std::string(q1) +
           ",0,0,0,0,0,0\nbody,0,1,0,0\ncurve,-2,-0.5,-1\ncurve,2,-0.5,-1\ncurve,0,-0.5,2\n";
  };
  const std::string shorter = query("1,0,0,0.05"), longer = query("-1,0,0,-0.05");
  const std::string file = folder.write("vertex-face/a.csv", kHeader + shorter + longer + longer);
  const std::string one = folder.write("vertex-face/one.csv", kHeader + longer);
  const std::string none = folder.write("vertex-face/none.csv", kHeader + shorter);
  const std::string told =
      "touchstone: " + file +
      ": warning: 2 motions, the first in row 9, take the longer of two turns (q0 . q1 < 0), as recorded poses with "
      "the other sign do; --shorter-turn takes the shorter ones\n";
  for (const char* threads : {"1", "3"}) {
    const Run run = run_program({"solve", "--threads", threads, file, none, one});
    CHECK(run.status == 0);
    CHECK(run.err == told + "touchstone: " + one +
                         ": warning: the motion in row 3 takes the longer of two turns (q0 . q1 < 0), as recorded "
                         "poses with the other sign do; --shorter-turn takes the shorter ones\n");
    CHECK(occurrences(run.out, ",1,0.") == 3);
  }
  const Run solved = run_program({"solve", "--shorter-turn", file});
  CHECK(occurrences(solved.out, ",1,0.") == 0);
  CHECK(solved.err == "touchstone: " + file +
                          ": q1 of 2 motions, the first in row 9, has got the other sign, for the shorter turn\n");
  CHECK(run_program({"solve", none}).err.empty());
  // certify, and the command that it names.
  const Run judged = run_program({"certify", file});
  CHECK(judged.status == 1);
  CHECK(judged.err == told);
  const Run holds = run_program({"certify", "--shorter-turn", file});
  CHECK(holds.status == 0);
  const std::string claims = folder.write("claims.csv", "query,contact\n0,0\n1,1\n2,0\n");
  const Run refuted = run_program({"certify", "--shorter-turn", "--claims", claims, file});
  CHECK(occurrences(refuted.out, "    touchstone explain --query 1 " + file + " --shorter-turn\n") == 1);
  const Run proofs = run_program({"certify", "--shorter-turn", "--proofs", folder.path("p.txt"), file});
  CHECK(proofs.status == 2);
  CHECK(occurrences(proofs.err, "touchstone-check reads the queries as the file has them") == 1);
  // explain: of the one query alone.
  CHECK(run_program({"explain", "--query", "0", file}).err.empty());
  const Run explained = run_program({"explain", "--query", "1", file});
  CHECK(occurrences(explained.err, ": warning: the motion in row 9 takes the longer of two turns") == 1);
  CHECK(occurrences(explained.out, "\nanswer: no contact") == 0);
  CHECK(occurrences(run_program({"explain", "--query", "1", "--shorter-turn", file}).out, "\nanswer: no contact") == 1);
  // fuzz, which asks about the file as it is.
  const Run fuzzed = run_program({"fuzz", "--from", file, "--cases", "1"});
  CHECK(occurrences(fuzzed.err, file + ": warning: 2 motions, the first in row 9, take the longer of two turns") == 1);
  CHECK(occurrences(fuzzed.err, "; convert --shorter-turn --claims solve writes a file with the shorter ones\n") == 1);
  // prove, which is about the file as it is, and convert, which makes another.
  const Run proved = run_program({"prove", file});
  CHECK(proved.status == 0);
  CHECK(occurrences(proved.err, "convert --shorter-turn --claims solve writes a file with the shorter ones\n") == 1);
  const std::string other = folder.path("vertex-face/other.csv");
  CHECK(run_program({"convert", file, other, "--to", "hexfloat"}).err == told);
  const Run kept = run_program({"convert", "--shorter-turn", file, other, "--to", "hexfloat"});
  CHECK(kept.status == 2);
  CHECK(occurrences(kept.err, "--claims solve") == 1);
  CHECK(run_program({"convert", "--shorter-turn", "--claims", "solve", file, other, "--to", "hexfloat"}).status == 0);
  const Run again = run_program({"certify", other});
  CHECK(again.status == 0);
  CHECK(again.err.empty());
}

TEST_CASE("every level answers a curved file alike") {
  const TemporaryFolder folder;
  const std::string file = folder.write("vertex-face/a.csv", text_of(some_queries(Kind::vertex_face, effort(30))));
  std::string first;
  for (const std::string level : {"fast", "exact", "oracle", "fast-cgal"}) {
    const Run run = run_program({"solve", "--level", level, file});
    CHECK(run.status == 0);
    std::string decisions;  // all columns but the last, which names the level
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) decisions += line.substr(0, line.rfind(',')) + "\n";
    CAPTURE(level);
    if (!first.empty()) CHECK(decisions == first);
    first = decisions;
  }
}

TEST_CASE("claims about curved queries are judged: missed, phantom, late, or they hold") {
  const TemporaryFolder folder;
  const std::string file = folder.write("vertex-face/tip.csv", kTip);
  const auto judged = [&](const std::string& rows, const std::string& report = "r.json") {
    const std::string claims = folder.write("claims.csv", "query,contact,toi\n" + rows);
    return run_program({"certify", "--claims", claims, "--report", folder.path(report), file});
  };
  CHECK(judged("0,1,0.5\n1,0,\n").status == 0);
  CHECK(judged("0,1,0.25\n1,0,\n").status == 0);
  const Run missed = judged("0,0,\n1,1,0.25\n");
  CHECK(missed.status == 1);
  CHECK(occurrences(missed.out, "  missed      1 (") == 1);
  CHECK(occurrences(missed.out, "  phantom     1 (") == 1);
  const Run late = judged("0,1,0x1.0000000000001p-1\n1,0,\n");
  CHECK(late.status == 1);
  CHECK(occurrences(late.out, "  " + file + " query 0 (rows 3 to 8): late\n") == 1);
  CHECK(occurrences(late.out, "    exact: contact at 0x1p-1 (0.5), crossing, v against f\n") == 1);
  CHECK(occurrences(late.out, "    touchstone explain --query 0 " + file + "\n") == 1);
  const json refuted = json::parse(folder.read("r.json"))["refuted"];
  REQUIRE(refuted.size() == 1);
  CHECK(refuted[0]["kind"] == "vertex-face");
  CHECK(refuted[0]["verdict"] == "late");
  CHECK(refuted[0]["rows"] == json{3, 8});
  CHECK(refuted[0]["corners"]["v"] == json{{"motion", 0}, {"point", {"0x1.4p+2", "0x0p+0", "0x0p+0"}}});
  CHECK(refuted[0]["corners"]["f1"] == json{{"curve", {{"0x1p+2", "0x1p+2", "-0x1p+0"}}}});
  CHECK(refuted[0]["motions"]["0"]["q1"] == json{"0x1p+0", "0x0p+0", "0x0p+0", "0x1p+0"});
  CHECK(refuted[0]["motions"].size() == 1);
  // A time that is no double is compared exactly: 0.3333333333333333333 is before 1/3, 0.3333333333333333334 after it.
  const std::string third = folder.write(
      "vertex-face/third.csv", kHeader + "query,1\ncurve,0,0,1,0,0,-2\ncurve,-1,-1,0\ncurve,1,-1,0\ncurve,0,1,0\n");
  for (const auto& [toi, status] : {std::pair{"0.3333333333333333333", 0}, std::pair{"0.3333333333333333334", 1}}) {
    const std::string claims = folder.write("third-claims.csv", std::string("query,contact,toi\n0,1,") + toi + "\n");
    CHECK(run_program({"certify", "--claims", claims, third}).status == status);
  }
  const Run flipped =
      run_program({"certify", folder.write("edge-edge/flipped.csv", text_of(some_queries(Kind::edge_edge, 8), true))});
  CHECK(flipped.status == 1);
  CHECK(flipped.out.rfind("8 of 8 claims refuted", 0) == 0);
}

TEST_CASE("the story of a curved query tells its motions, V, the roots, the answer and all contact times") {
  const TemporaryFolder folder;
  const std::string file = folder.write("vertex-face/tip.csv", kTip);
  const Run run = run_program({"explain", "--query", "0", file});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(run.out.rfind("query 0 of " + file + " (rows 3 to 8), vertex-face, curved motion\n", 0) == 0);
  // V is 2 times (10 t - 4 (1 + t^2)), times a positive constant.
  for (const char* part :
       {"  0 at 0    q = (1, 0, 0, 0), p = (0, 0, 0)\n    at 1    q = (1, 0, 0, 1), p = (0, 0, 0)\n",
        "            turns by about 90 degrees, about the axis (0, 0, 1)\n",
        "  v         on motion 0, at (5, 0, 0) of its body\n", "  f1        at rest at (4, 4, -1)\n",
        "\nthe coplanarity V(t), times a positive function of t that makes it a polynomial, exactly: degree ",
        " t = 0x1p-1 (0.5), a simple root of V\n     exactly 1/2\n",
        "\nanswer: crossing contact, first at t = 0x1p-1 (0.5)\n  v        at 1 v\n  f        at 0.5 f0 + 0.25 f1 + "
        "0.25 f2\n",
        "contact times\n  t = 0x1p-1 (0.5)\n", "the file's truth column says 1: holds\n"}) {
    CAPTURE(part);
    CHECK(occurrences(run.out, part) == 1);
  }
  const Run none = run_program({"explain", "--query", "1", file});
  CHECK(occurrences(none.out, "\nanswer: no contact\ncontact times: none\n") == 1);
  CHECK(occurrences(none.out, "  2 at 0    q = (1, 0, 0, 0)") == 1);
  const Run before = run_program({"explain", "--query", "0", "--t-max", "0.25", file});
  CHECK(occurrences(before.out, "answer: no contact for t in [0, 0.25]\ncontact times: none\n") == 1);
  const std::string arc = folder.write(
      "point-edge/arc.csv", kHeader + "query,1\ncurve,-1,0,0,0,0,2,1,0,0\ncurve,-0.75,0,0.75\ncurve,0.75,0,0.75\n");
  const Run twice = run_program({"explain", "--query", "0", arc});
  CAPTURE(twice.out);
  CHECK(occurrences(twice.out, "  p         on the curve of the control points (-1, 0, 0), (0, 0, 2), (1, 0, 0)\n") ==
        1);
  CHECK(occurrences(twice.out, "contact times\n  t = 0x1p-2 (0.25)\n  t = 0x1.8p-1 (0.75)\n") == 1);
  CHECK(run_program({"explain", "--query", "2", file}).err ==
        file + ": has no query 2; it has 2 queries, counted from 0\n");
}

TEST_CASE("curved queries are proved, by certify too") {
  const TemporaryFolder folder;
  const std::string file = folder.write("vertex-face/tip.csv", kTip);
  const Run proofs = run_program({"prove", file});
  CHECK(proofs.status == 0);
  CHECK(occurrences(proofs.out, "touchstone-proofs 1\nfile vertex-face ") == 1);
  CHECK(occurrences(proofs.out, "\nend 2 1\n") == 1);
  CHECK(run_program({"certify", "--proofs", folder.path("proofs.txt"), file}).status == 0);
  CHECK(folder.read("proofs.txt") == proofs.out);
}

TEST_CASE("a separation of curved queries: all levels answer as the library does, and claims say what they are about",
          "[slow]") {
  const TemporaryFolder folder;
  std::size_t contacts = 0;
  std::size_t starting = 0;
  for (const Separation& separation : {Separation{0.75}, Separation{0.5, Metric::max}}) {
    const std::string about =
        separation.metric == Metric::max ? "separation 0x1p-1 (0.5), max" : "separation 0x1.8p-1 (0.75), euclidean";
    for (const Kind kind : kKinds) {
      const std::vector<CurvedQuery> queries = some_queries(kind, effort(12));
      const std::string file = folder.write(std::string(name_of(kind)) + "/a.csv", text_of(queries, false, separation));
      std::string expected(io::kSeparationAnswerHeader);
      for (std::size_t i = 0; i < queries.size(); ++i) {
        const Answer answer = solve(queries[i], {.separation = separation});
        contacts += answer.contact ? 1 : 0;
        starting += answer.starts_within ? 1 : 0;
        io::append_answer(expected, file, i, answer, separation, io::Numbers::decimals);
      }
      const std::string claims = folder.path("claims.csv");
      REQUIRE(run_with(separation, {"solve", "--out", claims, file}).status == 0);
      CAPTURE(about, name_of(kind));
      CHECK(folder.read("claims.csv") == expected);
      for (const std::string level : {"exact", "oracle"}) {
        const Run run = run_program({"certify", "--level", level, "--claims", claims, file});
        CHECK(run.status == 0);
        CHECK(occurrences(run.out, "(claims of " + claims + ", 1 file, " + about + ")\n") == 1);
      }
      // The truth column, whose separation the file says, and all of it turned round.
      CHECK(run_program({"certify", file}).status == 0);
      CHECK(run_with(separation, {"certify", file}).status == 0);
      CHECK(run_program({"certify", file, "--separation", "3"}).status == 2);
      const std::string flipped =
          folder.write(std::string(name_of(kind)) + "/flipped.csv", text_of(queries, true, separation));
      const Run refuted = run_program({"certify", "--report", folder.path("r.json"), flipped});
      CHECK(refuted.status == 1);
      const json report = json::parse(folder.read("r.json"));
      CHECK(report["refuted"].size() == queries.size());
      CHECK(report["refuted"][0]["separation"] == io::hexfloat(separation.distance));
    }
  }
  if (!whole_effort("that some of the queries have contact, and some at the start")) return;
  CHECK(starting > 0);
  CHECK(contacts > starting);
}

TEST_CASE("the story of a separation of a curved query tells the polynomials of the distance and the course of it") {
  const TemporaryFolder folder;
  const std::string file = folder.write("vertex-face/tip.csv", kTip);
  // The wall is the triangle (2, 4, 0), (4, 4, +-1), and the tip is at (4, 3) at t = 1/3. Its height there is 4 - 1.
  const Run run = run_program({"explain", "--query", "0", "--separation", "1", file});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  for (const char* part :
       {"\nseparation 0x1p+0 (1), euclidean: d below\n", "\nthe polynomial of v against f12",
        ", times a positive function of t, exactly: degree ", ", a simple root of v against f12\n",
        "     they are within d\n",
        "\nanswer: entering contact, first at t in [0x1.5555555555555p-2, 0x1.5555555555556p-2] (0.3333333333333333)\n"
        "  the distance then falls\n",
        "contact times\n  t in [0x1.5555555555555p-2, 0x1.5555555555556p-2] (0.3333333333333333) to t ",
        "the file's truth column says 1: holds\n"}) {
    CAPTURE(part);
    CHECK(occurrences(run.out, part) >= 1);
  }
  const Run far = run_program({"explain", "--query", "0", "--separation", "0x1p-1", "--t-max", "0.25", file});
  CHECK(occurrences(far.out, "answer: no contact for t in [0, 0.25]\ncontact times: none\n") == 1);
  const Run box = run_program({"explain", "--query", "0", "--separation", "1", "--metric", "max", file});
  CAPTURE(box.out);
  CHECK(box.status == 0);
  CHECK(occurrences(box.out, "\nseparation 0x1p+0 (1), max: d below\n") == 1);
  CHECK(occurrences(box.out, "  normal ") == 0);
  // A time that is no double: 1/3 is the exact one.
  for (const auto& [toi, status] : {std::pair{"0.3333333333333333333", 0}, std::pair{"0.3333333333333333334", 1}}) {
    const std::string claims = folder.write("c.csv", std::string("query,contact,toi\n0,1,") + toi + "\n1,0,\n");
    CHECK(run_program({"certify", "--separation", "1", "--claims", claims, file}).status == status);
  }
}

TEST_CASE("bench takes curved files as sets of their own") {
  const TemporaryFolder folder;
  const std::string file = folder.write("vertex-face/tip.csv", kTip);
  const Run bench = run_program({"bench", "--filter", "^files", "--count", "10", "--min-time", "0.0001", file});
  CAPTURE(bench.out, bench.err);
  CHECK(bench.status == 0);
  CHECK(occurrences(bench.out, "files-curved/vertex-face/all: 2 queries, 50.0 % with contact") == 1);
}
