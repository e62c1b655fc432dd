// SPDX-License-Identifier: MIT
#include "frames/arrays/hdf5_queries.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "frames/arrays/hdf5_handles.hpp"
#include "frames/arrays/reading_process.hpp"
#include "io/fail.hpp"
#include "io/queries/hdf5_layout.hpp"
#include "io/queries/npy_header.hpp"

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

/// Reads the rows [first, first + count) of a data set of `width` columns; 0 columns: of rank 1.
bool read_rows(const Handle& dataset, std::uint64_t first, std::uint64_t count, std::uint64_t width, hid_t type,
               void* to) {
  const int rank = width == 0 ? 1 : 2;
  const std::array<hsize_t, 2> start = {first, 0}, size = {count, std::max<std::uint64_t>(width, 1)};
  const Handle in_file(H5Dget_space(dataset.id()), H5Sclose);
  const Handle in_memory(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
  return in_file.is_open() && in_memory.is_open() &&
         H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr) >= 0 &&
         H5Dread(dataset.id(), type, in_memory.id(), in_file.id(), H5P_DEFAULT, to) >= 0;
}

/// What the reading process says about a file that it has opened.
struct Found {
  std::uint64_t count = 0;
  std::uint64_t has_results = 0;  ///< 0 or 1
};

struct Request {
  std::uint64_t first = 0, count = 0;
};

/// The file's data sets, in the reading process.
class OpenQueries {
 public:
  OpenQueries(const std::string& name, const std::string& group, std::uint64_t rows_per_query, std::uint64_t file_size)
      : name_(name), rows_per_query_(rows_per_query), file_(open_hdf5(name)) {
    std::string prefix = group;
    while (!prefix.empty() && prefix.front() == '/') prefix.erase(0, 1);
    while (!prefix.empty() && prefix.back() == '/') prefix.pop_back();
    if (group.empty() && has_dataset(file_, std::string(io::kHdf5Group) + "/points")) prefix = io::kHdf5Group;
    points_name_ = prefix.empty() ? "points" : prefix + "/points";
    result_name_ = prefix.empty() ? "result" : prefix + "/result";
    open_points(file_size);
    if (has_dataset(file_, result_name_)) open_result(file_size);
  }

  Found found() const noexcept { return {count_, result_ ? 1U : 0U}; }

  void read(std::uint64_t first, Hdf5Queries& queries) const {
    const std::uint64_t count = queries.points.size() / (3 * rows_per_query_);
    if (!read_rows(*points_, first * rows_per_query_, count * rows_per_query_, 3, H5T_NATIVE_DOUBLE,
                   queries.points.data())) {
      io::fail(name_, shown(points_name_) + "cannot be read: " + library_reason());
    }
    if (!result_) return;
    const std::uint64_t width = extents_of(*result_).size() == 2 ? 1 : 0;
    if (!read_rows(*result_, first, count, width, H5T_NATIVE_UCHAR, queries.result.data())) {
      io::fail(name_, shown(result_name_) + "cannot be read: " + library_reason());
    }
  }

 private:
  void open_points(std::uint64_t file_size) {
    if (!has_dataset(file_, points_name_)) {
      io::fail(name_, "has no data set " + io::in_quotes(points_name_) +
                          "; queries are in GROUP/points, one row of x, y, z for each corner at t = 0 and then at t = "
                          "1, and --group names the group");
    }
    points_.emplace(open_dataset(name_, file_, points_name_));
    if (!holds_floats(*points_)) io::fail(name_, shown(points_name_) + "its type is not float64 or float32");
    const std::vector<std::uint64_t> extents = extents_of(*points_);
    if (extents.size() != 2 || extents[1] != 3 || extents[0] % rows_per_query_ != 0) {
      io::fail(name_, shown(points_name_) + "an array of shape " + io::shape_text(extents) +
                          "; queries have the shape (" + std::to_string(rows_per_query_) + " n, 3)");
    }
    count_ = extents[0] / rows_per_query_;
    if (count_ == 0) io::fail(name_, shown(points_name_) + "holds no query");
    check_storage(name_, shown(points_name_), *points_, file_size, {rows_per_query_, 3}, sizeof(float));
  }

  void open_result(std::uint64_t file_size) {
    result_.emplace(open_dataset(name_, file_, result_name_));
    const std::vector<std::uint64_t> results = extents_of(*result_);
    const bool fits = holds_bytes(*result_) && !results.empty() && results[0] == count_ &&
                      (results.size() == 1 || (results.size() == 2 && results[1] == 1));
    if (!fits) {
      io::fail(name_, shown(result_name_) + "an array of shape " + io::shape_text(results) +
                          "; results are bytes of the shape (" + std::to_string(count_) + ",), one for each query");
    }
    check_storage(name_, shown(result_name_), *result_, file_size, {1}, 1);
  }

  std::string name_;
  std::uint64_t rows_per_query_;
  Handle file_;
  std::uint64_t count_ = 0;
  std::string points_name_, result_name_;
  std::optional<Handle> points_, result_;
};

}  // namespace

struct Hdf5QueryReader::State {
  std::uint64_t rows_per_query = 0;
  Found found;
  ReadingProcess process;
};

Hdf5QueryReader::Hdf5QueryReader(const std::string& file, const std::string& group, std::size_t corners,
                                 io::InputFile::Checkpoint checkpoint) {
  const std::uint64_t size = size_of_hdf5(file);
  const std::uint64_t rows_per_query = 2 * corners;
  const auto serve = [&](const ReadingProcess::Line& line) {
    const Silence silence;
    const OpenQueries open(file, group, rows_per_query, size);
    const Found found = open.found();
    line.reply(&found, sizeof found);
    Hdf5Queries queries;
    for (Request request; line.next_request(&request, sizeof request);) {
      queries.points.resize(request.count * rows_per_query * 3);
      queries.result.resize(found.has_results != 0 ? request.count : 0);
      open.read(request.first, queries);
      line.reply(queries.points.data(), queries.points.size() * sizeof(double));
      line.reply(queries.result.data(), queries.result.size());
    }
  };
  state_.reset(new State{rows_per_query, {}, {file, kHdf5Library, checkpoint, serve}});
  state_->process.take(&state_->found, sizeof state_->found);
}

Hdf5QueryReader::~Hdf5QueryReader() = default;

std::uint64_t Hdf5QueryReader::count() const noexcept { return state_->found.count; }
bool Hdf5QueryReader::has_results() const noexcept { return state_->found.has_results != 0; }

Hdf5Queries Hdf5QueryReader::read(std::uint64_t first, std::uint64_t count) {
  Hdf5Queries queries;
  queries.points.resize(count * state_->rows_per_query * 3);
  queries.result.resize(has_results() ? count : 0);
  const Request request{first, count};
  state_->process.request(&request, sizeof request);
  state_->process.take(queries.points.data(), queries.points.size() * sizeof(double));
  state_->process.take(queries.result.data(), queries.result.size());
  return queries;
}

}  // namespace touchstone::frames
