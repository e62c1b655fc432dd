// HDF5 files of queries, as convert reads and writes them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "cli/shared/inputs.hpp"
#include "frames/hdf5_queries.hpp"
#include "io/query_file_writer.hpp"

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

/// An HDF5 file that appears when all of its queries are written. libhdf5 writes a file beside it first, whose bytes
/// are then copied.
class Hdf5Output {
 public:
  Hdf5Output(const std::string& path, const io::WrittenFile& file);  ///< @throws FileError

  void write(const io::EncodedQueries& queries);  ///< @throws FileError
  void commit();                                  ///< @throws FileError

 private:
  /// A file that is removed with the object.
  struct Scratch {
    explicit Scratch(const std::string& target);
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    std::string path;
  };

  io::OutputFile out_;
  Scratch scratch_;
  frames::Hdf5QueryWriter writer_;
};

}  // namespace touchstone::cli
