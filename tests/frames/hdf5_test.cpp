// HDF5 files, written here by libhdf5.
// SPDX-License-Identifier: MIT
#include <hdf5.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "frames/hdf5_dataset.hpp"
#include "frames/samples.hpp"
#include "io/temporary_folder.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::frames;

namespace {

using Catch::Contains;

/// Adds a data set of doubles. The type in the file may be another.
void add(const std::string& file, const std::string& name, const std::vector<hsize_t>& extents,
         const std::vector<double>& values, hid_t type = H5T_IEEE_F64LE, const std::vector<hsize_t>& chunk = {}) {
  const bool is_new = !std::filesystem::exists(file);
  const hid_t id = is_new ? H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
                          : H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  add_dataset(id, name, extents, values, type, chunk);
  REQUIRE(H5Fclose(id) >= 0);
}

std::vector<double> counted(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<double>(i) + 0.25;
  return values;
}

ReadOptions dataset(const std::string& name) {
  ReadOptions options;
  options.dataset = name;
  return options;
}

}  // namespace

TEST_CASE("positions of an HDF5 file are exact") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.h5");
  add(file, "deep/inside/positions", {kVertices, 3}, {kDoubles.begin(), kDoubles.end()});
  add(file, "other", {4, 4}, counted(16));
  CHECK(frame_count(file, {}) == 1);
  const Frame frame = read_frame(file, 0, {});
  REQUIRE(frame.positions.size() == kDoubles.size());
  CHECK(std::memcmp(frame.positions.data(), kDoubles.data(), sizeof kDoubles) == 0);
  CHECK_THROWS_WITH(read_frame(file, 1, {}), Contains("no frame 1"));

  const std::string array = folder.write("same.npy", npy_sample().content);
  CHECK(read_frame(array, 0, {}).digest == frame.digest);
}

TEST_CASE("every frame of an HDF5 file is read, compressed or not") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.hdf5");
  const std::vector<double> values = counted(5 * 7 * 2);
  add(file, "doubles", {5, 7, 2}, values, H5T_IEEE_F64BE);
  add(file, "floats", {5, 7, 2}, values, H5T_IEEE_F32LE, {2, 3, 2});
  for (const char* const name : {"doubles", "/floats"}) {
    CHECK(frame_count(file, dataset(name)) == 5);
    for (std::size_t f = 0; f < 5; ++f) {
      const Frame frame = read_frame(file, f, dataset(name));
      CHECK(frame.topology->dimension == 2);
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(14 * f);
      CHECK(frame.positions == std::vector<double>(first, first + 14));
    }
  }
}

TEST_CASE("a data set of an HDF5 file that is no positions is an error that says what is right") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.h5");
  add(file, "x", {4, 4}, counted(16));
  CHECK_THROWS_WITH(read_frame(file, 0, {}), Contains("1 data sets, none"));
  CHECK_THROWS_WITH(read_frame(file, 0, dataset("x")), Contains("shape (4, 4)"));
  CHECK_THROWS_WITH(read_frame(file, 0, dataset("y")), Contains("'y': cannot be opened"));
  add(file, "integers", {4, 3}, counted(12), H5T_STD_I32LE);
  CHECK_THROWS_WITH(read_frame(file, 0, dataset("integers")), Contains("type"));
  add(file, "a", {4, 3}, counted(12));
  add(file, "b", {4, 3}, counted(12));
  CHECK_THROWS_WITH(read_frame(file, 0, {}), Contains("name one of them: 'a', 'b'"));
  CHECK(read_frame(file, 0, dataset("b")).positions == counted(12));
  add(file, "empty", {4000, 4000, 3}, {}, H5T_IEEE_F64LE, {1, 4000, 3});
  CHECK_THROWS_WITH(read_frame(file, 0, dataset("empty")), Contains("no values are stored"));
}

TEST_CASE("a damaged HDF5 file is a frame or an error of one line, though libhdf5 crashes on some") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.h5");
  add(file, "deep/x", {2, 40, 3}, counted(240), H5T_IEEE_F64LE, {1, 40, 3});
  add(file, "deep/y", {2, 3}, counted(6));
  const std::string content = folder.read("a.h5");
  seeded::Rng rng(36);
  int errors = 0;
  for (std::size_t i = 0; i < effort(500); ++i) {
    std::string changed = content;
    for (int changes = rng.between(1, 4); changes > 0; --changes) {
      const std::size_t at = rng.below(content.size());
      changed[at] = static_cast<char>(rng.bits());
    }
    const std::string name = folder.write("b.h5", changed);
    try {
      read_frame(name, 0, dataset("deep/x"));
    } catch (const FileError& error) {
      const std::string what = error.what();
      CHECK(what.find('\n') == std::string::npos);
      CHECK(what.starts_with(name + ": "));
      ++errors;
    }
  }
  CHECK(errors > 0);
}

TEST_CASE("every cut of an HDF5 file is an error") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.h5");
  add(file, "x", {2, 40, 3}, counted(240), H5T_IEEE_F64LE, {1, 40, 3});
  const std::string content = folder.read("a.h5");
  int errors = 0, frames = 0;
  const auto try_to_read = [&](const std::string& changed) {
    const std::string name = folder.write("b.h5", changed);
    try {
      const Frame frame = read_frame(name, 0, {});
      CHECK(frame.positions.size() == frame.topology->vertex_count * 3);
      ++frames;
    } catch (const FileError& error) {
      const std::string what = error.what();
      CHECK(what.find('\n') == std::string::npos);
      CHECK(what.starts_with(name + ": "));
      ++errors;
    }
  };
  for (std::size_t size = 0; size < content.size(); size += 1 + content.size() / 60) {
    try_to_read(content.substr(0, size));
  }
  CHECK(frames == 0);
  CHECK(errors >= 55);
  try_to_read(content);
  CHECK(frames == 1);
}
