// HDF5: positions of frames, through libhdf5.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frames/arrays/array.hpp"
#include "frames/arrays/hdf5_handles.hpp"
#include "frames/arrays/reading_process.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

bool has_fitting_shape(const std::vector<std::uint64_t>& extents) {
  return (extents.size() == 2 || extents.size() == 3) && (extents.back() == 2 || extents.back() == 3);
}

struct FittingDatasets {
  std::vector<std::string> fitting;
  std::size_t datasets = 0;
};

/// The names of the data sets that can be positions.
FittingDatasets find_datasets(const Handle& file) {
  FittingDatasets search;
  const auto visit = [](hid_t root, const char* name, const H5O_info_t* info, void* data) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    auto& found = *static_cast<FittingDatasets*>(data);
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

/// In the reading process.
OpenDataset open_dataset(const std::string& name, std::string dataset_name, std::uint64_t file_size) {
  Handle file = open_hdf5(name);
  if (dataset_name.empty()) {
    const FittingDatasets search = find_datasets(file);
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
  check_storage(name, open.name, open.dataset, file_size, {shape.vertices, shape.dimension}, sizeof(float));
  return open;
}

std::vector<double> read_positions(const std::string& file, const OpenDataset& open, std::size_t index) {
  const ArrayShape& shape = open.shape;
  const bool one_frame = open.rank == 2;
  const std::array<hsize_t, 3> start = {one_frame ? 0 : index, 0, 0};
  const std::array<hsize_t, 3> count = one_frame ? std::array<hsize_t, 3>{shape.vertices, shape.dimension, 1}
                                                 : std::array<hsize_t, 3>{1, shape.vertices, shape.dimension};
  const Handle in_file(H5Dget_space(open.dataset.id()), H5Sclose);
  const Handle in_memory(H5Screate_simple(static_cast<int>(open.rank), count.data(), nullptr), H5Sclose);
  std::vector<double> positions(shape.vertices * shape.dimension);
  const bool is_read =
      in_file.is_open() && in_memory.is_open() &&
      H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
      H5Dread(open.dataset.id(), H5T_NATIVE_DOUBLE, in_memory.id(), in_file.id(), H5P_DEFAULT, positions.data()) >= 0;
  if (!is_read) io::fail(file, open.name + "cannot be read: " + library_reason());
  return positions;
}

/// The shape, and if a frame is named its positions.
ArrayFrame read(const std::string& file, std::optional<std::size_t> index, const ReadOptions& options) {
  const std::uint64_t size = size_of_hdf5(file);
  const auto serve = [&](const ReadingProcess::Line& line) {
    const Silence silence;
    const OpenDataset open = open_dataset(file, options.dataset, size);
    if (index && *index >= open.shape.frames) {
      io::fail(file,
               "has no frame " + std::to_string(*index) + "; the last is " + std::to_string(open.shape.frames - 1));
    }
    line.reply(&open.shape, sizeof open.shape);
    if (!index) return;
    const std::vector<double> positions = read_positions(file, open, *index);
    line.reply(positions.data(), positions.size() * sizeof(double));
  };
  ReadingProcess process(file, kHdf5Library, options.checkpoint, serve);
  ArrayFrame frame;
  process.take(&frame.shape, sizeof frame.shape);
  if (!index) return frame;
  frame.positions.resize(frame.shape.vertices * frame.shape.dimension);
  process.take(frame.positions.data(), frame.positions.size() * sizeof(double));
  return frame;
}

}  // namespace

ArrayShape hdf5_shape(const std::string& file, const ReadOptions& options) {
  return read(file, std::nullopt, options).shape;
}

ArrayFrame read_hdf5_frame(const std::string& file, std::size_t index, const ReadOptions& options) {
  return read(file, index, options);
}

}  // namespace touchstone::frames
