// All bytes of a file in memory, within limits: a device may have no end, and a file of a few blocks may say terabytes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "io/input_file.hpp"

namespace touchstone::io {

/// In bytes. A multiple of 1 MiB, as messages say them.
struct FileLimits {
  std::uint64_t file = 0;    ///< of a file, which has a size
  std::uint64_t stream = 0;  ///< of a pipe or device
  std::uint64_t line = 0;    ///< of a line of text; 0: no limit
};

/// Of a scene, a checkpoint or a report, which is JSON.
inline constexpr FileLimits kJsonLimits{std::uint64_t{1} << 30, std::uint64_t{1} << 30, 0};

class WholeFile {
 public:
  /// Reads a file, pipe or device until its end.
  /// @throws FileError  where it cannot be read, and where it exceeds a limit, which the message names
  static WholeFile read(const std::string& path, const FileLimits& limits, InputFile::Checkpoint checkpoint);

  /// The same of a file that is open, from where it is read next.
  static WholeFile read(InputFile input, const FileLimits& limits);

  std::string_view bytes() const noexcept { return {bytes_.get(), size_}; }

 private:
  WholeFile(std::unique_ptr<char[]> bytes, std::size_t size) : bytes_(std::move(bytes)), size_(size) {}

  std::unique_ptr<char[]> bytes_;
  std::size_t size_;
};

/// "64 GiB", "1 MiB".
std::string size_text(std::uint64_t bytes);

}  // namespace touchstone::io
