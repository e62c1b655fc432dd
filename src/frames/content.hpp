// The bytes of a file, and what its name says about them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "io/input_file.hpp"

namespace touchstone::frames {

/// The whole content of a file.
class Content {
 public:
  Content(std::unique_ptr<char[]> bytes, std::size_t size) : bytes_(std::move(bytes)), size_(size) {}

  std::string_view bytes() const noexcept { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_;
};

/// Reads a file, pipe or device until its end. @throws FileError  where it cannot be read
Content read_content(const std::string& file, io::InputFile::Checkpoint checkpoint);

enum class Format : std::uint8_t { obj, ply, stl, vtk, npy, hdf5 };

/// The format that the ending of the name says, in upper or lower case. @throws FileError  for other endings
Format format_of(const std::string& file);

}  // namespace touchstone::frames
