// Files that appear whole or not at all.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/error.hpp>

namespace touchstone::io {

/// The reader of standard output has gone, as `head` does when it has its lines. No error for a person.
class ReaderGone : public FileError {
 public:
  using FileError::FileError;
};

/// Writes a temporary file beside the target; commit() puts it in the target's place. If the object is destroyed
/// without a commit, it removes the temporary file, and the target is unchanged. A process that is killed cannot remove
/// the file. Then TARGET.touchstone-N.partial stays, until the same target is written again. Devices, pipes and
/// standard output are written directly, since there is no file to replace.
class OutputFile {
 public:
  /// @throws FileError when the target is a folder or nothing can be written beside it
  explicit OutputFile(const std::string& path);

  static OutputFile standard_output();

  /// @throws ReaderGone; FileError when the disk is full, the reader of another pipe has gone, and so on
  void write(std::string_view bytes);

  /// Puts everything on the disk, under the final name. @throws FileError
  void commit();

  const std::string& name() const noexcept { return name_; }

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

 private:
  OutputFile() = default;
  void flush();

  std::string name_;       ///< for messages
  std::string target_;     ///< the final name: where a symbolic link leads, whether there is a file or not
  std::string temporary_;  ///< empty: the target is written directly
  std::string buffer_;
  int descriptor_ = -1;
  bool owned_ = true;
};

/// A nameless file for bytes that do not fit into memory; it vanishes with the object, or with the process.
class SpoolFile {
 public:
  /// In the folder of `path`, or in the system's folder for temporary files when `path` is no regular file's.
  explicit SpoolFile(const std::string& path);

  void write(std::string_view bytes);  ///< @throws FileError
  void copy_to(OutputFile& out);       ///< everything written so far @throws FileError
  bool empty() const noexcept { return written_ == 0; }
  std::uint64_t size() const noexcept { return written_; }

  /// Takes back all that was written after the first `size` bytes. @throws FileError
  void cut(std::uint64_t size);

  SpoolFile(const SpoolFile&) = delete;
  SpoolFile& operator=(const SpoolFile&) = delete;
  ~SpoolFile();

 private:
  std::string name_;
  std::string buffer_;
  std::uint64_t written_ = 0;
  int descriptor_ = -1;
};

}  // namespace touchstone::io
