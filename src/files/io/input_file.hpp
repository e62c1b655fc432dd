// A source of bytes: a file, a pipe, or text that is already in memory.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchstone::io {

class InputFile {
 public:
  /// Called before every read, and again when a signal breaks one off; throws to give up.
  using Checkpoint = void (*)();

  /// Opens a file, pipe or device for reading. @throws FileError when there is none, or it is a folder
  static InputFile open(const std::string& path, Checkpoint checkpoint = nullptr);

  /// Reads `content`, which must outlive the result, as if it were a file called `name`.
  static InputFile from_memory(std::string name, std::string_view content);

  /// The checks of open(), without opening: a pipe can be opened only once.
  /// @returns the size in bytes, or nothing for a pipe or device. @throws FileError as open() does
  static std::optional<std::uint64_t> check(const std::string& path);

  /// Reads at most `capacity` bytes into `to`. @returns their number, 0 at the end
  /// @throws FileError when the operating system cannot read
  std::size_t read(char* to, std::size_t capacity);

  /// The next bytes, `count` of them or those before the end, which are read again. Valid until the next read.
  std::string_view peek(std::size_t count);

  /// Goes on `count` bytes further in the file, or at its end if it is shorter. A pipe is read that far.
  /// @throws FileError when the operating system cannot read
  void skip(std::uint64_t count);

  const std::string& name() const noexcept { return name_; }

  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&& other) noexcept;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

 private:
  friend class FileBytes;
  InputFile(std::string name, int descriptor, std::string_view content, Checkpoint checkpoint)
      : name_(std::move(name)), descriptor_(descriptor), whole_(content), content_(content), checkpoint_(checkpoint) {}

  std::string name_;
  int descriptor_;            ///< -1: reads content_
  std::string_view whole_;    ///< of text in memory
  std::string_view content_;  ///< what is left of it
  std::string ahead_;         ///< what peek() has read
  Checkpoint checkpoint_;
};

/// All bytes of a file, mapped into memory: they are read from the disk when they are used, and take no memory of their
/// own. If another program shortens the file meanwhile, the operating system ends this process (SIGBUS).
class FileBytes {
 public:
  /// The bytes from the file's beginning, however far it was read. @throws FileError  for a pipe or device
  explicit FileBytes(const InputFile& file);

  std::string_view view() const noexcept { return view_; }

  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;
  ~FileBytes();

 private:
  std::string_view view_;
  bool mapped_ = false;
};

}  // namespace touchstone::io
