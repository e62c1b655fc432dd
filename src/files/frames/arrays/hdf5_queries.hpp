// Queries in HDF5 files, packed as the public benchmark of Wang et al. 2021 has them: the data set GROUP/points has 2 *
// corners rows of x, y, z for each query, all corners at t = 0 before those at t = 1, and GROUP/result a 0 or 1 for each.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/input_file.hpp"

namespace touchstone::frames {

/// Some queries of a file.
struct Hdf5Queries {
  std::vector<double> points;         ///< 3 * 2 * corners for each query, in the order of the file
  std::vector<unsigned char> result;  ///< one for each query, or none
};

/// Reads such a file, in a process of its own.
class Hdf5QueryReader {
 public:
  /// @param group  empty: io::kHdf5Group where the file has it, else the root
  /// @param corners  of a query
  /// @throws FileError  also in a build without HDF5
  Hdf5QueryReader(const std::string& file, const std::string& group, std::size_t corners,
                  io::InputFile::Checkpoint checkpoint);
  ~Hdf5QueryReader();
  Hdf5QueryReader(const Hdf5QueryReader&) = delete;
  Hdf5QueryReader& operator=(const Hdf5QueryReader&) = delete;

  std::uint64_t count() const noexcept;
  bool has_results() const noexcept;

  /// Queries `first` to `first + count`, which must be there. @throws FileError
  Hdf5Queries read(std::uint64_t first, std::uint64_t count);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace touchstone::frames
