// The build without libhdf5.
// SPDX-License-Identifier: MIT
#include "frames/arrays/array.hpp"
#include "frames/arrays/hdf5_queries.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

constexpr const char* kMissing =
    "touchstone was built without HDF5. Install libhdf5 with its headers (Debian: libhdf5-dev) and build again, or "
    "save "
    "the data as .npy";

[[noreturn]] void fail(const std::string& file) {
  io::InputFile::check(file);
  io::fail(file, std::string("cannot be read: ") + kMissing);
}

}  // namespace

struct Hdf5QueryReader::State {};

Hdf5QueryReader::Hdf5QueryReader(const std::string& file, const std::string&, std::size_t, io::InputFile::Checkpoint) {
  fail(file);
}
Hdf5QueryReader::~Hdf5QueryReader() = default;
std::uint64_t Hdf5QueryReader::count() const noexcept { return 0; }
bool Hdf5QueryReader::has_results() const noexcept { return false; }
Hdf5Queries Hdf5QueryReader::read(std::uint64_t, std::uint64_t) { return {}; }

ArrayShape hdf5_shape(const std::string& file, const ReadOptions&) { fail(file); }
ArrayFrame read_hdf5_frame(const std::string& file, std::size_t, const ReadOptions&) { fail(file); }

}  // namespace touchstone::frames
