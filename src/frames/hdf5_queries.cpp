// SPDX-License-Identifier: MIT
#include "frames/hdf5_queries.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "frames/hdf5_handles.hpp"
#include "io/fail.hpp"
#include "io/npy_header.hpp"

namespace touchstone::frames {
namespace {

std::string shown(const std::string& dataset) { return "data set " + io::in_quotes(dataset) + ": "; }

bool holds_bytes(const Handle& dataset) {
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  return type.is_open() && H5Tget_class(type.id()) == H5T_INTEGER && H5Tget_size(type.id()) == 1;
}

/// Whether the file has a data set of this name; H5Lexists asks for one link after the other.
bool has_dataset(const Handle& file, const std::string& name) {
  for (std::size_t slash = name.find('/', 1); slash != std::string::npos; slash = name.find('/', slash + 1)) {
    if (H5Lexists(file.id(), name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(file.id(), name.c_str(), H5P_DEFAULT) > 0;
}

Handle open_dataset(const std::string& file_name, const Handle& file, const std::string& name) {
  Handle dataset(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.is_open()) io::fail(file_name, shown(name) + "cannot be opened: " + library_reason());
  return dataset;
}

/// Reads or writes the rows [first, first + count) of a data set of `width` columns; 0 columns: of rank 1.
template <class Transfer>
bool with_rows(const Handle& dataset, std::uint64_t first, std::uint64_t count, std::uint64_t width,
               Transfer transfer) {
  const int rank = width == 0 ? 1 : 2;
  const std::array<hsize_t, 2> start = {first, 0}, size = {count, std::max<std::uint64_t>(width, 1)};
  const Handle in_file(H5Dget_space(dataset.id()), H5Sclose);
  const Handle in_memory(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
  return in_file.is_open() && in_memory.is_open() &&
         H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) >= 0 &&
         transfer(in_memory.id(), in_file.id()) >= 0;
}

}  // namespace

struct Hdf5QueryReader::State {
  std::string name;
  std::uint64_t rows_per_query = 0;
  std::uint64_t count = 0;
  std::uint64_t file_size = 0;
  std::string points_name, result_name;
  std::optional<Handle> file, points, result;

  ~State() {
    const std::lock_guard lock(hdf5_mutex());
    const Silence silence;
    result.reset();
    points.reset();
    file.reset();
  }
};

Hdf5QueryReader::Hdf5QueryReader(std::string file, std::string group, std::size_t corners,
                                 io::InputFile::Checkpoint checkpoint)
    : state_(std::make_unique<State>()) {
  const auto size = io::InputFile::check(file);
  if (!size) io::fail(file, "is a pipe or device; an HDF5 file is a file");
  if (checkpoint != nullptr) checkpoint();
  const std::lock_guard lock(hdf5_mutex());
  const Silence silence;
  State& state = *state_;
  state.name = std::move(file);
  state.rows_per_query = 2 * corners;
  state.file_size = *size;
  state.file.emplace(H5Fopen(state.name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!state.file->is_open()) io::fail(state.name, "is no HDF5 file that can be read: " + library_reason());

  std::string prefix = group;
  while (!prefix.empty() && prefix.front() == '/') prefix.erase(0, 1);
  while (!prefix.empty() && prefix.back() == '/') prefix.pop_back();
  if (group.empty() && has_dataset(*state.file, std::string(kHdf5Group) + "/points")) prefix = kHdf5Group;
  state.points_name = prefix.empty() ? "points" : prefix + "/points";
  state.result_name = prefix.empty() ? "result" : prefix + "/result";
  if (!has_dataset(*state.file, state.points_name)) {
    io::fail(state.name,
             "has no data set " + io::in_quotes(state.points_name) +
                 "; queries are in GROUP/points, one row of x, y, z for each corner at t = 0 and then at t = "
                 "1, and --group names the group");
  }
  state.points.emplace(open_dataset(state.name, *state.file, state.points_name));
  if (!holds_floats(*state.points))
    io::fail(state.name, shown(state.points_name) + "its type is not float64 or float32");
  const std::vector<std::uint64_t> extents = extents_of(*state.points);
  if (extents.size() != 2 || extents[1] != 3 || extents[0] % state.rows_per_query != 0) {
    io::fail(state.name, shown(state.points_name) + "an array of shape " + io::shape_text(extents) +
                             "; queries have the shape (" + std::to_string(state.rows_per_query) + " n, 3)");
  }
  state.count = extents[0] / state.rows_per_query;
  if (state.count == 0) io::fail(state.name, shown(state.points_name) + "holds no query");
  check_storage(state.name, shown(state.points_name), *state.points, *size, {state.rows_per_query, 3}, sizeof(float));

  if (!has_dataset(*state.file, state.result_name)) return;
  state.result.emplace(open_dataset(state.name, *state.file, state.result_name));
  const std::vector<std::uint64_t> results = extents_of(*state.result);
  const bool fits = holds_bytes(*state.result) && !results.empty() && results[0] == state.count &&
                    (results.size() == 1 || (results.size() == 2 && results[1] == 1));
  if (!fits) {
    io::fail(state.name, shown(state.result_name) + "an array of shape " + io::shape_text(results) +
                             "; results are bytes of the shape (" + std::to_string(state.count) +
                             ",), one for each query");
  }
  check_storage(state.name, shown(state.result_name), *state.result, *size, {1}, 1);
}

Hdf5QueryReader::~Hdf5QueryReader() = default;

std::uint64_t Hdf5QueryReader::count() const noexcept { return state_->count; }
bool Hdf5QueryReader::has_results() const noexcept { return state_->result.has_value(); }

Hdf5Queries Hdf5QueryReader::read(std::uint64_t first, std::uint64_t count) const {
  const std::lock_guard lock(hdf5_mutex());
  const Silence silence;
  const State& state = *state_;
  Hdf5Queries queries;
  queries.points.resize(count * state.rows_per_query * 3);
  const auto read_points = [&](hid_t in_memory, hid_t in_file) {
    return H5Dread(state.points->id(), H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, queries.points.data());
  };
  if (!with_rows(*state.points, first * state.rows_per_query, count * state.rows_per_query, 3, read_points)) {
    io::fail(state.name, shown(state.points_name) + "cannot be read: " + library_reason());
  }
  if (!state.result) return queries;
  queries.result.resize(count);
  const auto read_results = [&](hid_t in_memory, hid_t in_file) {
    return H5Dread(state.result->id(), H5T_NATIVE_UCHAR, in_memory, in_file, H5P_DEFAULT, queries.result.data());
  };
  const std::uint64_t width = extents_of(*state.result).size() == 2 ? 1 : 0;
  if (!with_rows(*state.result, first, count, width, read_results)) {
    io::fail(state.name, shown(state.result_name) + "cannot be read: " + library_reason());
  }
  return queries;
}

struct Hdf5QueryWriter::State {
  std::string name;
  std::uint64_t rows_per_query = 0;
  std::uint64_t count = 0;
  std::optional<Handle> file, group, points, result;

  void close() {
    result.reset();
    points.reset();
    group.reset();
    file.reset();
  }
  ~State() {
    const std::lock_guard lock(hdf5_mutex());
    const Silence silence;
    close();
  }
};

namespace {

/// A data set that grows. @param width  the columns; 0: the rank is 1
Handle growing_dataset(const Handle& group, const char* name, hid_t type, std::uint64_t rows_in_chunk,
                       std::uint64_t width) {
  const int rank = width == 0 ? 1 : 2;
  const std::array<hsize_t, 2> none = {0, width}, most = {H5S_UNLIMITED, width}, chunk = {rows_in_chunk, width};
  const Handle space(H5Screate_simple(rank, none.data(), most.data()), H5Sclose);
  const Handle plan(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (H5Pset_chunk(plan.id(), rank, chunk.data()) < 0) return {-1, H5Dclose};
  return {H5Dcreate2(group.id(), name, type, space.id(), H5P_DEFAULT, plan.id(), H5P_DEFAULT), H5Dclose};
}

}  // namespace

Hdf5QueryWriter::Hdf5QueryWriter(std::string file, std::size_t corners, bool with_results)
    : state_(std::make_unique<State>()) {
  constexpr std::uint64_t kQueriesInChunk = 4096;
  const std::lock_guard lock(hdf5_mutex());
  const Silence silence;
  State& state = *state_;
  state.name = std::move(file);
  state.rows_per_query = 2 * corners;
  state.file.emplace(H5Fcreate(state.name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  if (!state.file->is_open()) io::fail(state.name, "cannot be written: " + library_reason());
  const std::string group(kHdf5Group);
  state.group.emplace(H5Gcreate2(state.file->id(), group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  state.points.emplace(
      growing_dataset(*state.group, "points", H5T_IEEE_F64LE, kQueriesInChunk * state.rows_per_query, 3));
  if (with_results) state.result.emplace(growing_dataset(*state.group, "result", H5T_STD_U8LE, kQueriesInChunk, 0));
  if (!state.group->is_open() || !state.points->is_open() || (with_results && !state.result->is_open())) {
    io::fail(state.name, "cannot be written: " + library_reason());
  }
}

Hdf5QueryWriter::~Hdf5QueryWriter() = default;

void Hdf5QueryWriter::append(const Hdf5Queries& queries) {
  const std::lock_guard lock(hdf5_mutex());
  const Silence silence;
  State& state = *state_;
  const std::uint64_t count = queries.points.size() / (3 * state.rows_per_query);
  if (count == 0) return;
  const std::uint64_t rows = count * state.rows_per_query, before = state.count * state.rows_per_query;
  const std::array<hsize_t, 2> points_size = {before + rows, 3};
  const hsize_t result_size = state.count + count;
  const auto write_points = [&](hid_t in_memory, hid_t in_file) {
    return H5Dwrite(state.points->id(), H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, queries.points.data());
  };
  const auto write_results = [&](hid_t in_memory, hid_t in_file) {
    return H5Dwrite(state.result->id(), H5T_NATIVE_UCHAR, in_memory, in_file, H5P_DEFAULT, queries.result.data());
  };
  const bool written = H5Dset_extent(state.points->id(), points_size.data()) >= 0 &&
                       with_rows(*state.points, before, rows, 3, write_points) &&
                       (!state.result || (H5Dset_extent(state.result->id(), &result_size) >= 0 &&
                                          with_rows(*state.result, state.count, count, 0, write_results)));
  if (!written) io::fail(state.name, "cannot be written: " + library_reason());
  state.count += count;
}

void Hdf5QueryWriter::close() {
  const std::lock_guard lock(hdf5_mutex());
  const Silence silence;
  State& state = *state_;
  if (H5Fflush(state.file->id(), H5F_SCOPE_LOCAL) < 0) io::fail(state.name, "cannot be written: " + library_reason());
  state.close();
}

}  // namespace touchstone::frames
