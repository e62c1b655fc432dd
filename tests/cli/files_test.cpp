// Damaged input through the program: status 2, one line with file and row, and no file under the final name.
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "cli/sample_files.hpp"
#include "support/catch.hpp"
#include "support/report.hpp"
#include "support/skip.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using NameList = std::set<std::string>;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("damage is named with file and row, and leaves no output behind, whatever the number of threads") {
  const std::string good = two_point_queries();
  struct Damage {
    std::string text;
    std::string error;  ///< after the file's name
  };
  const Damage damage = GENERATE_COPY(
      Damage{good + "0,1,0,1,0,1,0\n", ":9: the file ends within query 2, which has 1 row; a point-point query has 4"},
      Damage{replaced(good, "1,1,0,1,", "1,1,"),
             ":2: 5 columns; a row has 7: x_num,x_den,y_num,y_den,z_num,z_den,truth, or 6 without truth"},
      Damage{replaced(good, "-1,1", "minus one,1"), ":4: x_num is 'minus one'; it must be a decimal integer"},
      Damage{replaced(good, "-1,1", "-1,0"), ":4: x_den is zero; a denominator must be positive"},
      Damage{
          replaced(good, "-1,1,0,1,0,1,1", "-1,1,0,1,0,1,0"),
          ":4: truth is 0 here and 1 in row 1, where the same query 0 starts; all 4 rows of a point-point query must "
          "agree"},
      Damage{
          "# nothing\n",
          ": holds no query; a row is a corner as fractions, with 7 columns: "
          "x_num,x_den,y_num,y_den,z_num,z_den,truth, or "
          "6 without truth; a corner as decimals, x,y,z with 3, or 4 with truth; or a whole point-point query, with 12 "
          "decimals, and truth or not"});
  const TemporaryFolder folder;
  const std::string file = folder.write("point-point/bad.csv", damage.text);
  const std::string first = folder.write("point-point/good.csv", good);
  folder.write("out.csv", "old answers");
  CAPTURE(damage.error);
  for (const std::string threads : {"1", "2", "5"}) {
    const Run solve = run_program({"solve", "--threads", threads, "--out", folder.path("out.csv"), first, file});
    CHECK(solve.status == 2);
    CHECK(solve.out == "");
    CHECK(solve.err == file + damage.error + "\n");
    const Run certify = run_program({"certify", "--threads", threads, "--report", folder.path("r.json"), first, file});
    CHECK(certify.status == 2);
    CHECK(certify.out == "");
    CHECK(certify.err == file + damage.error + "\n");
  }
  CHECK(folder.names() == NameList{"point-point", "out.csv"});
  CHECK(folder.read("out.csv") == "old answers");
}

TEST_CASE("of several faults the first in the files is named, whatever the number of threads") {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += two_point_queries();
  text[text.size() / 2 - text.size() / 2 % two_point_queries().size()] = 'x';
  const std::string late_fault = folder.write("point-point/a.csv", text);
  const std::string early_fault = folder.write("point-point/b.csv", std::string("y").append(two_point_queries()));
  for (const std::string threads : {"1", "2", "5"}) {
    const Run run = run_program({"certify", "--threads", threads, late_fault, early_fault});
    CHECK(run.status == 2);
    CHECK(run.err == late_fault + ":80001: x_num is 'x'; it must be a decimal integer\n");
  }
}

TEST_CASE("an interrupted run ends by the signal and leaves no output behind") {
  const TemporaryFolder folder;
  const std::string file = folder.path("queries");
  std::string text;
  while (text.size() < 4'000'000) text += two_point_queries();
  folder.write("point-point/a.csv", text);
  const std::string queries = folder.path("point-point/a.csv");
  RunOptions options;
  options.interrupt_after = 0.3;
  std::vector<std::string> arguments = {
      "solve", "--level", "oracle", "--threads", "2", "--out", folder.path("out.csv")};
  for (int i = 0; i < 20; ++i) arguments.push_back(queries);  // minutes of work
  const Run run = run_program(arguments, options);
  CHECK(run.status == 128 + SIGINT);
  CHECK(folder.names() == NameList{"point-point"});
}

TEST_CASE("an interrupt ends a run that waits for a pipe") {
  const TemporaryFolder folder;
  folder.write("point-point/a.csv", two_point_queries());
  const std::string pipe = folder.path("point-point/pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  RunOptions options;
  options.interrupt_after = 0.3;
  const Run opening = run_program({"solve", "--out", folder.path("out.csv"), pipe}, options);  // the pipe has no writer
  CHECK(opening.status == 128 + SIGINT);
  const int writer = ::open(pipe.c_str(), O_RDWR);  // a writer that writes nothing
  REQUIRE(writer >= 0);
  const Run reading = run_program({"certify", "--threads", "1", pipe}, options);
  CHECK(reading.status == 128 + SIGINT);
  ::close(writer);
  CHECK(folder.names() == NameList{"point-point"});
}

TEST_CASE("memory does not grow with the file") {
  if (TOUCHSTONE_SLOW_BUILD) {
    skip("a sanitizer or debug build needs more memory for other reasons");
    return;
  }
  const TemporaryFolder folder;
  const SampleFile sample = sample_file(Kind::point_edge, 1, 20);
  const auto peak = [&](std::size_t bytes, const std::string& name) {
    const std::string file = folder.write("point-edge/" + name, "");
    std::ofstream out(file, std::ios::binary);  // piece by piece: a child's peak starts at its parent's size
    for (std::size_t written = 0; written < bytes; written += sample.text.size()) out << sample.text;
    out.close();
    const Run run = run_program({"certify", "--threads", "2", "--report", folder.path("r.json"), file});
    CHECK(run.status == 0);
    return run.peak_kilobytes;
  };
  const long small = peak(4'000'000, "small.csv");
  const long large = peak(64'000'000, "large.csv");
  CAPTURE(small, large);
  CHECK(large < small + 10'000);
  CHECK(large < 60'000);
}

TEST_CASE("a pipe can be read") {
  const TemporaryFolder folder;
  folder.write("a.csv", two_point_queries());
  const std::string command = std::string("cat '") + folder.path("a.csv") +
                              "' | '" TOUCHSTONE_PROGRAM "' certify --kind point-point /dev/stdin > '" +
                              folder.path("out") + "'";
  CHECK(std::system(command.c_str()) == 0);
  CHECK(folder.read("out").rfind("all 2 claims hold", 0) == 0);
}

TEST_CASE("an output file beyond the size that the system allows is one line of error, and nothing is left of it") {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 5000; ++i) text += two_point_queries();
  const std::string file = folder.write("point-point/a.csv", text);
  RunOptions limited;
  limited.file_size = std::uint64_t{1} << 16;
  const std::string out = folder.path("out.csv");
  const Run run = run_program({"solve", "--out", out, file}, limited);
  CHECK(run.status == 2);
  CHECK(run.err == out + ": cannot be written: File too large\n");
  CHECK(folder.names() == NameList{"point-point"});
}

TEST_CASE("a scene and a mesh without an end, or of a terabyte, are refused with the limit") {
  const TemporaryFolder folder;
  const std::string link = folder.path("zero.obj");
  std::filesystem::create_symlink("/dev/zero", link);
  const Run endless = run_program({"mesh", "--check", link});
  CHECK(endless.status == 2);
  CHECK(endless.err == link + ":1: a line of more than 64 MiB\n");
  const std::string scene = folder.write("scene.json", "");
  if (::truncate(scene.c_str(), off_t{1} << 40) != 0) skip("this file system has no sparse file of a terabyte");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"simulate", scene},
                                                    {"simulate", "--resume", scene},
                                                    {"merge", "--out", folder.path("merged.json"), scene}}) {
    const Run run = run_program(arguments);
    CHECK(run.status == 2);
    CHECK(run.err == scene + ": is larger than 1 GiB\n");
  }
}

TEST_CASE("where the system cannot start the threads, one does the work, or the error says how many there are") {
#if TOUCHSTONE_SANITIZED
  skip("sanitizers map terabytes: limits on memory are not tested");
#else
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += two_point_queries();
  const std::string file = folder.write("point-point/a.csv", text);
  RunOptions tight;
  tight.address_space = std::uint64_t{400} << 20;  // a stack takes 4 MiB or more
  const Run few = run_program({"certify", "--threads", "1000", file}, tight);
  const Run one = run_program({"certify", "--threads", "1", file});
  CAPTURE(few.err);
  CHECK(few.status == one.status);
  const auto verdict = [](const Run& run) { return run.out.substr(0, run.out.find("  time ")); };
  CHECK(verdict(few) == verdict(one));
  CHECK(few.out.find(" a second, 1 thread\n") != std::string::npos);
  const Run fuzz = run_program({"fuzz", "--threads", "1000", "--cases", "1000", "--out", folder.path("found")}, tight);
  CAPTURE(fuzz.err);
  CHECK(fuzz.status == 2);
  CHECK(occurrences(fuzz.err, " of 1000 threads can be started: ") == 1);
  CHECK(occurrences(fuzz.err, "; ask for fewer threads, such as 1\n") == 1);
#endif
}
