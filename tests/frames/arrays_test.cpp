// Arrays of positions: .npy of every sort, their topology files and digests.
// SPDX-License-Identifier: MIT
#include <bit>
#include <cstring>
#include <filesystem>
#include <string>

#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "frames/samples.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::frames;

namespace {

using Catch::Contains;

/// The value of frame f, vertex v, coordinate k, which float32 holds, too.
double value(std::size_t f, std::size_t v, std::size_t k) {
  return static_cast<double>(f) * 100 - static_cast<double>(v) * 10 + static_cast<double>(k) + 0.5;
}

/// Values of an array of these extents, in the order that .npy has.
std::string values(std::size_t frames, std::size_t vertices, std::size_t dimension, bool fortran, std::endian order,
                   bool floats) {
  std::string text;
  const auto append = [&](std::size_t f, std::size_t v, std::size_t k) {
    const double x = value(f, v, k);
    text += floats ? bytes_of(static_cast<float>(x), order) : bytes_of(x, order);
  };
  const std::size_t count = frames * vertices * dimension;
  for (std::size_t i = 0; i < count; ++i) {
    if (fortran) {
      append(i % frames, i / frames % vertices, i / frames / vertices);
    } else {
      append(i / dimension / vertices, i / dimension % vertices, i % dimension);
    }
  }
  return text;
}

void check_frame(const Frame& frame, std::size_t index, std::size_t vertices, std::size_t dimension) {
  CHECK(frame.topology->vertex_count == vertices);
  CHECK(frame.topology->dimension == static_cast<int>(dimension));
  REQUIRE(frame.positions.size() == vertices * dimension);
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    REQUIRE(frame.positions[i] == value(index, i / dimension, i % dimension));
  }
}

ReadOptions with_topology(const std::string& file) {
  ReadOptions options;
  options.topology_file = file;
  return options;
}

std::string int_values(std::initializer_list<int> list) {
  std::string text;
  for (const int x : list) text += bytes_of(static_cast<std::int32_t>(x), std::endian::little);
  return text;
}

}  // namespace

TEST_CASE("every frame of an .npy array is read, in either order of bytes and of values") {
  const TemporaryFolder folder;
  for (const bool fortran : {false, true}) {
    for (const bool floats : {false, true}) {
      for (const std::endian order : {std::endian::little, std::endian::big}) {
        for (const std::size_t dimension : {2, 3}) {
          for (const int version : {1, 2, 3}) {
            const std::string descr = std::string(order == std::endian::big ? ">" : "<") + (floats ? "f4" : "f8");
            const std::string rest = "7, " + std::to_string(dimension) + ")";
            CAPTURE(fortran, descr, dimension, version);
            const std::string many = folder.write(
                "many.npy",
                npy(descr, fortran, "(5, " + rest, values(5, 7, dimension, fortran, order, floats), version));
            CHECK(frame_count(many, {}) == 5);
            for (std::size_t f = 0; f < 5; ++f) check_frame(read_frame(many, f, {}), f, 7, dimension);
            CHECK_THROWS_WITH(read_frame(many, 5, {}), Contains("no frame 5"));
            const std::string one = folder.write(
                "one.npy", npy(descr, fortran, "(" + rest, values(1, 7, dimension, fortran, order, floats), version));
            CHECK(frame_count(one, {}) == 1);
            check_frame(read_frame(one, 0, {}), 0, 7, dimension);
          }
        }
      }
    }
  }
}

TEST_CASE("every frame of a point cache is read") {
  const TemporaryFolder folder;
  const auto number = [](std::uint32_t n, std::endian order) { return bytes_of(n, order); };
  constexpr std::endian kLittle = std::endian::little, kBig = std::endian::big;
  const std::string pc2 = std::string("POINTCACHE2\0", 12) + number(1, kLittle) + number(7, kLittle) +
                          bytes_of(0.0f, kLittle) + bytes_of(1.0f, kLittle) + number(5, kLittle);
  std::string mdd = number(5, kBig) + number(7, kBig);
  for (int i = 0; i < 5; ++i) mdd += bytes_of(static_cast<float>(i), kBig);
  const std::string little = values(5, 7, 3, false, kLittle, true), big = values(5, 7, 3, false, kBig, true);
  const std::string files[] = {folder.write("a.pc2", pc2 + little), folder.write("a.MDD", mdd + big)};
  for (const std::string& file : files) {
    CHECK(frame_count(file, {}) == 5);
    for (std::size_t f = 0; f < 5; ++f) check_frame(read_frame(file, f, {}), f, 7, 3);
    CHECK_THROWS_WITH(read_frame(file, 5, {}), Contains("no frame 5"));
  }
  CHECK(read_frame(files[0], 2, {}).digest == read_frame(files[1], 2, {}).digest);
  const auto refused = [&](const std::string& name, const std::string& content, const std::string& words) {
    CHECK_THROWS_WITH(frame_count(folder.write(name, content), {}), Contains(words));
  };
  refused("b.pc2", pc2 + little + "x", "5 frames of 84 bytes must make up the file");
  refused("b.pc2", pc2 + little.substr(1), "must make up the file");
  refused("b.pc2", pc2.substr(0, 31), "shorter than a header of 32 bytes");
  refused("b.pc2", "POINTCACHE1" + pc2.substr(11) + little, "does not begin with POINTCACHE2");
  refused("b.pc2", pc2.substr(0, 12) + number(2, kLittle) + pc2.substr(16) + little, "has version 2");
  refused("b.mdd", mdd + big.substr(4), "must make up the file");
  refused("b.mdd", mdd.substr(0, 7), "shorter than a header of 8 bytes");
  refused("b.mdd", std::string(8, '\0'), "0 frames of 0 vertices");
  refused("b.mdd", std::string(8, '\xFF'), "must make up the file");
}

TEST_CASE("an array's coordinates are exact, and loose points without a topology") {
  const TemporaryFolder folder;
  const Frame frame = read_frame(folder.write("a.npy", npy_sample().content), 0, {});
  REQUIRE(frame.positions.size() == kDoubles.size());
  CHECK(std::memcmp(frame.positions.data(), kDoubles.data(), sizeof kDoubles) == 0);
  CHECK(frame.topology->points.size() == kVertices);
  CHECK(frame.topology->faces.empty());
}

TEST_CASE("a frame of a large array file is read alone") {
  const TemporaryFolder folder;
  const std::string header = npy("<f8", false, "(1000000, 100000, 3)", "");
  const std::string file = folder.write("large.npy", header);
  constexpr std::uint64_t kFrame = 100'000 * 3 * 8;
  std::error_code error;
  std::filesystem::resize_file(file, header.size() + 1'000'000 * kFrame, error);  // 2.4 terabytes of holes
  if (error) {
    WARN("this file system has no such large files: " << error.message());
    return;
  }
  CHECK(frame_count(file, {}) == 1'000'000);
  const Frame frame = read_frame(file, 999'999, {});
  CHECK(frame.positions == std::vector<double>(300'000));
}

TEST_CASE("the elements of an array come from a mesh file of any format") {
  const TemporaryFolder folder;
  const std::string array = folder.write("a.npy", npy_sample().content);
  for (const Sample& sample : mesh_samples()) {
    CAPTURE(sample.name);
    const std::string mesh = folder.write(sample.name, sample.content);
    const Frame frame = read_frame(array, 0, with_topology(mesh));
    CHECK(*frame.topology == *read_frame(mesh, 0, {}).topology);
    CHECK(std::memcmp(frame.positions.data(), kDoubles.data(), sizeof kDoubles) == 0);
  }
  const std::string small = folder.write("small.obj", "v 0 0 0\nv 1 0 0\n");
  CHECK_THROWS_WITH(read_frame(array, 0, with_topology(small)), Contains("small.obj: has 2 vertices") && Contains("6"));
  CHECK_THROWS_AS(read_frame(array, 0, with_topology(folder.path("none.obj"))), FileError);
  CHECK_THROWS_AS(read_frame(array, 0, with_topology(array)), FileError);
  CHECK_THROWS_AS(read_frame(small, 0, with_topology(small)), FileError);
}

TEST_CASE("the elements of an array come from an .npy array of integers of any type") {
  const TemporaryFolder folder;
  const std::string array = folder.write("a.npy", npy_sample().content);
  const auto topology = [&](const std::string& content) {
    return *read_frame(array, 0, with_topology(folder.write("t.npy", content))).topology;
  };
  const auto expect_faces = [&](const std::string& descr, const std::string& bytes, bool fortran = false) {
    CAPTURE(descr);
    CHECK(topology(npy(descr, fortran, "(2, 3)", bytes)).faces ==
          std::vector<std::array<MeshIndex, 3>>(kFaces.begin(), kFaces.end()));
  };
  const auto all = [](auto type, std::endian order, bool fortran = false) {
    std::string text;
    for (const int x : fortran ? std::array{0, 0, 1, 2, 2, 3} : std::array{0, 1, 2, 0, 2, 3}) {
      text += bytes_of(static_cast<decltype(type)>(x), order);
    }
    return text;
  };
  constexpr std::endian kLittle = std::endian::little, kBig = std::endian::big;
  expect_faces("|i1", all(std::int8_t{}, kLittle));
  expect_faces("|u1", all(std::uint8_t{}, kLittle));
  expect_faces("<i2", all(std::int16_t{}, kLittle));
  expect_faces(">u2", all(std::uint16_t{}, kBig));
  expect_faces("<i4", all(std::int32_t{}, kLittle));
  expect_faces(">u4", all(std::uint32_t{}, kBig));
  expect_faces("<i8", all(std::int64_t{}, kLittle));
  expect_faces(">i8", all(std::int64_t{}, kBig));
  expect_faces("<u8", all(std::uint64_t{}, kLittle));
  expect_faces("<i8", all(std::int64_t{}, kLittle, true), true);
  const Topology edges = topology(npy("<i4", false, "(1, 2)", int_values({3, 4})));
  CHECK(edges.edges == std::vector<std::array<MeshIndex, 2>>{{3, 4}});
  CHECK(edges.points.empty());

  CHECK_THROWS_WITH(topology(npy("<i4", false, "(1, 3)", int_values({3, 4, 6}))), Contains("vertex 6 does not exist"));
  CHECK_THROWS_WITH(topology(npy("<i4", false, "(1, 3)", int_values({3, -1, 2}))), Contains("vertex -1"));
  CHECK_THROWS_WITH(topology(npy("<i4", false, "(1, 4)", int_values({3, 0, 1, 2}))), Contains("(1, 4)"));
}

TEST_CASE("a topology file that changes is read again, and is part of the digest") {
  const TemporaryFolder folder;
  const std::string array = folder.write("a.npy", npy_sample().content);
  const std::string mesh = folder.write("t.npy", npy("<i4", false, "(1, 3)", int_values({0, 1, 2})));
  const Frame first = read_frame(array, 0, with_topology(mesh));
  CHECK(read_frame(array, 0, with_topology(mesh)).topology == first.topology);
  CHECK(read_frame(array, 0, with_topology(mesh)).digest == first.digest);
  folder.write("t.npy", npy("<i4", false, "(2, 3)", int_values({0, 1, 2, 2, 3, 4})));
  const Frame second = read_frame(array, 0, with_topology(mesh));
  CHECK(second.topology->faces.size() == 2);
  CHECK(second.digest != first.digest);
  CHECK(read_frame(array, 0, {}).digest != first.digest);
  CHECK(first.digest.size() == 64);
}

TEST_CASE("the digest of a frame depends on its own coordinates, and not on the file around them") {
  const TemporaryFolder folder;
  const auto digest = [&](const std::string& content, std::size_t index) {
    return read_frame(folder.write("a.npy", content), index, {}).digest;
  };
  constexpr std::endian kLittle = std::endian::little, kBig = std::endian::big;
  const std::string many = npy("<f8", false, "(5, 6, 2)", values(5, 6, 2, false, kLittle, false));
  CHECK(digest(many, 1) != digest(many, 2));
  CHECK(digest(many, 3) == digest(npy(">f4", true, "(5, 6, 2)", values(5, 6, 2, true, kBig, true)), 3));
  const std::string bytes = values(1, 6, 2, false, kLittle, false);
  CHECK(digest(npy("<f8", false, "(6, 2)", bytes), 0) != digest(npy("<f8", false, "(4, 3)", bytes), 0));
}
