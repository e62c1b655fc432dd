// touchstone convert: from each format to each other and back, and what is refused.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

Run convert(const std::string& from, const std::string& to, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"convert", from, to});
  return run_program(more);
}

void check_refused(const Run& run, const std::string& reason) {
  CAPTURE(run.err, reason);
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(occurrences(run.err, "\n") == 1);
  CHECK(occurrences(run.err, reason) == 1);
}

/// An answers file without its first column, the file's name.
std::string answers(const std::string& file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"solve", file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = run_program(arguments);
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  std::string text;
  for (const std::string& line : lines_of(run.out)) text += line.substr(line.find(',')) + "\n";
  return text;
}

}  // namespace

TEST_CASE("every way through the formats and back to CSV gives the same bytes, for any number of threads", "[slow]") {
  const TemporaryFolder folder;
  for (const Kind kind : kKinds) {
    const std::string name(name_of(kind));
    CAPTURE(name);
    const std::string csv = folder.write(name + "/a.csv", sample_file(kind, 11, 12).text);
    const auto path = [&](const std::string& file) { return folder.path(std::string(name).append("/").append(file)); };
    REQUIRE(convert(csv, path("b.tsq")).status == 0);
    REQUIRE(convert(path("b.tsq"), path("c.csv"), {"--to", "hexfloat"}).status == 0);
    REQUIRE(convert(path("c.csv"), path("d.tsq"), {"--threads", "2"}).status == 0);
    REQUIRE(convert(path("d.tsq"), path("e.csv")).status == 0);
    CHECK(folder.read(name + "/b.tsq") == folder.read(name + "/d.tsq"));
    CHECK(folder.read(name + "/e.csv") == folder.read(name + "/a.csv"));

    REQUIRE(convert(path("b.tsq"), path("f.npy"), {"--claims", "drop"}).status == 0);
    REQUIRE(convert(path("f.npy"), path("g.csv"), {"--claims", "solve", "--threads", "1"}).status == 0);
    CHECK(folder.read(name + "/g.csv") == folder.read(name + "/a.csv"));

    const std::string expected = answers(csv);
    for (const std::string file : {"b.tsq", "f.npy", "e.csv"}) {
      for (const std::string threads : {"1", "2"}) {
        CAPTURE(file, threads);
        CHECK(answers(path(file), {"--threads", threads}) == expected);
      }
    }
  }
}

TEST_CASE("a binary file is certified, explained and asked like the CSV file that it was") {
  const TemporaryFolder folder;
  const std::string csv = folder.write("point-point/a.csv", "# separation 0x1p-2 max\n" + two_point_queries());
  const std::string binary = folder.path("a.tsq");  // the file itself says its kind
  const Run run = convert(csv, binary);
  CHECK(run.status == 0);
  CHECK(run.out == "2 queries of " + csv + " written to " + binary + " (binary, point-point, with claims)\n");
  const Run certified = run_program({"certify", binary});
  CHECK(certified.status == 0);
  CHECK(occurrences(certified.out, "separation 0x1p-2 (0.25), max") == 1);
  const Run explained = run_program({"explain", "--query", "0", "--separation", "0.25", "--metric", "max", binary});
  CHECK(explained.status == 0);
  CHECK(occurrences(explained.out, "(rows 1 to 4)") == 1);
  CHECK(occurrences(explained.out, "truth column says 1: holds") == 1);

  const std::string array = folder.path("a.npy");
  CHECK(convert(binary, array, {"--claims", "drop"}).status == 0);
  check_refused(run_program({"certify", array}), "a.npy: query 0 has no claim; name a file of claims (--claims)");
  const Run without_claims = run_program({"explain", "--query", "0", array});
  CHECK(without_claims.status == 0);
  CHECK(occurrences(without_claims.out, "truth column") == 0);
  CHECK(run_program({"solve", "--out", folder.path("answers.csv"), array}).status == 0);
  CHECK(run_program({"certify", "--claims", folder.path("answers.csv"), array}).status == 0);
  check_refused(run_program({"prove", "--out", folder.path("proofs.txt"), binary}),
                "a.tsq: is a file of doubles; a proof is about fractions with commas alone");
}

TEST_CASE("rows of six columns have no claims, and other formats get none") {
  const TemporaryFolder folder;
  const std::string csv = folder.write("point-point/a.csv", two_point_queries());
  const std::string bare = folder.path("point-point/bare.csv");
  CHECK(convert(csv, bare, {"--claims", "drop"}).status == 0);
  CHECK(folder.read("point-point/bare.csv").rfind("0,1,0,1,0,1\n1,1,0,1,0,1\n", 0) == 0);
  const Run binary = convert(bare, folder.path("a.tsq"));
  CHECK(binary.status == 0);
  CHECK(occurrences(binary.out, "(binary, point-point, without claims)") == 1);
  CHECK(convert(folder.path("a.tsq"), folder.path("same.csv")).status == 0);
  CHECK(folder.read("same.csv") == folder.read("point-point/bare.csv"));
  CHECK(convert(bare, folder.path("solved.csv"), {"--claims", "solve"}).status == 0);
  CHECK(folder.read("solved.csv") == two_point_queries());

  check_refused(run_program({"certify", bare}), "bare.csv: query 0 has no claim; name a file of claims (--claims)");
  CHECK(run_program({"solve", "--out", folder.path("answers.csv"), bare}).status == 0);
  CHECK(run_program({"certify", "--claims", folder.path("answers.csv"), bare}).status == 0);
  const Run explained = run_program({"explain", "--query", "1", bare});
  CHECK(explained.status == 0);
  CHECK(occurrences(explained.out, "truth column") == 0);

  const std::string without = folder.read("point-point/bare.csv");
  const std::string second = folder.write("point-point/second.csv", without + two_point_queries());
  check_refused(convert(second, folder.path("b.tsq")),
                "second.csv:9: query 2 has a claim, and the first query has none");
  check_refused(run_program({"certify", second}), "second.csv: query 0 has no claim");
  const std::string first = folder.write("point-point/first.csv", two_point_queries() + without);
  check_refused(convert(first, folder.path("b.tsq")), "first.csv:9: query 2 has no claim, and the first query has one");
  check_refused(run_program({"certify", first}), "first.csv: query 2 has no claim");
  CHECK(convert(first, folder.path("b.npy"), {"--claims", "drop"}).status == 0);
}

TEST_CASE("convert refuses what a format does not hold, and leaves no file") {
  const TemporaryFolder folder;
  const std::string csv = folder.write("point-point/a.csv", two_point_queries() +
                                                                "0,1,1,3,0,1,0\n0,1,0,1,0,1,0\n"
                                                                "0,1,0,1,0,1,0\n0,1,0,1,0,1,0\n");
  const auto files = [&] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path("."))) count += entry.is_regular_file();
    return count;
  };
  check_refused(convert(csv, folder.path("b.tsq")),
                "a.csv:9: y_num,y_den (y of p at t = 0 in query 2) is 1/3, which is no double; binary holds doubles");
  check_refused(convert(csv, folder.path("b.npy")), "npy has no room for claims; --claims drop leaves them out");
  check_refused(convert(csv, folder.path("b.npy"), {"--claims", "drop"}), "a.csv:9: y_num,y_den");
  check_refused(convert(csv, folder.path("b")),
                "in which format? Its name ends in none of .csv, .tsq, .npy, .h5 and .hdf5");
  check_refused(convert(csv, csv), "is also an input");
  check_refused(convert(csv, folder.path("b.csv"), {"--to", "hexfloat", "--claims", "drop"}),
                "hexfloat has a claim for each query");
  check_refused(convert(csv, folder.path("b.tsq"), {"--to", "yaml"}), "yaml");
  check_refused(convert(folder.write("empty.csv", ""), folder.path("b.tsq"), {"--kind", "edge-edge"}),
                "holds no query");
  CHECK(files() == 1);  // empty.csv
  // csv holds every fraction.
  CHECK(convert(csv, folder.path("same.csv")).status == 0);
  CHECK(folder.read("same.csv") == folder.read("point-point/a.csv"));
}

TEST_CASE("minus zero goes through every format but fractions") {
  const TemporaryFolder folder;
  const std::string text =
      folder.write("point-point/a.csv",
                   "touchstone-curved,1\nquery,1\ncurve,-0x0p+0,0x0p+0,0x0p+0,0x0p+0,-0x0p+0,0x0p+0\n"
                   "curve,0x1p+0,0x0p+0,0x0p+0,-0x1p+0,0x0p+0,0x0p+0\n");
  const std::string binary = folder.path("a.tsq"), back = folder.path("b.csv");
  REQUIRE(convert(text, binary).status == 0);
  REQUIRE(convert(binary, back, {"--to", "hexfloat"}).status == 0);
  CHECK(folder.read("b.csv") == folder.read("point-point/a.csv"));
  check_refused(convert(binary, folder.path("c.csv")),
                "a.tsq:1: x of p at t = 0 in query 0 is -0, and a fraction has no sign of zero");
  REQUIRE(convert(binary, folder.path("c.csv"), {"--unsigned-zeros"}).status == 0);
  CHECK(folder.read("c.csv") == "0,1,0,1,0,1,1\n1,1,0,1,0,1,1\n0,1,0,1,0,1,1\n-1,1,0,1,0,1,1\n");
}

TEST_CASE("HDF5 as the public benchmark packs it is written and read, where the program reads it") {
  const TemporaryFolder folder;
  const std::string csv = folder.write("vertex-face/a.csv", sample_file(Kind::vertex_face, 12, 8).text);
  const auto path = [&](const std::string& name) { return folder.path("vertex-face/" + name); };
  REQUIRE(convert(csv, path("b.h5")).status == 0);
  const Run read = convert(path("b.h5"), path("c.csv"));
  if (read.status != 0) {
    check_refused(read, "cannot be read: touchstone was built without HDF5");
    CHECK_FALSE(std::filesystem::exists(path("c.csv")));
    return;
  }
  CHECK(folder.read("vertex-face/c.csv") == folder.read("vertex-face/a.csv"));
  CHECK(convert(path("b.h5"), path("d.tsq"), {"--group", "/rounded"}).status == 0);
  CHECK(convert(csv, path("e.tsq")).status == 0);
  CHECK(folder.read("vertex-face/d.tsq") == folder.read("vertex-face/e.tsq"));
  CHECK(convert(path("b.h5"), path("f.hdf5"), {"--claims", "drop"}).status == 0);
  CHECK(convert(path("f.hdf5"), path("g.tsq"), {"--claims", "solve", "--threads", "2"}).status == 0);
  CHECK(folder.read("vertex-face/g.tsq") == folder.read("vertex-face/e.tsq"));

  check_refused(convert(path("b.h5"), path("h.tsq"), {"--group", "shifted"}), "has no data set 'shifted/points'");
  check_refused(convert(csv, path("h.tsq"), {"--group", "shifted"}), "is no HDF5 file, and has no groups");
  check_refused(convert(path("f.hdf5"), path("h.csv"), {"--to", "hexfloat"}),
                "hexfloat has a claim for each query; --claims solve");
  check_refused(run_program({"solve", path("b.h5")}), "is an HDF5 file; touchstone convert makes");
  const std::string about = folder.write("point-point/a.csv", "# separation 0x1p-2 max\n" + two_point_queries());
  check_refused(convert(about, folder.path("i.h5")), "hdf5 has no room for the separation");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("."))) files += entry.is_regular_file();
  CHECK(files == 7);  // a to g: nothing is left behind
}

TEST_CASE("a file that cannot be written is one line of error, in every format, and nothing is left of it") {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 2000; ++i) text += two_point_queries();
  const std::string csv = folder.write("point-point/a.csv", text);
  for (const std::string ending : {"csv", "tsq", "npy", "h5"}) {
    const std::string out = folder.path("out." + ending);
    RunOptions limited;
    limited.file_size = std::uint64_t{1} << 16;
    const Run run = run_program({"convert", csv, out, "--claims", ending == "npy" ? "drop" : "keep"}, limited);
    check_refused(run, "cannot be written: File too large");
    if (const auto device = folder.full_device()) {
      check_refused(convert(csv, *device,
                            {"--to",
                             ending == "tsq"  ? "binary"
                             : ending == "h5" ? "hdf5"
                                              : ending,
                             "--claims", ending == "npy" ? "drop" : "keep"}),
                    "cannot be written: No space left on device");
      std::filesystem::remove(*device);
    }
    CHECK(folder.names() == std::set<std::string>{"point-point"});
  }
}

TEST_CASE("an HDF5 file of the same queries has the same bytes") {
  const TemporaryFolder folder;
  const std::string csv = folder.write("vertex-face/a.csv", sample_file(Kind::vertex_face, 12, 8).text);
  const std::string first = folder.path("a.h5"), second = folder.path("b.h5");
  REQUIRE(convert(csv, first, {"--threads", "1"}).status == 0);
  REQUIRE(convert(csv, second, {"--threads", "2"}).status == 0);
  CHECK(folder.read("a.h5") == folder.read("b.h5"));
  const Run piped = convert(csv, "-", {"--to", "hdf5"});
  CHECK(piped.status == 0);
  CHECK(piped.out == folder.read("a.h5"));
}

TEST_CASE("a binary file that is cut off or damaged is refused by every command that reads queries") {
  const TemporaryFolder folder;
  const std::string csv = folder.write("point-point/a.csv", two_point_queries());
  REQUIRE(convert(csv, folder.path("a.tsq")).status == 0);
  const std::string whole = folder.read("a.tsq");
  const std::string cut = folder.write("cut.tsq", whole.substr(0, whole.size() - 1));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"solve"}, {"certify"}, {"explain", "--query", "0"}, {"prove", "--out", "-"}}) {
    std::vector<std::string> arguments = command;
    arguments.push_back(cut);
    check_refused(run_program(arguments), "the header promises 2 queries of 97 bytes, and the file has 193 bytes");
  }
  check_refused(run_program({"solve", "--kind", "edge-edge", folder.path("a.tsq")}),
                "its queries are of the kind point-point; edge-edge was asked for");
  check_refused(convert(cut, folder.path("b.csv")), "it is cut off or damaged");
}
