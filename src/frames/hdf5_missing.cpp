// The build without libhdf5.
// SPDX-License-Identifier: MIT
#include "frames/array.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

[[noreturn]] void fail(const std::string& file) {
  io::InputFile::check(file);
  io::fail(file, "cannot be read: touchstone was built without HDF5. Install libhdf5 with its headers (Debian: " +
                     std::string("libhdf5-dev) and build again, or save the positions as .npy"));
}

}  // namespace

ArrayShape hdf5_shape(const std::string& file, const ReadOptions&) { fail(file); }
ArrayFrame read_hdf5_frame(const std::string& file, std::size_t, const ReadOptions&) { fail(file); }

}  // namespace touchstone::frames
