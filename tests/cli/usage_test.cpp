// The program's arguments, messages and exit statuses.
// SPDX-License-Identifier: MIT
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <touchstone/version.hpp>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

/// Bad usage: status 2, nothing on standard output, one line on standard error.
void check_refused(const std::vector<std::string>& arguments, const std::string& part) {
  const Run run = run_program(arguments);
  CAPTURE(arguments, run.err);
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(occurrences(run.err, part) == 1);
}

}  // namespace

TEST_CASE("the program says what it is and how it is used") {
  const Run version = run_program({"--version"});
  CHECK(version.status == 0);
  CHECK(version.out == std::string("touchstone ") + touchstone::version() + "\n");
  const Run help = run_program({"--help"});
  CHECK(help.status == 0);
  CHECK(help.err == "");
  for (const char* word :
       {"solve", "certify", "explain", "Exit status: 0", "x_num,x_den,y_num,y_den,z_num,z_den,truth"}) {
    CAPTURE(word);
    CHECK(occurrences(help.out, word) > 0);
  }
  for (const char* command : {"solve", "certify", "explain"}) {
    const Run run = run_program({command, "--help"});
    CHECK(run.status == 0);
    CHECK(occurrences(run.out, "--kind") > 0);
  }
}

TEST_CASE("bad usage ends with status 2 and one line") {
  check_refused({}, "subcommand");
  check_refused(
      {"juggle"},
      "juggle is no subcommand; they are solve, certify, explain, view, prove, convert, generate, bench, report, "
      "fuzz, fuzz-steps, audit, stress, simulate, mesh, bodies, merge, scenes and doctor");
  check_refused({"certify", "a.csv", "--level", "fast", "--level", "exact"}, "--level");
  check_refused({"explain", "--query", "99999999999999999999", "a.csv"}, "--query");
  check_refused({"solve"}, "FILE");
  check_refused({"explain", "a.csv"}, "--query");
  check_refused({"explain", "--query", "1"}, "FILE");
  check_refused({"certify", "--speed", "9"}, "--speed");
  check_refused({"certify", "--threads", "0"}, "--threads");
  check_refused({"certify", "--threads", "-1"}, "--threads");
  check_refused({"certify", "--threads", "2000"}, "--threads");
  check_refused({"certify", "--threads", "two"}, "--threads");
  check_refused({"certify", "--level", "best", "a.csv"}, "--level");
  check_refused({"certify", "--kind", "edge-face", "a.csv"}, "edge-face is no kind");
  check_refused({"certify", "--kind", "edge-edge"}, "the bundled queries know theirs");
  check_refused({"explain", "--query", "-1", "a.csv"}, "--query");
  check_refused({"explain", "--query", "0", "--t-max", "1.5", "a.csv"}, "--t-max");
  check_refused({"explain", "--query", "0", "--t-max", "nan", "a.csv"}, "--t-max");
}

TEST_CASE("a mistyped name is answered with the nearest one") {
  check_refused({"solv"}, "solv is no subcommand; did you mean solve? The others are in touchstone --help");
  check_refused({"sovle"}, "did you mean solve?");
  check_refused({"certify", "--claim", "a.csv"},
                "--claim is no option of touchstone certify; did you mean --claims? (see touchstone certify --help)");
  check_refused({"certify", "--claim=a.csv"}, "--claim is no option of touchstone certify; did you mean --claims?");
  check_refused({"certify", "--frobnicate"}, "--frobnicate is no option of touchstone certify (see ");
  check_refused({"--versoin"}, "--versoin is no option of touchstone; did you mean --version?");
  check_refused({"doctor", "now"}, "now is one argument too many for touchstone doctor (see touchstone doctor --help)");
  check_refused({"simulate", "hop"}, "nut-and-bolt; did you mean hoop?");
  check_refused({"help", "sovle"}, "sovle is no subcommand; did you mean solve?");
  check_refused({"help", "solve", "mesh"}, "help takes the name of one command");
  check_refused({"--threads", "2", "solve", "a.csv"},
                "--threads stands behind the command: touchstone solve --threads");
}

TEST_CASE("help and a command's name print the command's help") {
  CHECK(run_program({"help", "mesh"}).out == run_program({"mesh", "--help"}).out);
  CHECK(run_program({"help"}).out == run_program({"--help"}).out);
  CHECK(run_program({"help"}).status == 0);
  CHECK(run_program({"help", "describe"}).out == run_program({"describe", "--help"}).out);
}

TEST_CASE("a dash is standard input, for queries and for claims") {
  const TemporaryFolder folder;
  const SampleFile sample = sample_file(Kind::edge_edge, 12, 1);
  const std::string file = folder.write("edge-edge/a.csv", sample.text);
  RunOptions options;
  options.standard_input = file;
  const Run solved = run_program({"solve", "--kind", "edge-edge", "-"}, options);
  CAPTURE(solved.err);
  CHECK(solved.status == 0);
  check_refused({"solve", "--kind", "edge-edge", "-", "-"}, "- is given twice, and standard input can be read once");
  check_refused({"certify", "--claims", "-", "-"}, "- is given twice");
  const Run over = run_program({"solve", "--kind", "edge-edge", "--out", file, "-"}, options);
  CHECK(over.status == 2);
  CHECK(occurrences(over.err, "is also an input; writing there would destroy it") == 1);
  options.standard_input = folder.write("answers.csv", solved.out);
  const Run judged = run_program({"certify", "--columns", "-,query,hit,toi,-,-,-,-,-", "--claims", "-", file}, options);
  CAPTURE(judged.out, judged.err);
  CHECK(judged.status == 0);
  CHECK(occurrences(judged.out, std::to_string(sample.queries.size()) + " claims hold (claims of -, 1 file)") == 1);
}

TEST_CASE("kinds have the names that other programs give them, too") {
  const TemporaryFolder folder;
  const std::string rows = folder.write("q.csv", "0,0,0\n1,0,0\n0,1,1\n0,2,1\n0,0,0\n1,0,0\n0,1,1\n0,2,1\n");
  for (const auto& [kind, names] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"edge-edge", {"EE", "Edge_Edge", "segment-segment"}},
           {"vertex-face", {"VF", "PT", "vt", "point-triangle", "Vertex-Triangle", "point-face"}},
           {"point-edge", {"PE", "vertex-edge", "point_segment"}},
           {"point-point", {"PP", "vv", "vertex-vertex"}}}) {
    const Run plain = run_program({"solve", "--kind", kind, rows});
    for (const std::string& name : names) {
      const Run run = run_program({"solve", "--kind", name, rows});
      CAPTURE(name);
      CHECK(run.out == plain.out);
      CHECK(run.err == plain.err);
      CHECK(run.status == plain.status);
    }
  }
  check_refused({"solve", "--kind", "edge-face", rows}, "edge-face is no kind");
  for (const char* const name : {"fv", "Face_Vertex", "face-point", "triangle-vertex"}) {
    check_refused({"solve", "--kind", name, rows},
                  " is called vertex-face, and its corners come in the order v f0 f1 f2");
  }
  for (const char* const name : {"ev", "edge-vertex", "segment-point"}) {
    check_refused({"generate", "--kind", name, "--out", folder.path("g")}, "its corners come in the order p e0 e1");
  }
}

TEST_CASE("queries of decimals are solved, and what a proof is about is fractions") {
  const TemporaryFolder folder;
  const std::string whole =
      folder.write("edge-edge/whole.csv", "-1,0,0,1,0,0,0,-1,0.1,0,1,0.1,-1,0,0,1,0,0,0,-1,-0.2,0,1,-0.2,1\n");
  const std::string contact = ",0,1,0.3333333333333333,0.33333333333333337,crossing,a,b,";
  CHECK(occurrences(run_program({"solve", whole}).out, contact + "exact\n") == 1);
  CHECK(occurrences(run_program({"solve", "--as-doubles", whole}).out, contact + "bracket\n") == 1);
  CHECK(run_program({"certify", whole}).out.starts_with("all 1 claims hold"));
  const std::string told = "4 coordinates of the files are decimals that no double equals, and were taken as written";
  CHECK(occurrences(run_program({"certify", whole}).out, told + "; --as-doubles takes the nearest doubles\n") == 1);
  CHECK(occurrences(run_program({"certify", "--report", "-", whole}).err, told) == 1);
  CHECK(occurrences(run_program({"solve", whole}).err, told) == 1);
  CHECK(occurrences(run_program({"solve", "--out", folder.path("o.csv"), whole}).out, told) == 1);
  CHECK(run_program({"solve", "--as-doubles", whole}).err == "");
  for (const bool doubles : {false, true}) {  // a page's command is that of its query
    std::vector<std::string> words = {"explain", "--query", "0", "--html", folder.path("page.html"), whole};
    if (doubles) words.insert(words.begin() + 1, "--as-doubles");
    REQUIRE(run_program(words).status == 0);
    CHECK((occurrences(folder.read("page.html"), " --as-doubles") > 0) == doubles);
  }
  // The names that pandas gives columns would be read as a query.
  std::string counted = "0";
  for (int i = 1; i < 25; ++i) counted += "," + std::to_string(i);
  const std::string row = folder.read("edge-edge/whole.csv");
  check_refused({"solve", folder.write("edge-edge/pandas.csv", counted + "\n" + row)},
                ":1: the first row counts from 0, as pandas names columns");
  const std::string named_ones = "x,y,z,x,y,z,x,y,z,x,y,z,x,y,z,x,y,z,x,y,z,x,y,z,truth\n";
  CHECK(run_program({"solve", folder.write("edge-edge/named_ones.csv", named_ones + row)}).status == 0);
  CHECK(occurrences(run_program({"explain", "--query", "0", whole}).out, "z  1/10   no double") == 2);
  const std::string ones = "1,1,1,1,1,1, 1\r\n";
  const std::string blanks = folder.write("point-point/blanks.csv", ones + ones + ones + ones);
  CHECK(run_program({"prove", "--out", folder.path("p.txt"), blanks}).status == 0);
}

TEST_CASE("numbers beyond the doubles are called what they are, and long ones are not repeated whole") {
  const std::string digits(100'000, '1');
  check_refused({"explain", "--query", "0", "--t-max", "1e-400", "a.csv"},
                "--t-max: 1e-400 is closer to 0 than any double that is not 0");
  check_refused({"explain", "--query", "0", "--t-max", "1e400", "a.csv"}, "1e400 is beyond the greatest double");
  check_refused({"explain", "--query", "0", "--t-max", "half", "a.csv"}, "half is no finite number");
  check_refused({"fuzz", "--seconds", "1e-400"}, "1e-400 is closer to 0 than any double that is not 0");
  check_refused({"fuzz", "--limit", "1e400"}, "1e400 is beyond the greatest double");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"explain", "--query", "0", "--t-max", digits, "a.csv"},
                                             {"explain", "--query", digits, "a.csv"},
                                             {"explain", "--query=" + digits, "a.csv"},
                                             {"certify", "--threads", digits},
                                             {"certify", "--kind", digits, "a.csv"},
                                             {"certify", "--level", digits},
                                             {"certify", "--" + digits},
                                             {digits},
                                             {"fuzz", "--seconds", digits},
                                             {"fuzz", "--early", digits},
                                             {"fuzz", "--early", digits + "ulps"},
                                             {"fuzz", "--limit", digits},
                                             {"fuzz", "--seed", digits},
                                             {"fuzz", "--family", digits},
                                             {"fuzz", "--case", digits},
                                             {"fuzz", "--solver", digits},
                                             {"generate", "--seed", digits, "--out", "x"},
                                             {"generate", "--scene", digits, "--out", "x"},
                                             {"bench", "--filter", "(" + digits},
                                             {"stress", "--dial", digits, "--out", "x"},
                                             {"simulate", "hoop", "--size", digits},
                                             {"simulate", digits},
                                             {"solve", digits},
                                             {"solve", "--kind", "point-point", "--out", "x/" + digits, "/dev/null"},
                                             {"simulate", "hoop", "--narrow-phase", digits}}) {
    const Run run = run_program(arguments);
    CAPTURE(arguments[0], run.err);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(run.err.size() < 2000);
  }
}

TEST_CASE("a file's hostile number is not repeated whole") {
  const TemporaryFolder folder;
  const std::string digits(100'000, '1');
  const auto check_short = [](const std::vector<std::string>& arguments) {
    const Run run = run_program(arguments);
    CAPTURE(arguments[0], run.err);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, "\n") == 1);
    CHECK(run.err.size() < 1000);
  };
  std::string queries = two_point_queries();
  check_short({"solve", folder.write("point-point/a.csv", digits + queries)});
  check_short({"solve", folder.write("point-point/b.csv", digits + "e5" + queries)});
  const std::string good = folder.write("point-point/c.csv", queries);
  for (const std::string& row : {digits + ",1,0.25", "0," + digits + ",0.25", "0,1," + digits, "0,1,x" + digits,
                                 "0,1,0." + digits, "0,1,1e-" + digits, "0,1,0x1p-" + digits}) {
    check_short({"certify", "--claims", folder.write("d.csv", "query,contact,toi\n" + row + "\n"), good});
  }
  check_short({"certify", "--claims", folder.write("e.csv", digits + ",query,contact\n"), good});
  for (const std::string& scene :
       {"{\"touchstone_scene\": " + digits + "}", "{\"touchstone_scene\": 1, \"settings\": {\"drag\": " + digits + "}}",
        "{\"touchstone_scene\": 1, \"" + digits + "\": 1}", "{\"touchstone_scene\": 1, \"settings\": " + digits + "x}",
        "{\"touchstone_scene\": 1, \"settings\": {\"integrator\": \"" + digits + "\"}}", "[" + digits + "e]", digits,
        "\"" + digits}) {
    check_short({"simulate", folder.write("s.json", scene), "--steps", "0"});
  }
}

TEST_CASE("files that are missing, folders, or of no known kind end with status 2 and one line") {
  const TemporaryFolder folder;
  const std::string text = two_point_queries();
  const std::string good = folder.write("point-point/good.csv", text);
  const std::string no_kind = folder.write("x/a.csv", text);
  const std::string missing = folder.path("point-point/missing.csv");
  for (const std::string command : {"solve", "certify"}) {
    check_refused({command, good, missing}, missing + ": cannot be opened: No such file or directory");
    check_refused({command, folder.path("point-point")}, folder.path("point-point") + ": is a folder");
    check_refused({command, no_kind}, no_kind + ": of which kind are its queries?");
    CHECK(run_program({command, "--kind", "point-point", no_kind}).status == 0);
    check_refused({command, folder.write("point-point/empty.csv", "")}, "point-point/empty.csv: holds no query");
  }
  check_refused({"explain", "--query", "0", missing}, missing + ": cannot be opened: No such file or directory");
}

TEST_CASE("a file in the working folder is of that folder's kind") {
  const TemporaryFolder folder;
  folder.write("point-point/a.csv", two_point_queries());
  RunOptions options;
  options.folder = folder.path("point-point");
  CHECK(run_program({"certify", "a.csv"}, options).status == 0);
}

TEST_CASE("an output whose name has the ending of another format is refused, with a name that is right") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& name,
                           const std::string& right) {
    std::vector<std::string> words = arguments;
    words.insert(words.end(), {folder.path(name), file});
    check_refused(words, folder.path(name) + " has the ending of another format; what is written is " + right);
    CHECK_FALSE(std::filesystem::exists(folder.path(name)));
  };
  const std::string page = "a page, HTML with pictures (SVG) in it: name it " + folder.path("picture.html");
  refused({"view", "--query", "0", "--out"}, "picture.png", page);
  refused({"explain", "--query", "0", "--html"}, "picture.SVG", page);
  refused({"mesh", "--html"}, "picture.pdf",
          "a page, HTML with pictures (SVG) in it, or a moving picture: name it " + folder.path("picture.html"));
  refused({"solve", "--out"}, "a.json", "CSV: name it " + folder.path("a.csv") + "; --json writes lines of JSON");
  refused({"solve", "--out"}, "a.csv.gz", "CSV: name it " + folder.path("a.csv") + "; --json");
  refused({"solve", "--json", "--out"}, "a.csv", "lines of JSON: name it " + folder.path("a.jsonl"));
  refused({"certify", "--report"}, "r.html", "JSON: name it " + folder.path("r.json"));
  refused({"prove", "--out"}, "p.npz", "text: name it " + folder.path("p.txt"));
  refused({"prove", "--out"}, "p.v", "text: name it " + folder.path("p.txt"));
  for (const char* const name : {"a.tsq", "a.obj", "a.v", "a.PLY", "a.jsonl", "a.gltf"}) {
    refused({"solve", "--out"}, name, "CSV: name it " + folder.path("a.csv"));
  }
  for (const char* const option : {"--csv", "--json"}) {
    const std::string right = option == std::string("--csv") ? "CSV: name it " + folder.path("t.csv")
                                                             : "JSON: name it " + folder.path("t.json");
    refused({"bench", option}, "t.tsq", right);
  }
  refused({"scenes", "--csv"}, "t.html", "CSV: name it " + folder.path("t.csv"));
  for (const char* const option : {"--proof", "--energies"}) {
    refused({"simulate", option}, "t.json", "CSV: name it " + folder.path("t.csv"));
  }
  for (const char* const option : {"--checkpoint", "--scene-out"}) {
    refused({"simulate", option}, "t.csv", "JSON: name it " + folder.path("t.json"));
  }
  for (const char* const name : {"a.csv", "a.txt", "a", "a.1", "a.CSV"}) {
    CHECK(run_program({"solve", "--out", folder.path(name), file}).status == 0);
  }
  CHECK(run_program({"solve", "--json", "--out", folder.path("a.json"), file}).status == 0);
  CHECK(run_program({"view", "--query", "0", "--out", folder.path("a.htm"), file}).status == 0);
}

TEST_CASE("an output that cannot be written ends with status 2") {
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/a.csv", two_point_queries());
  RunOptions options;
  SECTION("a full disk") {
    const std::string reason = ": cannot be written: No space left on device\n";
    const auto device = folder.full_device();
    if (!device) {
      WARN("no device can be made here (that needs root): skipped");
      return;
    }
    check_refused({"solve", "--out", *device, file}, *device + reason);
    check_refused({"certify", "--report", *device, file}, *device + reason);
    CHECK(std::filesystem::is_character_file(*device));
    options.standard_output = *device;
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--help"},
                                               {"--version"},
                                               {"solve", file},
                                               {"certify", file},
                                               {"certify", "--report", "-", file},
                                               {"explain", "--query", "0", file}}) {
      const Run run = run_program(arguments, options);
      CAPTURE(arguments);
      CHECK(run.status == 2);
      CHECK(run.err == "standard output" + reason);
    }
  }
  SECTION("a pipe whose reader has gone") {
    options.closed_pipe = true;
    const Run run = run_program({"solve", file}, options);
    CHECK(run.status == 128 + SIGPIPE);  // as of other programs before `head`
    CHECK(run.err == "");
  }
  SECTION("a folder, and a place in no folder") {
    check_refused({"solve", "--out", folder.path(""), file}, ": is a folder; name a file to write");
    check_refused({"certify", "--report", folder.path("no/r.json"), file}, ": cannot be written: No such file");
  }
  SECTION("a file that is read") {
    check_refused({"solve", "--out", file, file}, ": is also an input");
    const std::string plain = folder.write("point-point/a", two_point_queries());
    check_refused({"certify", "--report", plain, plain}, ": is also an input");
    const std::string claims = folder.write("claims.json", "[true, false]");
    check_refused({"certify", "--claims", claims, "--report", claims, file}, ": is also an input");
    CHECK(folder.read("point-point/a.csv") == two_point_queries());
  }
}
