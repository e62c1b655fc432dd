// Files that appear whole or not at all.
// SPDX-License-Identifier: MIT
#include "io/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include <touchstone/error.hpp>

#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using NameList = std::set<std::string>;

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
  CHECK(folder.names() == NameList{"a.csv"});
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
  CHECK(folder.names() == NameList{"a.csv"});
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
  CHECK(folder.names() == NameList{"a.csv"});
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
  CHECK(folder.names() == NameList{"link.csv", "real.csv"});
  CHECK(std::filesystem::is_symlink(folder.path("link.csv")));
  CHECK(folder.read("real.csv") == "new");
  struct stat status {};
  REQUIRE(::stat(folder.path("real.csv").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("a link that leads to no file yet stays a link, and the file is made where it leads") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("far"));
  std::filesystem::create_symlink("far/real.csv", folder.path("second"));
  std::filesystem::create_symlink(folder.path("second"), folder.path("first"));
  io::OutputFile out(folder.path("first"));
  out.write("new");
  CHECK(folder.names() == NameList{"far", "first", "second"});  // the incomplete file lies beside the target
  out.commit();
  CHECK(folder.names() == NameList{"far", "first", "second"});
  CHECK(std::filesystem::is_symlink(folder.path("first")));
  CHECK(std::filesystem::is_symlink(folder.path("second")));
  CHECK(folder.read("far/real.csv") == "new");
}

TEST_CASE("links that lead nowhere are refused, and stay") {
  const TemporaryFolder folder;
  const std::string link = folder.path("link");
  SECTION("the target's folder is missing") {
    std::filesystem::create_symlink("no/real.csv", link);
    CHECK(error_of([&] { io::OutputFile{link}; }) ==
          link + ": is a link to " + folder.path("no/real.csv") + ", whose folder is not there");
  }
  SECTION("a loop") {
    std::filesystem::create_symlink("other", link);
    std::filesystem::create_symlink("link", folder.path("other"));
    CHECK(error_of([&] { io::OutputFile{link}; }) ==
          link + ": is a link that leads to no file: Too many levels of symbolic links");
  }
  SECTION("a folder") {
    std::filesystem::create_directory(folder.path("far"));
    std::filesystem::create_symlink("far", link);
    CHECK(error_of([&] { io::OutputFile{link}; }) == link + ": is a folder; name a file to write");
  }
  CHECK(std::filesystem::is_symlink(link));
}

#ifdef __linux__
TEST_CASE("the link of an open descriptor whose file is removed is refused, and nothing is made") {
  const TemporaryFolder folder;
  const int descriptor = ::open(folder.path("removed").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  REQUIRE(descriptor >= 0);
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  { io::OutputFile(link).commit(); }
  CHECK(folder.names() == NameList{"removed"});
  const int removed = ::open(folder.path("removed").c_str(), O_RDWR | O_CLOEXEC);
  ::unlink(folder.path("removed").c_str());
  const std::string removed_link = "/proc/self/fd/" + std::to_string(removed);
  CHECK(error_of([&] { io::OutputFile out(removed_link); }).find("has no name any more") != std::string::npos);
  CHECK(folder.names().empty());
  ::close(removed);
  ::close(descriptor);
}
#endif

TEST_CASE("what a killed process leaves is removed when the same file is written again") {
  const TemporaryFolder folder;
  const std::string target = folder.path("a.csv");
  for (int killed = 0; killed < 3; ++killed) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      io::OutputFile first(target), second(target);
      first.write(std::string(100'000, 'x'));
      ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    // Those of the process that was killed before are gone already.
    CHECK(folder.names() == NameList{"a.csv.touchstone-1.partial", "a.csv.touchstone-2.partial"});
  }
  folder.write("b.csv.touchstone-1.partial", "of another file");
  folder.write("a.csv.partial", "nobody's");
  io::OutputFile out(target);
  out.write("whole");
  out.commit();
  CHECK(folder.names() == NameList{"a.csv", "a.csv.partial", "b.csv.touchstone-1.partial"});
  CHECK(folder.read("a.csv") == "whole");
}

TEST_CASE("what a live process writes is left alone, in this process and in others") {
  const TemporaryFolder folder;
  const std::string target = folder.path("a.csv");
  int ready[2], go[2];
  REQUIRE(::pipe(ready) == 0);
  REQUIRE(::pipe(go) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    io::OutputFile theirs(target);
    theirs.write("theirs");
    char byte = 0;
    if (::write(ready[1], &byte, 1) != 1 || ::read(go[0], &byte, 1) != 1) ::_exit(1);
    theirs.commit();
    ::_exit(0);
  }
  char byte = 0;
  REQUIRE(::read(ready[0], &byte, 1) == 1);
  {
    io::OutputFile one(target), two(target);
    CHECK(folder.names() ==
          NameList{"a.csv.touchstone-1.partial", "a.csv.touchstone-2.partial", "a.csv.touchstone-3.partial"});
    one.write("one");
    two.write("two");
    one.commit();
    CHECK(folder.read("a.csv") == "one");
    two.commit();
    CHECK(folder.read("a.csv") == "two");
  }
  CHECK(folder.names() == NameList{"a.csv", "a.csv.touchstone-1.partial"});
  REQUIRE(::write(go[1], &byte, 1) == 1);
  int status = -1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(folder.names() == NameList{"a.csv"});
  CHECK(folder.read("a.csv") == "theirs");
  for (const int end : {ready[0], ready[1], go[0], go[1]}) ::close(end);
}

TEST_CASE("a temporary name that something else has taken is not touched") {
  const TemporaryFolder folder;
  folder.write("precious", "precious");
  std::filesystem::create_symlink("precious", folder.path("a.csv.touchstone-1.partial"));
  std::filesystem::create_directory(folder.path("a.csv.touchstone-2.partial"));
  REQUIRE(::mkfifo(folder.path("a.csv.touchstone-3.partial").c_str(), 0600) == 0);
  const NameList before = folder.names();
  {
    io::OutputFile out(folder.path("a.csv"));
    out.write("x");
  }
  CHECK(folder.names() == before);
  CHECK(folder.read("precious") == "precious");
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
  CHECK(folder.names() == NameList{"full"});
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
  CHECK(folder.names() == NameList{"pipe"});
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
  CHECK(folder.names() == NameList{"a.csv"});
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
  CHECK(folder.names() == NameList{"out"});
  CHECK(folder.read("out") == all);
}

TEST_CASE("a spool file forgets what is cut off, whether it was in memory or on the disk") {
  const TemporaryFolder folder;
  io::SpoolFile spool(folder.path("report.json"));
  std::string kept;
  for (const std::size_t size : {std::size_t{10}, std::size_t{200'000}, std::size_t{0}, std::size_t{70'000}}) {
    const std::string piece(size, static_cast<char>('a' + kept.size() % 26));
    spool.write(piece);
    kept += piece;
    CHECK(spool.size() == kept.size());
    spool.write(std::string(3, '-'));
    spool.cut(kept.size());
    spool.write(std::string(300'000, '-'));
    spool.cut(kept.size());
    CHECK(spool.size() == kept.size());
  }
  io::OutputFile out(folder.path("out"));
  spool.copy_to(out);
  out.commit();
  CHECK((folder.read("out") == kept));
}
