// touchstone certify --proofs: the proofs of the answers behind the verdicts, which touchstone-check accepts.
// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/certify/certify.hpp"
#include "cli/run_checker.hpp"
#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Words = std::vector<std::string>;

/// Two points that meet at t = 1/2 at the place 1/3, two that never do.
std::string rational_point_queries() {
  return "-1,3,0,1,0,1,1\n1,3,0,1,0,1,1\n1,1,0,1,0,1,1\n1,3,0,1,0,1,1\n"
         "0,1,1,7,0,1,0\n1,1,0,1,0,1,0\n0,1,1,7,0,1,0\n1,1,0,1,0,1,0\n";
}

/// A point that moves along x from -3 to 1 past another at the origin, and one that stays 4 away.
std::string passing_points(const std::string& first_line = {}) {
  return first_line +
         "-3,1,0,1,0,1,1\n0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n"
         "4,1,0,1,0,1,0\n0,1,0,1,0,1,0\n4,1,0,1,0,1,0\n0,1,0,1,0,1,0\n";
}

/// The answers of `sample` as claims. Every third one denies its contact or invents one.
std::string claims_with_faults(const SampleFile& sample) {
  std::string text = "query,contact\n";
  for (std::size_t i = 0; i < sample.answers.size(); ++i) {
    const bool claimed = sample.answers[i].contact != (i % 3 == 0);
    text += std::to_string(i) + (claimed ? ",1\n" : ",0\n");
  }
  return text;
}

/// The proofs with the answer to query `query` turned round: "none" for a contact, a contact at 0 for none.
std::string with_flipped_answer(std::string proofs, std::size_t query) {
  const std::string number = std::string("\n").append(std::to_string(query)) + " ";
  const std::size_t at = proofs.find(number) + number.size();
  REQUIRE(at > number.size());
  const std::size_t end = proofs.find('\n', at);
  return proofs.replace(at, end - at, proofs.compare(at, 4, "none") == 0 ? "contact 0x0p+0 0x0p+0" : "none");
}

void check_accepted(const std::string& proofs, const Words& files) {
  const Run checked = run_checker(proofs, files);
  CAPTURE(checked.out, checked.err);
  CHECK(checked.status == 0);
}

}  // namespace

TEST_CASE("the proofs of judged queries are those that prove writes, whether the claims hold or not", "[slow]") {
  const TemporaryFolder folder;
  const std::string proofs = folder.path("proofs.txt");
  for (const Kind kind : kKinds) {
    const SampleFile sample = sample_file(kind, 8, 4);
    const std::string file = folder.write(std::string(name_of(kind)) + "/a.csv", sample.text);
    REQUIRE(run_program({"prove", "--out", folder.path("proved.txt"), file}).status == 0);
    const std::string proved = folder.read("proved.txt");

    cli::CertifyOptions options;
    options.files = {file};
    options.claims = folder.write("claims.csv", claims_with_faults(sample));
    options.proofs = proofs;
    for (const int threads : {1, 2, 5}) {
      for (const std::size_t chunk : {std::size_t{3}, std::size_t{5000}, io::kChunkBytes}) {
        CAPTURE(name_of(kind), threads, chunk);
        options.threads = threads;
        options.chunk_bytes = chunk;
        const Run run = run_here([&] { return cli::run_certify(options); });
        CHECK(run.status == 1);
        CHECK(occurrences(run.out, "  proofs      " + std::to_string(sample.queries.size()) + " in " + proofs + "\n") ==
              1);
        CHECK((folder.read("proofs.txt") == proved));
      }
    }
    check_accepted(proofs, {file});
    for (const std::string level : {"exact", "fast-cgal"}) {
      CHECK(run_program({"certify", "--level", level, "--proofs", proofs, file}).status == 0);
      CHECK((folder.read("proofs.txt") == proved));
    }
  }
}

TEST_CASE("a flipped answer in a copy of the proofs is rejected, and its query is named") {
  const TemporaryFolder folder;
  for (const Kind kind : kKinds) {
    const SampleFile sample = sample_file(kind, 21, 2);
    const std::string file = folder.write(std::string(name_of(kind)) + "/a.csv", sample.text);
    REQUIRE(run_program({"certify", "--proofs", folder.path("proofs.txt"), file}).status == 0);
    const std::string proofs = folder.read("proofs.txt");
    for (std::size_t i = 0; i < sample.queries.size(); i += 5) {
      const Run checked = run_checker(folder.write("flipped.txt", with_flipped_answer(proofs, i)), {file});
      CAPTURE(name_of(kind), i, checked.err);
      CHECK(checked.status == 1);
      CHECK(checked.err.rfind("rejected: " + file + ": query " + std::to_string(i) + ": ", 0) == 0);
    }
  }
}

TEST_CASE("claims that are not one for each query leave no proofs") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const auto error = [&](const std::string& claims) {
    const Run run = run_program({"certify", "--claims", folder.write("claims.csv", claims), "--proofs",
                                 folder.path("proofs.txt"), "--report", folder.path("r.json"), file});
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK_FALSE(std::filesystem::exists(folder.path("proofs.txt")));
    CHECK_FALSE(std::filesystem::exists(folder.path("r.json")));
    return run.err;
  };
  const std::string claims = folder.path("claims.csv");
  CHECK(error("query,contact\n0,1\n0,1\n1,0\n") == claims + ":3: the second claim about query 0 of " + file + "\n");
  CHECK(error("query,contact\n0,1\n") ==
        claims + ":2: the claims end here, after 1; query 1 of " + file +
            " has none; queries are counted from 0, and with --missing no-contact those without a claim are claimed to "
            "have none\n");
  CHECK(error("query,contact\n1,0\n").rfind(claims + ":2: the claims end here, after 1; query 0 of ", 0) == 0);
  CHECK(error("query,contact\n0,1\n1,0\n2,0\n") ==
        claims + ":4: query is 2, and " + file + " has 2 queries, counted from 0\n");
}

TEST_CASE("a file that is named twice is judged and proved twice") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const std::string claims = folder.write("claims.csv", "query,contact\n0,1\n1,0\n0,0\n1,1\n");
  const std::string proofs = folder.path("proofs.txt");
  CHECK(run_program({"certify", "--claims", claims, "--proofs", proofs, file, file}).status == 1);
  CHECK(occurrences(folder.read("proofs.txt"), "\nfile point-point ") == 2);
  CHECK(occurrences(folder.read("proofs.txt"), "\nend 4 2\n") == 1);
  check_accepted(proofs, {file, file});
  CHECK(run_checker(proofs, {file}).status == 1);
}

TEST_CASE("queries that are no doubles are judged and proved") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", rational_point_queries());
  const std::string claims = folder.write("claims.csv", "query,contact,toi\n0,1,0.51\n1,0,\n");
  const std::string proofs = folder.path("proofs.txt");
  const Run run = run_program({"certify", "--claims", claims, "--proofs", proofs, file});
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "  late        1 (") == 1);
  CHECK(occurrences(folder.read("proofs.txt"), "\n0 contact 0x1p-1 0x1p-1\n") == 1);
  CHECK(occurrences(folder.read("proofs.txt"), "\n1 none\n") == 1);
  check_accepted(proofs, {file});
}

TEST_CASE("proofs overwrite neither an input nor the report") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.txt", two_point_queries());
  const std::string claims = folder.write("claims.txt", "query,contact\n0,1\n1,0\n");
  const auto error = [&](const Words& more) {
    Words arguments = {"certify", "--claims", claims, file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = run_program(arguments);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    return run.err;
  };
  for (const std::string& input : {file, claims}) {
    CHECK(error({"--proofs", input}) == input + ": is also an input; writing there would destroy it\n");
  }
  CHECK(folder.read("point-point/a.txt") == two_point_queries());
  CHECK(folder.read("claims.txt") == "query,contact\n0,1\n1,0\n");

  const std::string out = folder.path("out");
  const std::string also_out = folder.path("point-point/../out");
  CHECK(error({"--report", out, "--proofs", also_out}) ==
        "touchstone: --proofs names " + also_out + ", which another option names too\n");
  CHECK(error({"--report", "-", "--proofs", "-"}) ==
        "touchstone: --proofs names standard output, which another option names too\n");
  CHECK_FALSE(std::filesystem::exists(out));
  CHECK(run_program({"certify", "--report", "/dev/null", "--proofs", "/dev/null", file}).status == 0);
}

TEST_CASE("proofs on standard output stand alone there, and the report is still written") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const Run run = run_program({"certify", "--proofs", "-", "--report", folder.path("r.json"), file});
  CHECK(run.status == 0);
  CHECK(run.err == "");
  CHECK(run.out == run_program({"prove", file}).out);
  CHECK(nlohmann::json::parse(folder.read("r.json"))["claims"]["judged"] == 2);
  check_accepted(folder.write("proofs.txt", run.out), {file});

  const Run report = run_program({"certify", "--report", "-", "--proofs", folder.path("beside.txt"), file});
  CHECK(nlohmann::json::parse(report.out)["claims"]["judged"] == 2);
  CHECK(folder.read("beside.txt") == run.out);
}

TEST_CASE("queries from a pipe are judged and proved, without a digest") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.csv", two_point_queries());
  const std::string command = "cat '" + file + "' | '" TOUCHSTONE_PROGRAM "' certify --kind point-point --proofs '" +
                              folder.path("proofs.txt") + "' /dev/stdin > '" + folder.path("out") + "'";
  CHECK(std::system(command.c_str()) == 0);
  CHECK(folder.read("proofs.txt").rfind("touchstone-proofs 1\nfile point-point - /dev/stdin\n0 contact ", 0) == 0);
  check_accepted(folder.path("proofs.txt"), {file});
}

TEST_CASE("an interrupted run leaves neither proofs nor a report") {
  const TemporaryFolder folder;
  std::string text;
  while (text.size() < 4'000'000) text += two_point_queries();
  const std::string queries = folder.write("point-point/a.csv", text);
  RunOptions options;
  options.interrupt_after = 0.3;
  Words arguments = {
      "certify", "--threads", "2", "--report", folder.path("r.json"), "--proofs", folder.path("proofs.txt")};
  for (int i = 0; i < 200; ++i) arguments.push_back(queries);  // minutes of work
  const Run run = run_program(arguments, options);
  CHECK(run.status == 128 + SIGINT);
  CHECK(folder.names() == std::set<std::string>{"point-point"});
}

TEST_CASE("claims about one file and several separations cannot be proved in one file of proofs") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", passing_points());
  const std::string header = "query,contact,separation,metric\n";
  const auto certify = [&](const std::string& claims, const Words& more) {
    Words arguments = {"certify", "--claims", folder.write("claims.csv", claims), file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  };
  const Words proofs = {"--proofs", folder.path("proofs.txt")};
  for (const auto& [second, name] :
       std::vector<std::pair<std::string, std::string>>{{"0x1p-1,euclidean", "separation 0x1p-1 (0.5), euclidean"},
                                                        {"0x1p-2,max", "separation 0x1p-2 (0.25), max"},
                                                        {"0,euclidean", "touching, which is separation 0"}}) {
    const std::string claims = header + "0,1,0x1p-2,euclidean\n1,0," + second + "\n";
    CHECK(certify(claims, {}).status == 0);
    const Run run = certify(claims, proofs);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(run.err == folder.path("claims.csv") + ":3: the claim is about " + name + ", and the first one about " +
                         file +
                         " is about separation 0x1p-2 (0.25), euclidean; in a file of proofs, as --proofs writes it, "
                         "the queries of a file have one separation\n");
    CHECK_FALSE(std::filesystem::exists(proofs[1]));
  }
  // With distance 0 the metric has no meaning.
  CHECK(certify(header + "0,1,0,euclidean\n1,0,0,max\n", proofs).status == 0);
  CHECK(occurrences(folder.read("proofs.txt"), "separation") == 0);
  check_accepted(proofs[1], {file});
}

TEST_CASE("each file's proofs are about the separation of its claims") {
  const TemporaryFolder folder;
  const std::string first = folder.write("point-point/a.csv", passing_points());
  const std::string second = folder.write("point-point/b.csv", passing_points("# separation 0x1p-1 max\n"));
  const std::string third = folder.write("point-point/c.csv", passing_points("# separation 0.25 euclidean\n"));
  const std::string proofs = folder.path("proofs.txt");
  const auto sections = [&] {
    std::vector<std::string> found;
    const std::string text = folder.read("proofs.txt");
    for (std::size_t at = text.find("\nfile "); at != std::string::npos; at = text.find("\nfile ", at + 1)) {
      const std::size_t line = text.rfind('\n', at - 1) + 1;
      found.push_back(text.compare(line, 11, "separation ") == 0 ? text.substr(line + 11, at - line - 11) : "");
    }
    return found;
  };

  CHECK(run_program({"certify", "--proofs", proofs, first, second, third}).status == 0);
  CHECK(sections() == Words{"", "max 0x1p-1", "euclidean 0x1p-2"});
  check_accepted(proofs, {first, second, third});

  const std::string claims =
      folder.write("claims.csv",
                   "query,contact,separation,metric\n0,1,2,max\n1,1,2,max\n0,1,0,max\n1,0,0,max\n0,1,5,euclidean\n"
                   "1,0,5,euclidean\n");
  CHECK(run_program({"certify", "--claims", claims, "--proofs", proofs, first, second, third}).status == 1);
  CHECK(sections() == Words{"max 0x1p+1", "", "euclidean 0x1.4p+2"});
  check_accepted(proofs, {first, second, third});

  CHECK(run_program({"certify", "--separation", "4", "--proofs", proofs, first, first}).status == 1);
  CHECK(sections() == Words{"euclidean 0x1p+2", "euclidean 0x1p+2"});
  check_accepted(proofs, {first, first});
}

TEST_CASE("the files of the bundled queries are judged and proved, but not those inside the program") {
  const TemporaryFolder folder;
  const std::string proofs = folder.path("proofs.txt");
  Words files;
  for (const auto& file : std::filesystem::recursive_directory_iterator(TOUCHSTONE_BUNDLED_QUERIES)) {
    const std::string path = file.path().string();
    // Curved motion has no proofs.
    const bool curved = file.path().filename().string().rfind("curved_", 0) == 0;
    if (file.path().extension() == ".csv" && !curved) files.push_back(path);
  }
  REQUIRE(files.size() >= 20);
  Words certify = {"certify", "--report", folder.path("r.json"), "--proofs", proofs};
  certify.insert(certify.end(), files.begin(), files.end());
  REQUIRE(run_program(certify).status == 0);
  const auto report = nlohmann::json::parse(folder.read("r.json"));
  const Run checked = run_checker(proofs, files);
  CAPTURE(checked.err);
  CHECK(checked.status == 0);
  CHECK(occurrences(checked.out, std::to_string(report["claims"]["judged"].get<int>()) + " queries checked: ") == 1);

  // Whoever checks the proofs needs the files.
  const std::string none = folder.path("none.txt");
  for (const Words& words :
       {Words{"certify", "--proofs", none}, Words{"prove", "--out", none, "bundled/edge-edge/planar.csv"}}) {
    const Run refused = run_program(words);
    CAPTURE(words, refused.err);
    CHECK(refused.status == 2);
    CHECK(refused.err.rfind("bundled/edge-edge/", 0) == 0);
    CHECK(refused.err.find("is inside the program, where touchstone-check cannot read it") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(none));
  }
}

TEST_CASE("an empty name of a report or of proofs is an error, not a run without them") {
  for (const char* option : {"--report", "--proofs"}) {
    const Run run = run_program({"certify", option, ""});
    CAPTURE(option, run.err);
    CHECK(run.status == 2);
    CHECK(run.err.find("the name is empty") != std::string::npos);
  }
}
