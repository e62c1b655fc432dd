// HDF5: positions of frames, through libhdf5.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "frames/array.hpp"
#include "frames/hdf5_handles.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

bool has_fitting_shape(const std::vector<std::uint64_t>& extents) {
  return (extents.size() == 2 || extents.size() == 3) && (extents.back() == 2 || extents.back() == 3);
}

struct Search {
  std::vector<std::string> fitting;
  std::size_t datasets = 0;
};

/// The names of the data sets that can be positions.
Search find_datasets(const Handle& file) {
  Search search;
  const auto visit = [](hid_t root, const char* name, const H5O_info_t* info, void* data) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    auto& found = *static_cast<Search*>(data);
    ++found.datasets;
    const Handle dataset(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose);
    if (!dataset.is_open() || !holds_floats(dataset) || !has_fitting_shape(extents_of(dataset))) return 0;
    found.fitting.emplace_back(name);
    constexpr std::size_t kEnough = 4;
    return found.fitting.size() < kEnough ? 0 : 1;
  };
#if H5_VERSION_GE(1, 12, 0)
  H5Ovisit3(file.id(), H5_INDEX_NAME, H5_ITER_INC, visit, &search, H5O_INFO_BASIC);
#else
  H5Ovisit2(file.id(), H5_INDEX_NAME, H5_ITER_INC, visit, &search, H5O_INFO_BASIC);
#endif
  return search;
}

struct OpenDataset {
  Handle file;
  Handle dataset;
  std::string name;  ///< for messages: "data set 'x': "
  ArrayShape shape;
  std::size_t rank = 2;
};

/// The caller holds the mutex, and errors are silent.
OpenDataset open_dataset(const std::string& name, const ReadOptions& options) {
  const auto size = io::InputFile::check(name);
  if (!size) io::fail(name, "is a pipe or device; an HDF5 file is a file");
  if (options.checkpoint != nullptr) options.checkpoint();
  Handle file(H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.is_open()) io::fail(name, "is no HDF5 file that can be read: " + library_reason());
  std::string dataset_name = options.dataset;
  if (dataset_name.empty()) {
    const Search search = find_datasets(file);
    if (search.fitting.empty()) {
      io::fail(name, "has " + std::to_string(search.datasets) +
                         " data sets, none of them of doubles or floats of the shape (vertices, 3) or (frames, " +
                         "vertices, 3), or 2 in place of 3");
    }
    if (search.fitting.size() > 1) {
      std::string names;
      for (const std::string& one : search.fitting) names += (names.empty() ? "" : ", ") + io::in_quotes(one);
      io::fail(name, "has several data sets that can be positions; name one of them: " + names);
    }
    dataset_name = search.fitting.front();
  }
  std::string shown = "data set " + io::in_quotes(dataset_name) + ": ";
  Handle dataset(H5Dopen2(file.id(), dataset_name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.is_open()) io::fail(name, shown + "cannot be opened: " + library_reason());
  if (!holds_floats(dataset)) io::fail(name, shown + "its type is not float64 or float32");
  const std::vector<std::uint64_t> extents = extents_of(dataset);
  const ArrayShape shape = shape_of_positions(name, shown, extents);
  OpenDataset open{std::move(file), std::move(dataset), std::move(shown), shape, extents.size()};
  check_storage(name, open.name, open.dataset, *size, {shape.vertices, shape.dimension}, sizeof(float));
  return open;
}

}  // namespace

ArrayShape hdf5_shape(const std::string& file, const ReadOptions& options) {
  const std::lock_guard lock(hdf5_mutex());
  const Silence silence;
  return open_dataset(file, options).shape;
}

ArrayFrame read_hdf5_frame(const std::string& file, std::size_t index, const ReadOptions& options) {
  const std::lock_guard lock(hdf5_mutex());
  const Silence silence;
  const OpenDataset open = open_dataset(file, options);
  const ArrayShape& shape = open.shape;
  if (index >= shape.frames) {
    io::fail(file, "has no frame " + std::to_string(index) + "; the last is " + std::to_string(shape.frames - 1));
  }
  const bool one_frame = open.rank == 2;
  const std::array<hsize_t, 3> start = {one_frame ? 0 : index, 0, 0};
  const std::array<hsize_t, 3> count = one_frame ? std::array<hsize_t, 3>{shape.vertices, shape.dimension, 1}
                                                 : std::array<hsize_t, 3>{1, shape.vertices, shape.dimension};
  const Handle in_file(H5Dget_space(open.dataset.id()), H5Sclose);
  const Handle in_memory(H5Screate_simple(static_cast<int>(open.rank), count.data(), nullptr), H5Sclose);
  ArrayFrame frame{shape, std::vector<double>(shape.vertices * shape.dimension)};
  const bool is_read =
      in_file.is_open() && in_memory.is_open() &&
      H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
      H5Dread(open.dataset.id(), H5T_NATIVE_DOUBLE, in_memory.id(), in_file.id(), H5P_DEFAULT,
              frame.positions.data()) >= 0;
  if (!is_read) io::fail(file, open.name + "cannot be read: " + library_reason());
  return frame;
}

}  // namespace touchstone::frames
