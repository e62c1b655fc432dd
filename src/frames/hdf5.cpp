// HDF5: positions of frames, through libhdf5. The one file that includes it.
// SPDX-License-Identifier: MIT
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <utility>

#include "frames/array.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

/// libhdf5 is mostly built without support for threads.
std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// An object of libhdf5, closed at the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  hid_t id() const noexcept { return id_; }
  bool is_open() const noexcept { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Keeps libhdf5 from printing its errors, as long as it lives.
class Silence {
 public:
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() {
    H5Eclear2(H5E_DEFAULT);
    H5Eset_auto2(H5E_DEFAULT, function_, data_);
  }

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// The reason that libhdf5 gives for the last failure: that of the innermost function.
std::string library_reason() {
  std::string reason;
  const auto keep = [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
    if (error->desc != nullptr) *static_cast<std::string*>(to) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep, &reason);
  return reason.empty() ? "libhdf5 gives no reason" : io::with_short_words(reason);
}

std::vector<std::uint64_t> extents_of(const Handle& dataset) {
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = space.is_open() ? H5Sget_simple_extent_ndims(space.id()) : -1;
  if (rank <= 0) return {};
  std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
  if (H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr) < 0) return {};
  return {extents.begin(), extents.end()};
}

/// Whether the values are of a type that converts to doubles without rounding.
bool holds_floats(const Handle& dataset) {
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (!type.is_open() || H5Tget_class(type.id()) != H5T_FLOAT) return false;
  const std::array<hid_t, 4> known = {H5T_IEEE_F32LE, H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_IEEE_F64BE};
  return std::any_of(known.begin(), known.end(), [&](hid_t other) { return H5Tequal(type.id(), other) > 0; });
}

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

/// A file of few bytes does not hold much. Filters compress, deflate to a 1032nd at best. Without this check a few
/// bytes could ask for any amount of memory.
void check_storage(const std::string& file, const OpenDataset& open, std::uint64_t file_size) {
  constexpr std::uint64_t kMostCompression = 1100;
  const std::uint64_t stored = std::min<std::uint64_t>(H5Dget_storage_size(open.dataset.id()), file_size);
  const std::uint64_t most = stored * kMostCompression / sizeof(float);
  if (stored == 0) io::fail(file, open.name + "no values are stored");
  const auto is_too_large = [&](std::initializer_list<std::uint64_t> extents) {
    std::uint64_t room = most;
    for (const std::uint64_t extent : extents) room /= std::max<std::uint64_t>(extent, 1);
    return room == 0;
  };
  bool too_large = is_too_large({open.shape.vertices, open.shape.dimension});
  const Handle plan(H5Dget_create_plist(open.dataset.id()), H5Pclose);
  if (plan.is_open() && H5Pget_layout(plan.id()) == H5D_CHUNKED) {
    std::array<hsize_t, 3> chunk{};
    if (H5Pget_chunk(plan.id(), static_cast<int>(open.rank), chunk.data()) < 0) io::fail(file, library_reason());
    too_large = too_large || is_too_large({chunk[0], chunk[1], open.rank == 3 ? chunk[2] : 1});
  }
  if (too_large) {
    io::fail(file, open.name + "its shape asks for more values than its " + std::to_string(stored) +
                       " stored bytes can hold");
  }
}

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
  check_storage(name, open, *size);
  return open;
}

}  // namespace

ArrayShape hdf5_shape(const std::string& file, const ReadOptions& options) {
  const std::lock_guard lock(library_mutex());
  const Silence silence;
  return open_dataset(file, options).shape;
}

ArrayFrame read_hdf5_frame(const std::string& file, std::size_t index, const ReadOptions& options) {
  const std::lock_guard lock(library_mutex());
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
