// Mesh files that never end, or say that they are huge.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <filesystem>
#include <string>

#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using Catch::Contains;

TEST_CASE("an OBJ file that is a device without an end is refused by the length of its line") {
  const TemporaryFolder folder;
  const std::string link = folder.path("zero.obj");
  std::filesystem::create_symlink("/dev/zero", link);
  CHECK_THROWS_WITH(frames::read_frame(link, 0, {}), link + ":1: a line of more than 64 MiB");
}

TEST_CASE("a mesh file, a topology file and an array in Fortran order of terabytes are refused at once") {
  const TemporaryFolder folder;
  const auto sparse = [&](const std::string& name, const std::string& start, off_t size) {
    const std::string file = folder.write(name, start);
    if (::truncate(file.c_str(), size) != 0) skip("this file system has no sparse file of terabytes");
    return file;
  };
  constexpr off_t kTerabyte = off_t{1} << 40;
  for (const std::string name : {"a.obj", "a.ply", "a.stl", "a.vtk"}) {
    const std::string file = sparse(name, "", kTerabyte);
    CHECK_THROWS_WITH(frames::read_frame(file, 0, {}), file + ": is larger than 64 GiB");
    frames::ReadOptions options;
    options.topology_file = file;
    // An array of three vertices, in the shape that the header states.
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }";
    header.resize(117, ' ');
    const std::string array = folder.write(
        "b.npy", std::string("\x93NUMPY\x01\0\x76\0", 10) + header + "\n" + std::string(9 * sizeof(double), '\0'));
    CHECK_THROWS_WITH(frames::read_frame(array, 0, options), file + ": is larger than 64 GiB");
  }
  std::string header =
      "{'descr': '<f8', 'fortran_order': True, 'shape': (" + std::to_string(kTerabyte / 8 / 6) + ", 2, 3), }";
  header.resize(117, ' ');
  const std::string start = std::string("\x93NUMPY\x01\0\x76\0", 10) + header + "\n";
  const std::string file =
      sparse("c.npy", start, static_cast<off_t>(start.size()) + kTerabyte / 8 / 6 * 6 * off_t{sizeof(double)});
  CHECK_THROWS_WITH(frames::read_frame(file, 0, {}), Contains("is larger than 64 GiB and in Fortran order"));
}
