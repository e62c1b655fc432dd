// --separation and --metric: answers, claims and generated sets.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "io/times.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using nlohmann::json;

namespace {

constexpr const char* kQueryHeader =
    "file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level,starts_within,trend,separation,metric\n";

/// A point that moves along x from -3 to 1 past another at the origin, and one that stays 4 away.
std::string passing_points() {
  return "-3,1,0,1,0,1,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n"
         "4,1,0,1,0,1,0\n0,1,0,1,0,1,0\n4,1,0,1,0,1,0\n0,1,0,1,0,1,0\n";
}

void check_refusal(const std::vector<std::string>& arguments, const std::string& message) {
  const Run run = run_program(arguments);
  CAPTURE(arguments);
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(run.err == message + "\n");
}

/// Row `row` of CSV text, counted from 0 after the header, with column `column` replaced.
std::string with_field(const std::string& csv, std::size_t row, std::size_t column, const std::string& value) {
  std::size_t at = 0;
  for (std::size_t i = 0; i <= row; ++i) at = csv.find('\n', at) + 1;
  for (std::size_t i = 0; i < column; ++i) at = csv.find(',', at) + 1;
  return std::string(csv).replace(at, csv.find_first_of(",\n", at) - at, value);
}

/// The truth of one query of a file of one kind, in every row of it, is the other one.
std::string with_flipped_truth(std::string text, Kind kind, std::size_t query) {
  std::size_t row = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    if (text[at] != '#') {
      if (row / (2 * corner_count(kind)) == query) text[end - 1] = text[end - 1] == '1' ? '0' : '1';
      ++row;
    }
    at = end + 1;
  }
  return text;
}

}  // namespace

TEST_CASE("solve writes what a separation's answer has in addition, and the separation itself") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", passing_points());
  const auto rows = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"solve", "--level", "exact", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Run run = run_program(arguments);
    CHECK(run.status == 0);
    CHECK(run.err == "");
    return run.out;
  };
  CHECK(rows({"--separation", "1"}) == kQueryHeader + file +
                                           ",0,1,0.5,0.5,entering,p,q,exact,0,approaching,1,euclidean\n" + file +
                                           ",1,0,,,,,,exact,,,1,euclidean\n");
  CHECK(rows({"--metric", "max", "--separation", "0x1p+2"}) ==
        kQueryHeader + file + ",0,1,0,0,sustained,p,q,exact,1,approaching,4,max\n" + file +
            ",1,1,0,0,sustained,p,q,exact,1,constant,4,max\n");
  // Touching: the answers are those without the option. A negative zero is zero.
  for (const char* zero : {"0", "-0", "0x0p+0"}) {
    CHECK(rows({"--separation", zero}) == kQueryHeader + file + ",0,1,0.75,0.75,isolated,p,q,exact,0,,0,euclidean\n" +
                                              file + ",1,0,,,,,,exact,,,0,euclidean\n");
  }
  CHECK(occurrences(rows({"--separation", "0.1"}), ",0.1,euclidean\n") == 2);
}

TEST_CASE("separation 0 adds columns to the answers and changes none") {
  const TemporaryFolder folder;
  for (const Kind kind : kKinds) {
    const std::string file = folder.write(std::string(name_of(kind)) + "/a.csv", sample_file(kind, 77, 1).text);
    const std::string plain = run_program({"solve", file}).out;
    const std::string zero = run_program({"solve", "--separation", "0", "--metric", "max", file}).out;
    std::string cut;
    for (std::size_t at = 0; at < zero.size();) {
      std::size_t end = zero.find('\n', at);
      const std::string row = zero.substr(at, end - at);
      std::size_t last = row.size();
      for (int i = 0; i < 4; ++i) last = row.rfind(',', last - 1);
      cut += row.substr(0, last) + "\n";
      at = end + 1;
    }
    CHECK(cut == plain);
  }
}

TEST_CASE("a separation without meaning is refused in one line") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", passing_points());
  for (const std::string command : {"solve", "certify"}) {
    const std::string help = " (see touchstone " + command + " --help)";
    for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
             {"-1", "-1 is negative; a separation is a distance, 0 or greater"},
             {"-0x1p-1074", "-0x1p-1074 is negative; a separation is a distance, 0 or greater"},
             {"nan", "nan is no finite number"},
             {"inf", "inf is no finite number"},
             {"thick", "thick is no finite number"},
             {"1e-3 ", "1e-3  is no finite number"},
             {"1e-400", "1e-400 is closer to 0 than any double that is not 0"},
             {"1e400", "1e400 is beyond the greatest double"}}) {
      check_refusal({command, "--separation", text, file}, "touchstone: --separation: " + reason + help);
      check_refusal({command, "--separation=" + text, file}, "touchstone: --separation: " + reason + help);
    }
    check_refusal({command, "--metric", "max", file}, "touchstone: --metric requires --separation" + help);
    check_refusal({command, "--separation", "1", "--metric", "taxi", file},
                  "touchstone: --metric: taxi not in {euclidean,max}" + help);
  }
  check_refusal({"certify", "--separation", "1"},
                "touchstone: --separation goes with files or --claims; the truth column of each bundled file is about "
                "a separation of its own");
}

TEST_CASE("claims say what they are about, and another separation is refused") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", passing_points());
  const std::string claims = folder.path("c.csv");
  REQUIRE(run_program({"solve", "--separation", "0.1", "--metric", "max", "--out", claims, file}).status == 0);
  const std::string about = "separation 0x1.999999999999ap-4 (0.1), max";
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{}, {"--separation", "0.1", "--metric", "max"}}) {
    std::vector<std::string> arguments = {"certify", "--claims", claims, file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Run run = run_program(arguments);
    CHECK(run.status == 0);
    CHECK(run.out.rfind("all 2 claims hold (claims of " + claims + ", 1 file, " + about + ")\n", 0) == 0);
    CHECK(occurrences(run.out, "  contacts    1: 1 entering\n") == 1);
  }
  const std::string start = claims + ":2: the claim is about " + about + "; --separation and --metric ask for ";
  check_refusal({"certify", "--separation", "0.1", "--claims", claims, file},
                start + "separation 0x1.999999999999ap-4 (0.1), euclidean");
  check_refusal({"certify", "--separation", "0.25", "--metric", "max", "--claims", claims, file},
                start + "separation 0x1p-2 (0.25), max");
  check_refusal({"certify", "--separation", "0", "--claims", claims, file}, start + "touching, which is separation 0");

  SECTION("rows may be about different separations") {
    folder.write("c.csv", "query,contact,toi,separation\n0,1,0x1p-1,1\n1,1,0,0x1p+2\n");
    const Run several = run_program({"certify", "--claims", claims, "--report", folder.path("r.json"), file});
    CHECK(several.status == 0);
    CHECK(occurrences(several.out, ", several separations)\n") == 1);
    const json report = json::parse(folder.read("r.json"));
    CHECK_FALSE(report.contains("separation"));
    CHECK(report["natures"]["entering"] == 1);
    CHECK(report["natures"]["sustained"] == 1);
  }
  SECTION("columns without meaning are refused") {
    const auto refuse = [&](const std::string& text, const std::string& message) {
      folder.write("c.csv", text);
      check_refusal({"certify", "--claims", claims, file}, claims + message);
    };
    refuse("query,contact,metric\n0,1,max\n1,0,max\n", ":1: column 'metric' needs column 'separation'");
    refuse("query,contact,separation\n0,1,-1\n1,0,1\n",
           ":2: separation is '-1'; it must be a finite number such as 0x1p-3 or 0.125, 0 or greater");
    refuse("query,contact,separation\n0,1,1\n1,0,\n",
           ":3: separation is ''; it must be a finite number such as 0x1p-3 or 0.125, 0 or greater");
    refuse("query,contact,separation,metric\n0,1,1,taxi\n1,0,1,max\n",
           ":2: metric is 'taxi'; it must be euclidean or max");
  }
}

TEST_CASE("a claimed time is judged against the exact time of the separation, as it is written") {
  const TemporaryFolder folder;
  // |x| = 1/2 at t = 5/8, |x| = 1 at t = 1/2: 0.1 away at t = 29/40, which no double is.
  const std::string file = folder.write("point-point/a.csv", passing_points());
  const auto status = [&](const std::string& toi, const std::string& separation) {
    const std::string claims = folder.write("c.csv", "query,contact,toi\n0,1," + toi + "\n1,0,\n");
    return run_program({"certify", "--separation", separation, "--claims", claims, file}).status;
  };
  CHECK(status("0.5", "1") == 0);
  CHECK(status("0.50000000000000000001", "1") == 1);
  CHECK(status("0x1.4p-1", "0.5") == 0);
  CHECK(status("0x1.4000000000001p-1", "0.5") == 1);
  CHECK(status("0.5", "0.5") == 0);
}

TEST_CASE("generated sets with a separation hold, and a flipped bit is refuted", "[slow]") {
  const TemporaryFolder folder;
  for (const std::string metric : {"euclidean", "max"}) {
    CAPTURE(metric);
    const std::string out = folder.path(metric);
    const Run made = run_program({"generate", "--size", "600", "--steps", "3", "--speed", "4", "--count", "60",
                                  "--separation", "0.01", "--metric", metric, "--out", out});
    CAPTURE(made.err);
    REQUIRE(made.status == 0);
    const std::string about = "separation 0x1.47ae147ae147bp-7 (0.01), " + metric;
    for (const auto& [scene, kind] : std::vector<std::pair<std::string, Kind>>{{"cloth", Kind::edge_edge},
                                                                               {"cloth", Kind::vertex_face},
                                                                               {"sheets", Kind::edge_edge},
                                                                               {"sheets", Kind::vertex_face},
                                                                               {"cables", Kind::edge_edge}}) {
      const std::string name = metric + "/" + scene + "/" + std::string(name_of(kind)) + "/seed-1.csv";
      const std::string file = folder.path(name);
      const std::string text = folder.read(name);
      CAPTURE(name);
      CHECK(text.rfind("# separation 0x1.47ae147ae147bp-7 " + metric + "\n", 0) == 0);

      // The truth column, with and without the option.
      const std::vector<std::string> asked = {"certify", "--separation", "0.01", "--metric", metric, file};
      CHECK(run_program(asked).out.rfind("all 60 claims hold (claims of the truth column, 1 file, " + about + ")\n",
                                         0) == 0);
      CHECK(run_program({"certify", file}).status == 0);
      check_refusal({"certify", "--separation", "0.02", "--metric", metric, file},
                    file + ": its truth column is about " + about +
                        "; --separation and --metric ask for separation 0x1.47ae147ae147bp-6 (0.02), " + metric);
      for (const std::size_t wrong : {std::size_t{0}, std::size_t{31}, std::size_t{59}}) {
        folder.write(name, with_flipped_truth(text, kind, wrong));
        const Run run = run_program(asked);
        CHECK(run.status == 1);
        CHECK(run.out.rfind("1 of 60 claims refuted", 0) == 0);
        CHECK(occurrences(run.out, "  " + file + " query " + std::to_string(wrong) + " (rows ") == 1);
        const std::string explain = " --separation 0x1.47ae147ae147bp-7" +
                                    std::string(metric == "max" ? " --metric max" : "") + " --query " +
                                    std::to_string(wrong) + " ";
        CHECK(occurrences(run.out, "touchstone explain" + explain + file + "\n") == 1);
      }
      folder.write(name, text);

      // The same claims as an answers file.
      const std::string answers = folder.path("answers.csv");
      REQUIRE(run_program({"solve", "--separation", "0.01", "--metric", metric, "--out", answers, file}).status == 0);
      const std::string true_answers = folder.read("answers.csv");
      const auto certify = [&](const std::string& claims) {
        folder.write("answers.csv", claims);
        return run_program({"certify", "--separation", "0.01", "--metric", metric, "--claims", answers, "--report",
                            folder.path("r.json"), file});
      };
      CHECK(certify(true_answers).status == 0);
      // Without a file name's comma, the columns are file, query, contact, toi, ...
      const bool contact = text[text.find('\n', text.find('\n') + 1) - 1] == '1';
      std::string flipped = with_field(true_answers, 0, 2, contact ? "0" : "1");
      if (contact) flipped = with_field(flipped, 0, 3, "");
      CHECK(certify(flipped).status == 1);
      const json report = json::parse(folder.read("r.json"));
      CHECK(report["separation"] == "0x1.47ae147ae147bp-7");
      CHECK(report["metric"] == metric);
      CHECK(report["claims"]["holds"] == 59);
      REQUIRE(report["refuted"].size() == 1);
      CHECK(report["refuted"][0]["query"] == 0);
      CHECK(report["refuted"][0]["verdict"] == (contact ? "missed" : "phantom"));
      CHECK(report["refuted"][0]["metric"] == metric);
    }
  }
}

TEST_CASE("explain tells the distance's polynomials, the feet and the answer, and knows what a file is about") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", passing_points());
  const Run run = run_program({"explain", "--query", "0", "--separation", "1", file});
  CHECK(run.status == 0);
  CHECK(run.err == "");
  for (const char* part :
       {"\nseparation 0x1p+0 (1), euclidean: d below\n",
        "\nthe polynomial of p against q, times a positive number, exactly\n  1     8\n  t     -24\n  t^2   16\n",
        "       distance - d  positive\n     they are farther apart than d\n",
        "  2. t = 0x1p-1 (0.5), a simple root of p against q\n     exactly 1/2\n     they are within d\n",
        "\nanswer: entering contact, first at t = 0x1p-1 (0.5)\n  the distance then falls\n",
        "the file's truth column says 1: holds\n"}) {
    CAPTURE(part);
    CHECK(occurrences(run.out, part) == 1);
  }
  const std::string near = folder.write("point-point/b.csv", "# separation 0x1p+2 max\n" + passing_points());
  CHECK(occurrences(run_program({"explain", "--query", "1", "--separation", "4", "--metric", "max", near}).out,
                    "  they start within d; the distance then stays as it is\n") == 1);
  CHECK(occurrences(run_program({"explain", "--query", "1", near}).out,
                    "the file's truth column is about separation 0x1p+2 (4), max\n") == 1);
}

TEST_CASE("fuzz with a separation breaks the baselines, finds ours right, and its files say the separation") {
  const TemporaryFolder folder;
  const Run ours = run_program({"fuzz", "--separation", "0.5", "--cases", "160"});
  CAPTURE(ours.out);
  CHECK(ours.status == 0);
  CHECK(ours.out.rfind("touchstone judged by exact, separation 0x1p-1 (0.5), euclidean, seed 1: 160 queries in ", 0) ==
        0);
  for (const std::string solver : {"thick_polynomial", "thick_advancement"}) {
    CAPTURE(solver);
    const std::string out = folder.path(solver);
    const Run run = run_program({"fuzz", "--solver", solver, "--separation", "0.5", "--family", "lattice1", "--family",
                                 "near_hit", "--cases", "400", "--findings", "2", "--out", out});
    CHECK(run.status == 1);
    CHECK(occurrences(run.out, "   touchstone fuzz --solver " + solver + " --separation 0x1p-1 --case ") == 2);
    CHECK(occurrences(run.out, "   touchstone explain --separation 0x1p-1 --query 0 ") > 0);
    std::vector<std::string> certify = {"certify", "--separation", "0.5"};
    for (const Kind kind : kKinds) {
      for (const char* failure : {"missed", "late", "phantom"}) {
        const std::string file = out + "/" + std::string(name_of(kind)) + "/" + failure + ".csv";
        if (std::filesystem::exists(file)) certify.push_back(file);
      }
    }
    CHECK(certify.size() > 3);
    CHECK(run_program(certify).status == 0);
    CHECK(run_program({"certify", "--separation", "0.25", certify.back()}).status == 2);
  }
  check_refusal({"fuzz", "--solver", "paper", "--separation", "1"},
                "touchstone: 'paper' is no solver for separation 0x1p+0 (1), euclidean; they are touchstone, exact, "
                "oracle, fast-cgal, batch, thick_advancement, thick_polynomial");
  check_refusal({"fuzz", "--solver", "paper", "--separation", "each"},
                "touchstone: 'paper' is no solver for separations of each query's own, euclidean; they are touchstone, "
                "exact, oracle, fast-cgal, batch, thick_advancement, thick_polynomial");
}

TEST_CASE("report asks about the separation, with the baselines that take one", "[slow]") {
  if (!whole_effort("the program's report with a separation")) return;
  const TemporaryFolder folder;
  const Run report = run_program({"report", "--quick", "--separation", "0.001", "--out", folder.path("r")});
  CAPTURE(report.err);
  REQUIRE(report.status == 0);
  const std::string text = folder.read("r/report.md");
  CHECK(occurrences(text, "touchstone report --seed 1 --quick --separation 0x1.0624dd2f1a9fcp-10`") == 1);
  CHECK(occurrences(text, "`touchstone` is wrong on 0 of ") == 1);
  CHECK(occurrences(text, "- `thick_polynomial`: ") == 1);
  CHECK(occurrences(text, "- `thick_advancement`: ") == 1);
  CHECK(occurrences(text, "conservative_advancement") == 0);
  const std::string csv = folder.read("r/report.csv");
  CHECK(csv.find(",level_oracle,separation,metric\n") < csv.find('\n'));
  CHECK(occurrences(csv, ",0.001,euclidean\n") > 0);
}

TEST_CASE("stress asks about the separation, with the baselines that take one", "[slow]") {
  const TemporaryFolder folder;
  const Run stress = run_program({"stress", "--dial", "sliver", "--count", "4", "--separation", "0.001", "--metric",
                                  "euclidean", "--out", folder.path("s")});
  CAPTURE(stress.err);
  CHECK(stress.status == 0);
  CHECK(occurrences(folder.read("s/stress.md"), "`touchstone` is wrong on 0 of ") == 1);
  CHECK(occurrences(folder.read("s/stress.md"), "| thick_polynomial |") > 0);
  CHECK(occurrences(folder.read("s/stress.csv"), ",0.001,euclidean\n") > 0);
}
