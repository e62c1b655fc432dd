// touchstone certify --claims: an answers file in step with the queries.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "io/queries/answer_writer.hpp"
#include "io/times.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// Certifies claims about two_point_queries() in `a.csv`, and about them once more in `b.csv`.
class TwoFiles {
 public:
  TwoFiles() {
    for (const char* name : {"a.csv", "b.csv"}) folder_.write(std::string("point-point/") + name, two_point_queries());
  }

  Run certify(const std::string& claims) const {
    folder_.write("claims.csv", claims);
    RunOptions options;
    options.folder = folder_.path("");
    const Run run =
        run_program({"certify", "--claims", "claims.csv", "point-point/a.csv", "point-point/b.csv"}, options);
    if (run.status == 2) CHECK(run.out == "");
    return run;
  }

  std::string error(const std::string& claims) const {
    const Run run = certify(claims);
    CHECK(run.status == 2);
    return run.err;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("the program's own answers hold, and its toi is never early") {
  const TemporaryFolder folder;
  const std::string strange =
      folder.write("edge-edge/a, \"strange\"\nname.csv", sample_file(Kind::edge_edge, 4, 3).text);
  const std::string plain = folder.write("point-edge/b.csv", sample_file(Kind::point_edge, 4, 3).text);
  REQUIRE(run_program({"solve", "--out", folder.path("answers.csv"), strange, plain}).status == 0);
  for (const std::string threads : {"1", "2", "5"}) {
    const Run run =
        run_program({"certify", "--threads", threads, "--claims", folder.path("answers.csv"), strange, plain});
    CAPTURE(run.out, run.err);
    CHECK(run.status == 0);
    CHECK(occurrences(run.out, "0 to 0 doubles before the exact time; median at least 0 and less than 1\n") == 1);
  }
}

TEST_CASE("a claim one double after the exact time is late, at it or before it holds") {
  const TwoFiles files;
  const double before = 0x1.5555555555555p-2;  // the largest double below 1/3
  const double after = std::nextafter(before, 1.0);
  const auto status = [&](const std::string& toi) {
    return files.certify("query,contact,toi\n0,1," + toi + "\n1,0,\n0,1,\n1,0,\n").status;
  };
  CHECK(status(io::hexfloat(before)) == 0);
  CHECK(status(io::hexfloat(std::nextafter(before, 0.0))) == 0);
  CHECK(status("0") == 0);
  CHECK(status("0.3333333333333333") == 0);
  CHECK(status(io::hexfloat(after)) == 1);
  CHECK(status("0.3333333333333334") == 1);
  CHECK(status("7e300") == 1);
  const Run late = files.certify("toi,query,contact\n" + io::hexfloat(after) + ",0,1\n,1,0\n,0,1\n,1,0\n");
  CHECK(occurrences(late.out, "1 of 4 claims refuted (claims of claims.csv, 2 files)\n") == 1);
  CHECK(occurrences(late.out,
                    "  point-point/a.csv query 0 (rows 1 to 4): late\n"
                    "    claim: contact at 0x1.5555555555556p-2 (0.33333333333333337)\n"
                    "    exact: contact at 0x1.5555555555555p-2 (0.3333333333333333), isolated, p against q\n"
                    "    touchstone explain --query 0 point-point/a.csv\n") == 1);
}

TEST_CASE("a claimed time is compared as it is written, exactly") {
  const TemporaryFolder folder;
  // A point that meets another one at t = 1/2, and one that does at t = 1/10.
  const std::string file = folder.write("point-point/a.csv",
                                        "-1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n"
                                        "-1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n9,1,0,1,0,1,1\n0,1,0,1,0,1,1\n");
  const auto certify = [&](const std::string& half, const std::string& tenth) {
    const std::string claims = "query,contact,toi\n0,1," + half + "\n1,1," + tenth + "\n";
    return run_program({"certify", "--claims", folder.write("c.csv", claims), "--report", folder.path("r.json"), file});
  };
  CHECK(certify("0.5", "0.1").status == 0);
  CHECK(nlohmann::json::parse(folder.read("r.json"))["early"]["ulps"]["most"] == 0);
  CHECK(certify("0.49999999999999999999", "0.09999999999999999999").status == 0);
  CHECK(certify("-1e-400", "1e-400").status == 0);

  const Run late = certify("0.50000000000000000001", "0.10000000000000000000001");
  CHECK(late.status == 1);
  CHECK(occurrences(late.out, "2 of 2 claims refuted") == 1);
  CHECK(occurrences(late.out, "claim: contact at 0.50000000000000000001\n    exact: contact at 0x1p-1 (0.5)") == 1);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  CHECK(report["refuted"][0]["verdict"] == "late");
  CHECK(report["refuted"][0]["claim"] == nlohmann::json{{"contact", 1}, {"toi", "0.50000000000000000001"}});
  CHECK(report["refuted"][1]["claim"] == nlohmann::json{{"contact", 1}, {"toi", "0.10000000000000000000001"}});

  const Run doubles = certify("0.75", "0x1.999999999999ap-4");
  CHECK(doubles.status == 1);
  const auto hexfloats = nlohmann::json::parse(folder.read("r.json"));
  CHECK(hexfloats["refuted"][0]["claim"]["toi"] == "0x1.8p-1");
  CHECK(hexfloats["refuted"][1]["claim"]["toi"] == "0x1.999999999999ap-4");
}

TEST_CASE("missed and phantom claims are refuted whatever the truth column says") {
  const TwoFiles files;
  const Run run = files.certify("query,contact\n0,0\n1,1\n0,1\n1,0\n");
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "  holds       2\n") == 1);
  CHECK(occurrences(run.out, "  missed      1 (") == 1);
  CHECK(occurrences(run.out, "  phantom     1 (") == 1);
  CHECK(occurrences(run.out, "  late        0\n") == 1);
}

TEST_CASE("early claims are counted") {
  const TwoFiles files;
  const Run run = files.certify("query,contact,toi\n0,1,0.25\n1,0,\n0,1,0x1.5555555555555p-2\n1,0,\n");
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "  early       2 claims with a toi that holds\n") == 1);
  CHECK(occurrences(run.out, "0 to 1,501,199,875,790,165 doubles before the exact time") == 1);
  CHECK(occurrences(run.out, "0 to 0.0833 of the step before it") == 1);
}

TEST_CASE("a claims file that is not in step with the queries is refused") {
  const TwoFiles files;
  const std::string head = "file,query,contact\n";
  const std::string a = "point-point/a.csv";
  const std::string b = "point-point/b.csv";
  const std::string rows = a + ",0,1\n" + a + ",1,0\n" + b + ",0,1\n";
  CHECK(files.certify(head + rows + b + ",1,0\n").status == 0);
  CHECK(files.certify(head + "./" + a + ",0,1\npoint-point//a.csv,1,0\n" + b + ",0,1\n" + b + ",1,0\n").status == 0);
  CHECK(files.error(head + rows) ==
        "claims.csv:4: the claims end here, after 3; query 1 of point-point/b.csv has none\n");
  CHECK(files.error(head) == "claims.csv:1: the claims end here, after 0; query 0 of point-point/a.csv has none\n");
  CHECK(files.error(head + rows + b + ",1,0\n" + b + ",2,0\n") ==
        "claims.csv:6: a claim too many; there are only 4 queries in the query files\n");
  CHECK(files.error(head + rows + b + ",2,0\n") ==
        "claims.csv:5: query is 2 where 1 of point-point/b.csv comes next; claims must be in the order of the queries, "
        "one each\n");
  CHECK(
      files.error(head + a + ",0,1\n" + b + ",0,1\n") ==
      "claims.csv:3: file is 'point-point/b.csv' where 'point-point/a.csv' comes next; claims must be in the order of "
      "the queries, and name the files as the command line does\n");
  CHECK(files.error("query,contact\n0,1\n1,0\n2,1\n3,0\n").substr(0, 31) == "claims.csv:4: query is 2 where ");
  CHECK(files.error("query,contact,speed\n") ==
        "claims.csv:1: unknown column 'speed'; the columns are query, contact and optionally file, toi, toi_upper, "
        "nature, feature_a, feature_b, level, starts_within, trend, separation, metric\n");
  CHECK(files.error("query,contact,toi\n0,1,nan\n").substr(0, 26) == "claims.csv:2: toi is 'nan'");
}

TEST_CASE("claims may be a list of booleans in JSON") {
  const TemporaryFolder folder;
  const std::string a = folder.write("point-point/a.csv", two_point_queries());
  const std::string b = folder.write("point-point/b.csv", two_point_queries());
  const std::string claims = folder.path("claims.json");
  const auto certify = [&](const std::string& text, const std::vector<std::string>& options = {}) {
    folder.write("claims.json", text);
    std::vector<std::string> arguments = {"certify", "--claims", claims, a, b};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  };
  const Run good = certify(" [true, false,\n true,false]\n");
  CHECK(good.status == 0);
  CHECK(occurrences(good.out, "all 4 claims hold (claims of " + claims + ", 2 files)\n") == 1);
  const Run wrong = certify("[true,false,false,true]");
  CHECK(wrong.status == 1);
  CHECK(occurrences(wrong.out, "2 of 4 claims refuted") == 1);
  CHECK(occurrences(wrong.out, b + " query 0 (rows 1 to 4): missed") == 1);
  CHECK(occurrences(wrong.out, b + " query 1 (rows 5 to 8): phantom") == 1);
  // The other query has the distance 1/2 and more.
  CHECK(certify("[true,true,true,true]", {"--separation", "4"}).status == 0);

  const auto error = [&](const std::string& text) {
    const Run run = certify(text);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    return run.err;
  };
  CHECK(error("[true,false,true]") == claims + ": the claims end here, after 3; query 1 of " + b + " has none\n");
  CHECK(error("[]") == claims + ": the claims end here, after 0; query 0 of " + a + " has none\n");
  CHECK(error("[true,false,true,false,true]") ==
        claims + ": a claim too many; there are only 4 queries in the query files\n");
  for (const char* text :
       {"[true,1,true,false]", "[true,null,true,false]", "{\"a\": true}", "[true,false", "true", ""}) {
    CAPTURE(text);
    CHECK(error(text).rfind(claims + ": ", 0) == 0);
  }
}

TEST_CASE("a claims file that is missing or a folder is refused") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const Run missing = run_program({"certify", "--claims", folder.path("no.csv"), file});
  CHECK(missing.status == 2);
  CHECK(missing.err == folder.path("no.csv") + ": cannot be opened: No such file or directory\n");
  const Run is_folder = run_program({"certify", "--claims", folder.path("point-point"), file});
  CHECK(is_folder.status == 2);
  CHECK(is_folder.err == folder.path("point-point") + ": is a folder; name the files in it\n");
}

TEST_CASE("a damaged query comes before a missing claim, and the other way round, as they do in the files") {
  const TemporaryFolder folder;
  std::string text = two_point_queries() + two_point_queries();
  text[text.rfind("-1,1")] = 'x';  // in query 2
  const std::string file = folder.write("point-point/a.csv", text);
  const auto error = [&](const std::string& claims) {
    return run_program({"certify", "--claims", folder.write("claims.csv", claims), file}).err;
  };
  CHECK(error("query,contact\n0,1\n1,0\n2,1\n") == file + ":12: x_num is 'x1'; it must be a decimal integer\n");
  CHECK(error("query,contact\n0,1\n") ==
        folder.path("claims.csv") + ":2: the claims end here, after 1; query 1 of " + file + " has none\n");
}
