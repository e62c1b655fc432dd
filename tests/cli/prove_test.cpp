// touchstone prove: the text of proofs, whatever the number of threads.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "cli/run_checker.hpp"
#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/proofs/proof_file.hpp"
#include "io/sha256.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

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

TEST_CASE("a name that spaces begin, or of spaces alone, is a path that begins with a dot") {
  const TemporaryFolder folder;
  RunOptions options;
  options.folder = folder.path(".");
  for (const std::string name : {"  ", " a b"}) {
    const std::string file = folder.write(name, two_point_queries());
    const Run run = run_program({"prove", "--kind", "point-point", "--out", "proofs.txt", name}, options);
    CAPTURE(name, run.err);
    REQUIRE(run.status == 0);
    CHECK(occurrences(folder.read("proofs.txt"), " ./" + name + "\n") == 1);
    CHECK(run_checker(folder.path("proofs.txt"), {file}).status == 0);
  }
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

TEST_CASE("a theorem is about one query of one file") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a \"*).csv", two_point_queries());
  const std::string out = folder.path("query_0.v");
  const Run written = run_program({"prove", "--theorem", "0", "--out", out, file});
  CAPTURE(written.err);
  REQUIRE(written.status == 0);
  CHECK(written.out == "query 0 of " + file + " (rows 1 to 4), point-point: a theorem in " + out + "\n");
  const std::string text = folder.read("query_0.v");
  CAPTURE(text);
  CHECK(run_program({"prove", "--theorem", "0", file}).out == text);
  CHECK(first_line(text).rfind("(* query 0 of ", 0) == 0);
  CHECK(occurrences(first_line(text), "/a \\x22\\x2a).csv (rows 1 to 4), point-point; SHA-256 of the file " +
                                          io::sha256(two_point_queries())) == 1);
  CHECK(occurrences(text, "\nTheorem query_0 : holds\n") == 1);
  CHECK(occurrences(run_program({"prove", "--theorem", "1", file}).out, "\n  No_contact.\n") == 1);
  CHECK(occurrences(run_program({"prove", "--theorem", "1", "--separation", "1", "--metric", "max", file}).out,
                    "apart := Max 1 |}\n  (Contact_at 0).\n") == 1);
}

TEST_CASE("prove --theorem refuses what names no query, and leaves no file") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const std::string out = folder.path("t.v");
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& reason) {
    std::vector<std::string> all = {"prove", "--out", out};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Run run = run_program(all);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(occurrences(run.err, reason) == 1);
    CHECK_FALSE(std::filesystem::exists(out));
  };
  refused({"--theorem", "2", file}, file + ": has no query 2; it has 2 queries, counted from 0");
  refused({"--theorem", "-1", file}, "-1 must be a number counted from 0");
  refused({"--theorem", "x", file}, "x must be a number counted from 0");
  refused({"--theorem", "0", file, file}, "--theorem: a theorem is about one query: name one file");
  refused({file, "--theorem"}, "--theorem");
  const std::string decimals = folder.write("point-point/decimals.csv", "0.5,0,0\n1,0,0\n0,0,0\n1,0,1\n");
  refused({"--theorem", "0", decimals}, "has decimals; a proof is about fractions with commas alone");
  CHECK(run_program({"prove", "--theorem", "0", "--out", file, file}).status == 2);
  CHECK(folder.read("point-point/a.csv") == two_point_queries());
}

TEST_CASE("a theorem is written to a file whose name coqc takes") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  for (const char* const name : {"t.txt", "t", "1.v", "_t.v", "a-b.v", "a b.v", ".v", "t.V", "\xC3\xA4.v"}) {
    const Run run = run_program({"prove", "--theorem", "1", "--out", folder.path(name), file});
    CAPTURE(name, run.err);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, "is no name of a theory") == 1);
    CHECK(occurrences(run.err, "name it " + folder.path("query_1.v")) == 1);
    CHECK_FALSE(std::filesystem::exists(folder.path(name)));
  }
  CHECK(run_program({"prove", "--theorem", "1", "--out", folder.path("T_1.v"), file}).status == 0);
}

TEST_CASE("prove and certify read the files that the checker reads, with and without --theorem") {
  const TemporaryFolder folder;
  const std::string truth = "0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n";
  std::string semicolons = truth, words = truth;
  std::replace(semicolons.begin(), semicolons.end(), ',', ';');
  for (std::size_t at = 0; (at = words.find(",1\n", at)) != std::string::npos;) words.replace(at, 3, ",True\n");
  const std::string fractions = folder.write("point-point/fractions.csv", truth);
  const std::string array = folder.path("point-point/array.npy"), binary = folder.path("binary.tsq");
  REQUIRE(run_program({"convert", "--claims", "drop", fractions, array}).status == 0);
  REQUIRE(run_program({"convert", fractions, binary}).status == 0);
  const std::vector<std::pair<std::string, std::string>> refused = {
      {array, ": is a file of doubles"},
      {binary, ": is a file of doubles"},
      {folder.write("point-point/decimals.csv", "0,0,0,1\n1,0,0,1\n1,0,0,1\n0,0,0,1\n"), ": has decimals"},
      {folder.write("point-point/semicolons.csv", semicolons), ": has quotes, separators that are no commas, or"},
      {folder.write("point-point/mark.csv", "\xEF\xBB\xBF" + truth), ": has quotes, separators that are no commas, or"},
      {folder.write("point-point/names.csv", "a,b,c,d,e,f,truth\n" + truth), ":1: names columns"},
      {folder.write("point-point/true it is.csv", words), ":1: a truth is no plain 0 or 1"},
  };
  for (const auto& [file, reason] : refused) {
    REQUIRE(run_program({"solve", file}).status == 0);  // others read it
    std::vector<std::vector<std::string>> runs = {{"prove", file}, {"prove", "--theorem", "0", file}};
    if (file != array) runs.push_back({"certify", "--proofs", folder.path("p.txt"), file});
    for (const auto& words_of_run : runs) {
      const Run run = run_program(words_of_run);
      CAPTURE(words_of_run, run.err);
      CHECK(run.status == 2);
      CHECK(run.out == "");
      CHECK(occurrences(run.err, file + reason) == 1);
      CHECK(occurrences(run.err, "touchstone convert --kind point-point ") == 1);
    }
    const std::string out = folder.path("point-point/out.csv");
    REQUIRE(run_program({"convert", "--kind", "point-point", file, out}).status == 0);  // as the message says
    REQUIRE(run_program({"prove", "--out", folder.path("p.txt"), out}).status == 0);
    CHECK(run_checker(folder.path("p.txt"), {out}).status == 0);
    CHECK(occurrences(run_program({"prove", "--theorem", "0", out}).out,
                      io::sha256(folder.read("point-point/out.csv"))) == 1);
    std::filesystem::remove(folder.path("p.txt"));
  }
  CHECK(occurrences(run_program({"prove", "--theorem", "0", "bundled/point-point/collinear.csv"}).err,
                    "proofs go with files") == 1);
}

TEST_CASE("an answer that has no proof is an error that names its query") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const auto inputs = cli::find_inputs({file}, std::nullopt);
  cli::ProvedQueries proved;
  const auto error = [&](std::size_t query) {
    std::string message;
    cli::for_each_query(inputs, [&](std::size_t, const io::QueryRecord& record) {
      if (record.number != query) return;
      Answer answer = cli::answer_to(record.query, Method::fast, {});
      answer.contact = true;  // a claim of no contact would be refuted as well, after a long search
      answer.toi = answer.toi_upper = 0;
      try {
        proved.add(inputs[0], record, answer, {});
      } catch (const FileError& thrown) {
        message = thrown.what();
      }
    });
    return message;
  };
  CHECK(error(0) == file + ":1: query 0: the elements are not in contact: there is no proof that they are");
  CHECK(error(1) == file + ":5: query 1: the elements are not in contact: there is no proof that they are");
}

TEST_CASE("proofs with a separation name it before each file, and the number of threads changes no byte", "[slow]") {
  const TemporaryFolder folder;
  for (const Kind kind : kKinds) {
    const SampleFile sample = sample_file(kind, 6, static_cast<int>(effort(5)));
    const std::string first = folder.write(std::string(name_of(kind)) + "/a.csv", sample.text);
    const std::string second = folder.write("point-point/b.csv", two_point_queries());
    for (const std::string metric : {"euclidean", "max"}) {
      std::string proofs;
      for (const char* threads : {"1", "2", "7"}) {
        const Run run = run_program({"prove", "--separation", "0.125", "--metric", metric, "--threads", threads,
                                     "--out", folder.path("proofs.txt"), first, second});
        CAPTURE(name_of(kind), metric, threads, run.out, run.err);
        REQUIRE(run.status == 0);
        CHECK(occurrences(run.out, " (separation 0x1p-3 (0.125), " + metric + ")\n") == 1);
        const std::string text = folder.read("proofs.txt");
        if (proofs.empty()) proofs = text;
        CHECK((text == proofs));
      }
      CHECK(occurrences(proofs, "\nseparation " + metric + " 0x1p-3\nfile ") == 2);
      const Run checked = run_checker(folder.path("proofs.txt"), {first, second});
      CAPTURE(checked.out, checked.err);
      CHECK(checked.status == 0);
    }
  }
}

TEST_CASE("separation 0 is touching: the proofs are those without the option") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const std::string plain = run_program({"prove", file}).out;
  CHECK(run_program({"prove", "--separation", "0", "--metric", "max", file}).out == plain);
  CHECK(run_checker(folder.write("proofs.txt", plain), {file}).status == 0);
  const Run negative = run_program({"prove", "--separation", "-1", file});
  CHECK(negative.status == 2);
  CHECK(negative.out == "");
  CHECK(occurrences(negative.err, "-1 is negative; a separation is a distance, 0 or greater") == 1);
  CHECK(run_program({"prove", "--separation", "each", file}).status == 2);
}
