// Queries in HDF5 files as the public benchmark packs them, written here by libhdf5 and as the layer io writes them.
// SPDX-License-Identifier: MIT
#include <hdf5.h>

#include <cfloat>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/arrays/hdf5_queries.hpp"
#include "frames/hdf5_dataset.hpp"
#include "io/queries/hdf5_layout.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::frames;

namespace {

using Catch::Contains;

/// A new file, closed at the end.
class NewFile {
 public:
  explicit NewFile(const std::string& name) : id_(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  ~NewFile() { H5Fclose(id_); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Adds a data set; groups on the way are made.
  void add(const std::string& name, const std::vector<hsize_t>& extents, const std::vector<double>& values,
           hid_t type = H5T_IEEE_F64LE, const std::vector<hsize_t>& chunk = {}) const {
    add_dataset(id_, name, extents, values, type, chunk);
  }

 private:
  hid_t id_;
};

std::vector<double> counting(std::size_t count, double first = 0.25) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = first + static_cast<double>(i);
  return values;
}

constexpr std::size_t kCorners = 4, kNumbers = 24;  // of a query

std::string error_of(const std::string& file, const std::string& group = "") {
  try {
    Hdf5QueryReader reader(file, group, kCorners, nullptr);
    const Hdf5Queries queries = reader.read(0, reader.count());
    CHECK(queries.points.size() == kNumbers * reader.count());
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("HDF5 queries that were written are read, bit for bit, in pieces of any size") {
  const TemporaryFolder folder;
  constexpr std::size_t kCount = 5000;
  std::vector<double> points = counting(kNumbers * kCount);
  points[0] = -0.0;
  points[1] = std::numeric_limits<double>::denorm_min();
  points[2] = -DBL_MAX;
  for (const bool with_results : {true, false}) {
    std::vector<unsigned char> results(with_results ? kCount : 0);
    for (std::size_t i = 0; i < results.size(); ++i) results[i] = i % 3 == 0;
    std::string content = io::hdf5_query_header(Kind::edge_edge, kCount, with_results);
    content.append(reinterpret_cast<const char*>(points.data()), points.size() * sizeof(double));
    content.append(results.begin(), results.end());
    const std::string file = folder.write("a.h5", content);

    Hdf5QueryReader reader(file, "", kCorners, nullptr);
    REQUIRE(reader.count() == kCount);
    CHECK(reader.has_results() == with_results);
    std::vector<double> read;
    std::vector<unsigned char> read_results;
    for (std::size_t first = 0; first < kCount; first += 999) {
      const Hdf5Queries queries = reader.read(first, std::min<std::size_t>(999, kCount - first));
      read.insert(read.end(), queries.points.begin(), queries.points.end());
      read_results.insert(read_results.end(), queries.result.begin(), queries.result.end());
    }
    REQUIRE(read.size() == points.size());
    CHECK(std::memcmp(read.data(), points.data(), points.size() * sizeof(double)) == 0);
    CHECK(read_results == results);
    CHECK_THAT(error_of(folder.write("b.h5", content.substr(0, content.size() - 1))), Contains("truncated file"));
  }
}

TEST_CASE("a file of HDF5 queries has the types and extents that libhdf5 names, for every kind and number") {
  const TemporaryFolder folder;
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}) {
    for (const std::uint64_t count : {1, 2, 3, 1000}) {
      const std::uint64_t rows = 2 * corner_count(kind) * count;
      std::string content = io::hdf5_query_header(kind, count, true);
      CHECK(content == io::hdf5_query_header(kind, count, true));
      const std::string file = folder.write("a.h5", content.append(rows * 24 + count, '\1'));
      const hid_t open = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
      const hid_t points = H5Dopen2(open, "/rounded/points", H5P_DEFAULT);
      const hid_t result = H5Dopen2(open, "/rounded/result", H5P_DEFAULT);
      REQUIRE((open >= 0 && points >= 0 && result >= 0));
      const auto check = [](hid_t dataset, hid_t type, const std::vector<hsize_t>& extents) {
        const hid_t space = H5Dget_space(dataset), found = H5Dget_type(dataset);
        std::vector<hsize_t> sizes(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
        H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
        CHECK(sizes == extents);
        CHECK(H5Tequal(found, type) > 0);
        H5Tclose(found);
        H5Sclose(space);
      };
      check(points, H5T_IEEE_F64LE, {rows, 3});
      check(result, H5T_STD_U8LE, {count});
      H5Dclose(points);
      H5Dclose(result);
      CHECK(H5Fclose(open) >= 0);
    }
  }
}

TEST_CASE("the group of HDF5 queries is the benchmark's, or the one that is named, or the root") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.hdf5");
  {
    const NewFile out(file);
    out.add("points", {16, 3}, counting(48, 1));
    out.add("rounded/points", {8, 3}, counting(24, 2));
    out.add("rounded/result", {1, 1}, {1}, H5T_STD_U8LE);
    out.add("deep/shifted/points", {8, 3}, counting(24, 3), H5T_IEEE_F32BE, {3, 2});
  }
  const auto first = [&](const std::string& group) {
    Hdf5QueryReader reader(file, group, kCorners, nullptr);
    const Hdf5Queries queries = reader.read(reader.count() - 1, 1);
    return std::pair(queries.points.front(), queries.result);
  };
  CHECK(first("") == std::pair(2.0, std::vector<unsigned char>{1}));
  CHECK(first("/deep/shifted/") == std::pair(3.0, std::vector<unsigned char>()));
  CHECK(first("/") == std::pair(25.0, std::vector<unsigned char>()));
  CHECK_THAT(error_of(file, "shallow"), Contains("has no data set 'shallow/points'; queries are in GROUP/points"));
}

TEST_CASE("HDF5 data sets that cannot be queries are named, with what is right") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.h5");
  {
    const NewFile out(file);
    out.add("flat/points", {24}, counting(24));
    out.add("seven/points", {7, 3}, counting(21));
    out.add("two/points", {8, 2}, counting(16));
    out.add("integers/points", {8, 3}, counting(24), H5T_STD_I32LE);
    out.add("empty/points", {8, 3}, {}, H5T_IEEE_F64LE, {8, 3});
    out.add("none/points", {0, 3}, {}, H5T_IEEE_F64LE, {8, 3});
    out.add("few/points", {16, 3}, counting(48));
    out.add("few/result", {1}, {1}, H5T_STD_U8LE);
    out.add("wide/points", {8, 3}, counting(24));
    out.add("wide/result", {1}, {1}, H5T_STD_I64LE);
    out.add("points/points/points", {8, 3}, counting(24));
  }
  CHECK_THAT(error_of(file, "flat"), Contains("an array of shape (24,); queries have the shape (8 n, 3)"));
  CHECK_THAT(error_of(file, "seven"), Contains("an array of shape (7, 3)"));
  CHECK_THAT(error_of(file, "two"), Contains("an array of shape (8, 2)"));
  CHECK_THAT(error_of(file, "integers"), Contains("its type is not float64 or float32"));
  CHECK_THAT(error_of(file, "empty"), Contains("no values are stored"));
  CHECK_THAT(error_of(file, "none"), Contains("holds no query"));
  CHECK_THAT(error_of(file, "few"),
             Contains("'few/result': an array of shape (1,); results are bytes of the shape (2,)"));
  CHECK_THAT(error_of(file, "wide"), Contains("'wide/result'"));
  CHECK_THAT(error_of(file, ""), Contains("'points': cannot be opened"));  // it is a group
  CHECK(error_of(file, "points/points") == "");
  CHECK_THAT(error_of(folder.write("b.h5", "no HDF5")), Contains("is no HDF5 file that can be read"));
}

TEST_CASE("every cut of an HDF5 file of queries is an error") {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.h5");
  {
    const NewFile out(file);
    out.add("rounded/points", {80, 3}, counting(240), H5T_IEEE_F64LE, {80, 3});
    out.add("rounded/result", {10}, counting(10, 0), H5T_STD_U8LE);
  }
  const std::string content = folder.read("a.h5");
  REQUIRE(error_of(file) == "");
  for (std::size_t size = 0; size < content.size(); size += 1 + content.size() / 40) {
    const std::string error = error_of(folder.write("b.h5", content.substr(0, size)));
    CHECK(error.find('\n') == std::string::npos);
    CHECK(error != "");
  }
}
