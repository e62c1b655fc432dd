// HDF5 files of queries, as convert reads them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "cli/shared/inputs.hpp"
#include "frames/arrays/hdf5_queries.hpp"

namespace touchstone::cli {

/// Whether the file, which exists, starts as HDF5 files do. A pipe does not.
bool is_hdf5(const Input& input);

/// The queries of an HDF5 file, piece by piece.
class Hdf5Stream {
 public:
  /// @param group  as of frames::Hdf5QueryReader. @throws FileError
  Hdf5Stream(const Input& input, const std::string& group, std::size_t chunk_bytes);

  /// @returns false after the last piece. @throws FileError
  bool next(QueryItem& item);

 private:
  std::shared_ptr<const std::string> name_;
  Kind kind_;
  frames::Hdf5QueryReader reader_;
  std::uint64_t queries_per_chunk_;
  std::uint64_t next_ = 0;
};

}  // namespace touchstone::cli
