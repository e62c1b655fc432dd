// Files that have no end, or say that they are huge, are refused with the limit, in little time and memory.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <string>

#include <touchstone/error.hpp>

#include "io/temporary_folder.hpp"
#include "io/whole_file.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
constexpr io::FileLimits kSmall{4 * kMiB, 2 * kMiB, kMiB};

std::string error_of(const std::string& path, const io::FileLimits& limits) {
  try {
    io::WholeFile::read(path, limits, nullptr);
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a whole file has the bytes of the file, up to each limit and not beyond") {
  const TemporaryFolder folder;
  const io::FileLimits no_lines{4 * kMiB, 2 * kMiB, 0};
  for (const std::uint64_t size : {std::uint64_t{0}, std::uint64_t{1}, kMiB + 1, 4 * kMiB}) {
    std::string content(size, 'x');
    for (std::size_t i = 0; i < content.size(); i += 97) content[i] = static_cast<char>('a' + i % 26);
    const std::string file = folder.write("a", content);
    const io::WholeFile whole = io::WholeFile::read(file, no_lines, nullptr);
    CHECK((whole.bytes() == content));
  }
  const std::string file = folder.write("a", std::string(4 * kMiB + 1, '\n'));
  CHECK(error_of(file, no_lines) == file + ": is larger than 4 MiB");
}

TEST_CASE("a line is refused beyond its limit, with its number, wherever blocks end") {
  const TemporaryFolder folder;
  for (const std::size_t before : {std::size_t{0}, std::size_t{1}, std::size_t{500'000}}) {
    const std::string lines(before, '\n'), row = std::to_string(before + 1);
    const std::string longest = folder.write("a", lines + std::string(kMiB, 'x') + "\nx");
    CHECK(error_of(longest, kSmall) == "");
    const std::string longer = folder.write("b", lines + std::string(kMiB + 1, 'x') + "\nx");
    CHECK(error_of(longer, kSmall) == longer + ":" + row + ": a line of more than 1 MiB");
    const std::string last = folder.write("c", lines + std::string(kMiB + 1, 'x'));
    CHECK(error_of(last, kSmall) == last + ":" + row + ": a line of more than 1 MiB");
  }
}

TEST_CASE("a device without an end and a sparse file of terabytes are refused at once") {
  const TemporaryFolder folder;
  const std::string device = "/dev/zero";
  CHECK(error_of(device, kSmall) == device + ":1: a line of more than 1 MiB");
  CHECK(error_of(device, {4 * kMiB, 2 * kMiB, 0}) ==
        device + ": is a pipe or device, and has more than 2 MiB; such data are read from a file");
  const std::string sparse = folder.write("sparse", "");
  if (::truncate(sparse.c_str(), off_t{1} << 40) != 0) skip("this file system has no sparse file of a terabyte");
  CHECK(error_of(sparse, {std::uint64_t{1} << 36, kMiB, 0}) == sparse + ": is larger than 64 GiB");
}
