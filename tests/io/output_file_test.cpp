// Files that appear whole or not at all.
// SPDX-License-Identifier: MIT
#include "io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include <touchstone/error.hpp>

#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using Names = std::set<std::string>;

namespace {

template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a committed file holds all that was written, and nothing else is left") {
  const TemporaryFolder folder;
  const std::string block(100'000, 'x');
  {
    io::OutputFile out(folder.path("a.csv"));
    out.write("head\n");
    out.write(block);
    CHECK(folder.names().count("a.csv") == 0);
    out.commit();
  }
  CHECK(folder.names() == Names{"a.csv"});
  CHECK(folder.read("a.csv") == "head\n" + block);
}

TEST_CASE("without a commit the old file stands and the temporary one is gone") {
  const TemporaryFolder folder;
  folder.write("a.csv", "old");
  {
    io::OutputFile out(folder.path("a.csv"));
    out.write(std::string(100'000, 'x'));
    CHECK(folder.names().size() == 2);
  }
  CHECK(folder.names() == Names{"a.csv"});
  CHECK(folder.read("a.csv") == "old");
}

TEST_CASE("a moved output file is written once and removed once") {
  const TemporaryFolder folder;
  {
    io::OutputFile first(folder.path("a.csv"));
    first.write("1");
    io::OutputFile second(std::move(first));
    second.write("2");
    second.commit();
  }
  CHECK(folder.names() == Names{"a.csv"});
  CHECK(folder.read("a.csv") == "12");
}

TEST_CASE("a replaced file keeps its permissions, a link stays a link") {
  const TemporaryFolder folder;
  folder.write("real.csv", "old");
  REQUIRE(::chmod(folder.path("real.csv").c_str(), 0640) == 0);
  std::filesystem::create_symlink("real.csv", folder.path("link.csv"));
  io::OutputFile out(folder.path("link.csv"));
  out.write("new");
  out.commit();
  CHECK(folder.names() == Names{"link.csv", "real.csv"});
  CHECK(std::filesystem::is_symlink(folder.path("link.csv")));
  CHECK(folder.read("real.csv") == "new");
  struct stat status {};
  REQUIRE(::stat(folder.path("real.csv").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("places where no file can be are refused") {
  const TemporaryFolder folder;
  CHECK(error_of([&] { io::OutputFile{folder.path("")}; }) == folder.path("") + ": is a folder; name a file to write");
  const std::string nowhere = folder.path("no/a.csv");
  CHECK(error_of([&] { io::OutputFile{nowhere}; }) == nowhere + ": cannot be written: No such file or directory");
  CHECK(error_of([&] { io::OutputFile{""}; }) == "'': is no file name");
}

TEST_CASE("a full disk is an error, and a device is not replaced") {
  const TemporaryFolder folder;
  const auto device = folder.full_device();
  if (!device) {
    skip("no device can be made here: that needs root");
    return;
  }
  const std::string full = *device + ": cannot be written: No space left on device";
  CHECK(error_of([&] {
          io::OutputFile out(*device);
          out.write("x");
          out.commit();
        }) == full);
  CHECK(error_of([&] { io::OutputFile(*device).write(std::string(1 << 20, 'x')); }) == full);
  CHECK(std::filesystem::is_character_file(*device));
  CHECK(folder.names() == Names{"full"});
}

TEST_CASE("a pipe is written straight away and not replaced") {
  const TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  REQUIRE(reader >= 0);
  io::OutputFile out(pipe);
  out.write("through");
  out.commit();
  char got[16] = {};
  CHECK(::read(reader, got, sizeof got) == 7);
  CHECK(std::string(got) == "through");
  ::close(reader);
  CHECK(std::filesystem::is_fifo(pipe));
  CHECK(folder.names() == Names{"pipe"});
}

TEST_CASE("a target that turns into something else meanwhile is left alone") {
  const TemporaryFolder folder;
  const std::string target = folder.path("a.csv");
  CHECK(error_of([&] {
          io::OutputFile out(target);
          out.write("x");
          REQUIRE(::mkfifo(target.c_str(), 0600) == 0);
          out.commit();
        }) == target + ": has become something else than a file; it is left alone");
  CHECK(std::filesystem::is_fifo(target));
  CHECK(folder.names() == Names{"a.csv"});
}

TEST_CASE("a spool file gives back what went in and is never seen") {
  const TemporaryFolder folder;
  std::string all;
  {
    io::SpoolFile spool(folder.path("report.json"));
    CHECK(spool.empty());
    for (int i = 0; i < 30'000; ++i) {
      const std::string piece = std::to_string(i) + ",";
      spool.write(piece);
      all += piece;
    }
    CHECK_FALSE(spool.empty());
    CHECK(folder.names().empty());
    io::OutputFile out(folder.path("out"));
    spool.copy_to(out);
    out.commit();
  }
  CHECK(folder.names() == Names{"out"});
  CHECK(folder.read("out") == all);
}
