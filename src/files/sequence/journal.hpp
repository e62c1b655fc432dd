// The progress of a run: a line for each finished result, so that a run that was killed can go on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sequence/results.hpp"

namespace touchstone::sequence {

/// A finished result, and the digests of the frames that it is about: one, or the two of a step.
struct Finished {
  Result result;
  std::vector<std::string> digests;
};

/// What becomes of the journal of an earlier run.
enum class Earlier : std::uint8_t { refused, continued };

/// A file that is locked as long as the object lives. Each line starts with 16 digits of the digest of its rest. A line
/// that was written in part is dropped when the file is read.
class Journal {
 public:
  /// @param path     the file; it is made when it is missing
  /// @param heading  what the run is about
  /// @param earlier  whether the results of an earlier run are taken over
  /// @throws FileError  for the journal of an earlier run that is refused, of another run, or of a run that goes on now
  Journal(const std::string& path, const Heading& heading, Earlier earlier);

  /// The results of the earlier run, from the first one on, without a gap.
  const std::vector<Finished>& finished() const noexcept { return finished_; }

  /// Writes a result, at once. @throws FileError
  void add(const Finished& finished);

  /// Removes the file: the report holds its content. @throws FileError
  void remove();

  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Removes a file without a result. Another file stays.
  ~Journal();

 private:
  void open_locked();
  void read(const Heading& heading);
  void write_line(const std::string& json);

  std::string path_;
  int descriptor_ = -1;
  std::size_t results_ = 0;
  bool keep_ = true;
  std::vector<Finished> finished_;
};

}  // namespace touchstone::sequence
