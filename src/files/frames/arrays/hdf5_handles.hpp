// What the readers and writers of HDF5 share. Only the files named hdf5* include libhdf5.
// SPDX-License-Identifier: MIT
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::frames {

/// As messages about a crash name it.
inline constexpr const char* kHdf5Library = "the HDF5 library";

/// Checks that there is such a file, and prepares libhdf5, which a ReadingProcess then need not do again for each file.
/// All other functions are for that process alone: libhdf5 is not made for damaged files, nor for threads.
/// @returns its size in bytes. @throws FileError  also for a pipe or device
std::uint64_t size_of_hdf5(const std::string& file);

class Handle;

/// @throws FileError
Handle open_hdf5(const std::string& file);

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
std::string library_reason();

/// The extents of a data set; empty when it has none.
std::vector<std::uint64_t> extents_of(const Handle& dataset);

/// Whether the values are of a type that converts to doubles without rounding.
bool holds_floats(const Handle& dataset);

/// A file of few bytes does not hold much. Filters compress, deflate to a 1032nd at best. Without this check a few bytes
/// could ask for any amount of memory.
/// @param name  of the data set, for messages
/// @param extents  of the values that are read at a time
/// @param value_size  the bytes of a value in the file, at least
/// @throws FileError
void check_storage(const std::string& file, const std::string& name, const Handle& dataset, std::uint64_t file_size,
                   const std::vector<std::uint64_t>& extents, std::size_t value_size);

}  // namespace touchstone::frames
