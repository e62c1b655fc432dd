// SPDX-License-Identifier: MIT
#include "frames/arrays/hdf5_handles.hpp"

#include <algorithm>
#include <array>

#include "io/fail.hpp"
#include "io/input_file.hpp"

namespace touchstone::frames {

std::uint64_t size_of_hdf5(const std::string& file) {
  const auto size = io::InputFile::check(file);
  if (!size) io::fail(file, "is a pipe or device; an HDF5 file is a file");
  static const bool prepared = H5open() >= 0;
  static_cast<void>(prepared);
  return *size;
}

Handle open_hdf5(const std::string& file) {
  Handle handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!handle.is_open()) io::fail(file, "is no HDF5 file that can be read: " + library_reason());
  return handle;
}

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

bool holds_floats(const Handle& dataset) {
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (!type.is_open() || H5Tget_class(type.id()) != H5T_FLOAT) return false;
  const std::array<hid_t, 4> known = {H5T_IEEE_F32LE, H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_IEEE_F64BE};
  return std::any_of(known.begin(), known.end(), [&](hid_t other) { return H5Tequal(type.id(), other) > 0; });
}

void check_storage(const std::string& file, const std::string& name, const Handle& dataset, std::uint64_t file_size,
                   const std::vector<std::uint64_t>& extents, std::size_t value_size) {
  constexpr std::uint64_t kMostCompression = 1100;
  const std::uint64_t stored = std::min<std::uint64_t>(H5Dget_storage_size(dataset.id()), file_size);
  const std::uint64_t most = stored * kMostCompression / value_size;
  if (stored == 0) io::fail(file, name + "no values are stored");
  const auto is_too_large = [&](const auto& sizes) {
    std::uint64_t room = most;
    for (const std::uint64_t size : sizes) room /= std::max<std::uint64_t>(size, 1);
    return room == 0;
  };
  bool too_large = is_too_large(extents);
  const Handle plan(H5Dget_create_plist(dataset.id()), H5Pclose);
  if (plan.is_open() && H5Pget_layout(plan.id()) == H5D_CHUNKED) {
    std::vector<hsize_t> chunk(extents_of(dataset).size());
    if (H5Pget_chunk(plan.id(), static_cast<int>(chunk.size()), chunk.data()) < 0) io::fail(file, library_reason());
    too_large = too_large || is_too_large(chunk);
  }
  if (too_large) {
    io::fail(file,
             name + "its shape asks for more values than its " + std::to_string(stored) + " stored bytes can hold");
  }
}

}  // namespace touchstone::frames
