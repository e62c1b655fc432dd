// touchstone certify: the claims that it refutes, its messages and its report.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <touchstone/version.hpp>

#include "cli/certify/certify.hpp"
#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "io/times.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using nlohmann::json;

namespace {

/// The sample as a file in which the truth of each query in `flipped` is wrong.
std::string with_flipped_truth(const SampleFile& sample, const std::vector<std::size_t>& flipped) {
  std::string text;
  for (std::size_t i = 0; i < sample.queries.size(); ++i) {
    const bool wrong = std::find(flipped.begin(), flipped.end(), i) != flipped.end();
    io::append_query(text, sample.queries[i], sample.answers[i].contact != wrong);
  }
  return text;
}

std::size_t first_with_contact(const SampleFile& sample, bool contact) {
  for (std::size_t i = 0; i < sample.answers.size(); ++i) {
    if (sample.answers[i].contact == contact) return i;
  }
  FAIL("no such query");
  return 0;
}

json hexfloat_or_null(bool contact, double value) { return contact ? json(io::hexfloat(value)) : json(nullptr); }

}  // namespace

TEST_CASE("true claims hold at every level") {
  const TemporaryFolder folder;
  const SampleFile sample = sample_file(Kind::edge_edge, 12, 1);
  const std::string file = folder.write("edge-edge/a.csv", sample.text);
  for (const std::string level : {"fast", "exact", "oracle", "fast-cgal"}) {
    const Run run = run_program({"certify", "--level", level, file});
    CAPTURE(run.out, run.err);
    CHECK(run.status == 0);
    CHECK(run.err == "");
    CHECK(run.out.rfind(
              "all " + std::to_string(sample.queries.size()) + " claims hold (claims of the truth column, 1 file)\n",
              0) == 0);
    CHECK(occurrences(run.out, ", 1 thread\n") == 1);  // a file so small is the work of one, however many there are
    if (level == "exact" || level == "oracle")
      CHECK(occurrences(run.out, level + " " + std::to_string(sample.queries.size()) + " (100.0 %)") == 1);
  }
}

TEST_CASE("one flipped truth bit is refuted, and its query is named with the exact answer") {
  for (const Kind kind : kKinds) {
    const TemporaryFolder folder;
    const SampleFile sample = sample_file(kind, 5, 2);
    for (const bool contact : {true, false}) {
      const std::size_t wrong = first_with_contact(sample, contact);
      const std::string file = folder.write(std::string(name_of(kind)) + "/a.csv", with_flipped_truth(sample, {wrong}));
      const std::string rows = std::to_string(2 * corner_count(kind) * wrong + 1) + " to " +
                               std::to_string(2 * corner_count(kind) * (wrong + 1));
      for (const std::string threads : {"1", "2", "5"}) {
        const Run run = run_program({"certify", "--threads", threads, file});
        CAPTURE(run.out);
        CHECK(run.status == 1);
        CHECK(run.out.rfind("1 of " + std::to_string(sample.queries.size()) + " claims refuted", 0) == 0);
        CHECK(occurrences(run.out,
                          "  " + file + " query " + std::to_string(wrong) + " (rows " + rows +
                              "): " + (contact ? "missed" : "phantom") +
                              "\n    claim: " + (contact ? "no contact" : "contact") + "\n    exact: " +
                              (contact ? "contact at " + io::hexfloat(sample.answers[wrong].toi) : "no contact")) == 1);
        CHECK(occurrences(run.out, "touchstone explain --query " + std::to_string(wrong) + " " + file + "\n") == 1);
      }
    }
  }
}

TEST_CASE("the report lists every refuted claim with its exact answer and corners as given") {
  const TemporaryFolder folder;
  const SampleFile sample = sample_file(Kind::vertex_face, 6, 3);
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < sample.queries.size(); i += 7) wrong.push_back(i);
  const std::string good = folder.write("point-point/good.csv", two_point_queries());
  const std::string bad = folder.write("vertex-face/bad.csv", with_flipped_truth(sample, wrong));
  const Run run = run_program({"certify", "--report", folder.path("r.json"), good, bad});
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "and " + std::to_string(wrong.size() - 5) + " more; " + folder.path("r.json") +
                                 " lists them all") == 1);

  const json report = json::parse(folder.read("r.json"));
  CHECK(report["touchstone"] == version());
  CHECK(report["method"] == "fast");
  CHECK(report["claims_from"] == "truth column");
  const std::size_t judged = sample.queries.size() + 2;
  CHECK(report["claims"]["judged"] == judged);
  CHECK(report["claims"]["holds"] == judged - wrong.size());
  CHECK(report["claims"]["missed"].get<std::size_t>() + report["claims"]["phantom"].get<std::size_t>() == wrong.size());
  CHECK(report["claims"]["late"] == 0);
  std::size_t decided = 0;
  for (const char* level : {"filter", "bracket", "exact", "oracle"})
    decided += report["decided_by"][level].get<std::size_t>();
  CHECK(decided == judged);
  std::size_t natures = 0;
  for (const char* nature : {"none", "crossing", "grazing", "sustained", "isolated"}) {
    natures += report["natures"][nature].get<std::size_t>();
  }
  CHECK(natures == judged);
  CHECK(report["early"] == json{{"claims", 0}});
  CHECK(report["late"] == json{{"claims", 0}});
  CHECK_FALSE(report.contains("not_counted"));
  REQUIRE(report["files"].size() == 2);
  CHECK(report["files"][0] ==
        json{{"file", good},
             {"kind", "point-point"},
             {"claims", {{"judged", 2}, {"holds", 2}, {"missed", 0}, {"phantom", 0}, {"late", 0}}}});
  CHECK(report["files"][1]["claims"]["judged"] == sample.queries.size());

  REQUIRE(report["refuted"].size() == wrong.size());
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const json& refuted = report["refuted"][i];
    const Answer& answer = sample.answers[wrong[i]];
    CAPTURE(wrong[i]);
    CHECK(refuted["file"] == bad);
    CHECK(refuted["kind"] == "vertex-face");
    CHECK(refuted["query"] == wrong[i]);
    CHECK(refuted["rows"] == json{8 * wrong[i] + 1, 8 * wrong[i] + 8});
    CHECK(refuted["verdict"] == (answer.contact ? "missed" : "phantom"));
    CHECK(refuted["claim"] == json{{"contact", answer.contact ? 0 : 1}, {"toi", nullptr}});
    CHECK(refuted["answer"]["contact"] == (answer.contact ? 1 : 0));
    CHECK(refuted["answer"]["toi"] == hexfloat_or_null(answer.contact, answer.toi));
    CHECK(refuted["answer"]["toi_upper"] == hexfloat_or_null(answer.contact, answer.toi_upper));
    CHECK(refuted["answer"]["nature"] == (answer.contact ? json(name_of(answer.nature)) : json(nullptr)));
    CHECK(refuted["answer"]["level"] == name_of(answer.level));
    const Fraction x = io::fraction_of(sample.queries[wrong[i]].end[3].x);
    CHECK(refuted["corners"]["f2"]["end"][0] == x.numerator + "/" + x.denominator);
    CHECK(refuted["corners"].size() == 4);
  }
}

TEST_CASE("the report of claims that are early is exact") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const std::string claims = folder.write("c.csv", "query,contact,toi\n0,1,0x1.5555555555551p-2\n1,0,\n");
  REQUIRE(run_program({"certify", "--claims", claims, "--report", folder.path("r.json"), file}).status == 0);
  const json report = json::parse(folder.read("r.json"));
  CHECK(report["claims_from"] == claims);
  CHECK(report["refuted"] == json::array());
  const json early = json::parse(R"({"claims": 1,
      "ulps": {"least": 4, "most": 4, "median": {"from": 4, "below": 8}, "histogram": [{"from": 4, "below": 8, "claims": 1}]},
      "time": {"least": "0x1p-52", "most": "0x1p-52", "median": {"from": "0x1p-52", "below": "0x1p-51"},
               "histogram": [{"from": "0x1p-52", "below": "0x1p-51", "claims": 1}]}})");
  CHECK(report["early"] == early);
}

TEST_CASE("claims that are late within a limit, or wrong in other ways, are counted apart") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  // The first query has a contact at 1/3, the second one none.
  const std::string claims = folder.write("c.csv", "query,contact,toi\n0,1,0x1.5555555555557p-2\n1,1,0.5\n");
  const auto certify = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"certify", "--claims", claims});
    arguments.push_back(file);
    return run_program(arguments);
  };
  const Run plain = certify({"--histogram"});
  CHECK(plain.status == 1);
  CHECK(plain.out.starts_with("2 of 2 claims refuted (claims of "));
  CHECK(occurrences(plain.out, "2 to 2 doubles after the exact time") == 1);
  CHECK(occurrences(plain.out, "how late, in doubles\n    from 1 ") == 1);
  CHECK(occurrences(plain.out, "how early") == 0);
  CHECK(certify({"--late", "1ulps"}).out.starts_with("2 of 2 claims refuted (claims of "));
  const Run late = certify({"--late", "2ulps", "--report", folder.path("r.json")});
  CHECK(late.status == 1);
  CHECK(late.out.starts_with("1 of 2 claims refuted, and 1 late by at most 2ulps (claims of "));
  const json report = json::parse(folder.read("r.json"));
  CHECK(report["claims"]["late"] == 1);
  CHECK(report["late"]["ulps"]["most"] == 2);
  CHECK(report["not_counted"] == json{{"late", {{"claims", 1}, {"ulps", 2}}}});
  CHECK(report["refuted"].size() == 1);
  CHECK(report["refuted"][0]["verdict"] == "phantom");
  const Run missed = certify({"--class", "missed,late", "--late", "1e-9", "--report", folder.path("r.json")});
  CHECK(missed.status == 0);
  CHECK(
      missed.out.starts_with("0 of 2 claims refuted, and 1 late by at most 1e-09, and 1 wrong in other ways than "
                             "missed, late (claims of "));
  CHECK(json::parse(folder.read("r.json"))["not_counted"]["other_classes"] ==
        json{{"claims", 1}, {"than", {"missed", "late"}}});
  // A late time with more digits than a double has is late by one double, not by none.
  folder.write("c.csv", "query,contact,toi\n0,1,0.33333333333333333333333334\n1,0,\n");
  CHECK(certify({"--late", "0"}).status == 1);
  CHECK(certify({"--late", "0ulps"}).status == 1);
  CHECK(certify({"--late", "1ulps"}).status == 0);
  CHECK(certify({"--late", "1ulp"}).status == 0);
  CHECK(occurrences(certify({"--class", "holds"}).err, "--class: holds not in {missed,phantom,late}") == 1);
  CHECK(occurrences(certify({"--late", "2 ulps"}).err, "must be a number of ulps, 16ulps") == 1);
}

TEST_CASE("a decimal stands for itself, and beside a toi_upper for the double that it spells") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  // Above the exact time 1/3, and its nearest double below.
  const std::string row = "0,1,0.33333333333333334", upper = ",0.33333333333333337\n1,0,,\n";
  const std::string alone = folder.write("alone.csv", "query,contact,toi\n" + row + "\n1,0,\n");
  CHECK(run_program({"certify", "--claims", alone, file}).out.starts_with("1 of 2 claims refuted"));
  CHECK(run_program({"certify", "--as-doubles", "--claims", alone, file}).out.starts_with("all 2 claims hold"));
  const std::string both = folder.write("both.csv", "query,contact,toi,toi_upper\n" + row + upper);
  CHECK(run_program({"certify", "--claims", both, file}).out.starts_with("all 2 claims hold"));
  const std::string told = folder.write("told.csv", row + upper);
  CHECK(run_program({"certify", "--columns", "query,contact,toi,toi_upper", "--claims", told, file})
            .out.starts_with("all 2 claims hold"));
  // A number beside it that is no neighbour says nothing.
  const std::string other = folder.write("other.csv", "query,contact,toi,toi_upper\n" + row + ",0.4\n1,0,,\n");
  const Run judged = run_program({"certify", "--json", "--claims", other, file});
  CHECK(judged.err.starts_with("1 of 2 claims refuted"));
  CHECK(json::parse(judged.out.substr(0, judged.out.find('\n')))["claimed_as_written"] == "0.33333333333333334");
}

TEST_CASE("lines of JSON have a verdict for each claim, and the summary is beside them") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const std::string claims = folder.write("c.csv", "query,contact,toi\n0,1,0x1.5555555555557p-2\n1,1,0.5\n");
  const Run run = run_program({"certify", "--json", "--class", "phantom", "--claims", claims, file});
  CHECK(run.status == 1);
  CHECK(run.err.starts_with("1 of 2 claims refuted, and 1 wrong in other ways than phantom (claims of "));
  const std::size_t end = run.out.find('\n');
  const json late = json::parse(run.out.substr(0, end)), phantom = json::parse(run.out.substr(end + 1));
  CHECK(late["verdict"] == "late");
  CHECK(late["refuted"] == false);
  CHECK(late["claimed_contact"] == true);
  CHECK(late["claimed_toi"] == 0x1.5555555555557p-2);
  CHECK(late["toi"] == 0x1.5555555555555p-2);
  CHECK_FALSE(late.contains("separation"));
  CHECK(phantom["query"] == 1);
  CHECK(phantom["contact"] == false);
  CHECK(phantom["toi"].is_null());
  CHECK(phantom["verdict"] == "phantom");
  CHECK(phantom["refuted"] == true);
  const Run truth = run_program({"certify", "--json", "--separation", "0.1", file});
  CHECK(json::parse(truth.out.substr(0, truth.out.find('\n')))["separation"] == 0.1);
  for (const char* const option : {"--report", "--proofs"}) {
    const Run both = run_program({"certify", "--json", option, "-", "--claims", claims, file});
    CHECK(both.status == 2);
    CHECK(occurrences(both.err, std::string(option) + " names standard output, which another option names too") == 1);
  }
}

TEST_CASE("the report is the same for any number of threads and any chunk size") {
  const TemporaryFolder folder;
  const SampleFile sample = sample_file(Kind::edge_edge, 9, 2);
  std::vector<std::size_t> wrong;
  for (std::size_t i = 1; i < sample.queries.size(); i += 3) wrong.push_back(i);
  cli::CertifyOptions options;
  options.files = {folder.write("edge-edge/a.csv", with_flipped_truth(sample, wrong)),
                   folder.write("edge-edge/b.csv", sample.text)};
  options.report = folder.path("r.json");
  std::string first;
  for (const int threads : {1, 2, 5}) {
    for (const std::size_t chunk : {std::size_t{3}, std::size_t{5000}, io::kChunkBytes}) {
      CAPTURE(threads, chunk);
      options.threads = threads;
      options.chunk_bytes = chunk;
      const Run run = run_here([&] { return cli::run_certify(options); });
      CHECK(run.status == 1);
      const std::string report = folder.read("r.json");
      if (first.empty()) first = report;
      REQUIRE(report == first);
    }
  }
  CHECK(json::parse(first)["refuted"].size() == wrong.size());
}

TEST_CASE("a report on standard output stands alone there, and bad UTF-8 in a file's name is replaced") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/\xFF.csv", two_point_queries());
  const Run run = run_program({"certify", "--report", "-", file});
  CHECK(run.status == 0);
  const json report = json::parse(run.out);
  CHECK(report["claims"]["judged"] == 2);
  CHECK(report["files"][0]["file"].get<std::string>().find("\xEF\xBF\xBD.csv") != std::string::npos);
}

TEST_CASE("without a file the bundled queries are certified, and each can be explained by its name", "[slow]") {
  const TemporaryFolder folder;
  const Run run = run_program({"certify", "--report", folder.path("r.json")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  CHECK(occurrences(run.out, "the bundled queries") == 1);
  const json report = json::parse(folder.read("r.json"));
  REQUIRE(report["files"].size() > 0);
  CHECK(report["claims"]["judged"].get<std::size_t>() > report["files"].size());
  for (const json& file : report["files"]) {
    const std::string name = file["file"];
    CAPTURE(name);
    CHECK(name.rfind("bundled/" + file["kind"].get<std::string>() + "/", 0) == 0);
    CHECK(run_program({"explain", "--query", "0", name}).status == 0);
  }
}
