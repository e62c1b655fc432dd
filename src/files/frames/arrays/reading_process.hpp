// A file that another library reads, in a process of its own: a damaged file may crash the library, and nothing else.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <string>

#include "io/input_file.hpp"

namespace touchstone::frames {

/// A forked process that reads a file and hands its values over. It ends with this object, and, on Linux, with the
/// thread that made it.
///
/// In a process of several threads the child has a copy of the calling one alone. So `serve` must use nothing that
/// another thread may be in the middle of. Memory is safe: the C library takes care of its own locks at a fork.
class ReadingProcess {
 public:
  /// The child's end of the line.
  class Line {
   public:
    explicit Line(int descriptor) : descriptor_(descriptor) {}

    /// The parent's next request. @returns false when there is none any more
    bool next_request(void* to, std::size_t size) const;

    void reply(const void* from, std::size_t size) const;

   private:
    int descriptor_;
  };

  /// Forks, and calls `serve` in the child. An exception of it comes out of take().
  /// @param file     for messages
  /// @param library  that reads it, for messages: "the HDF5 library"
  /// @throws FileError  when no process can be made
  ReadingProcess(std::string file, std::string library, io::InputFile::Checkpoint checkpoint,
                 const std::function<void(const Line&)>& serve);
  ~ReadingProcess();
  ReadingProcess(const ReadingProcess&) = delete;
  ReadingProcess& operator=(const ReadingProcess&) = delete;

  void request(const void* from, std::size_t size);

  /// Waits for the next reply, which has this size.
  /// @throws FileError  for what `serve` threw, and when the process ended otherwise, with its signal; std::bad_alloc
  void take(void* to, std::size_t size);

 private:
  void receive(void* to, std::size_t size);
  [[noreturn]] void fail_at_end();

  std::string file_, library_;
  io::InputFile::Checkpoint checkpoint_;
  int descriptor_ = -1;
  pid_t child_ = -1;
};

}  // namespace touchstone::frames
