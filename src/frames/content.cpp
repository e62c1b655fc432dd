// SPDX-License-Identifier: MIT
#include "frames/content.hpp"

#include <array>
#include <cstring>
#include <utility>

#include "frames/text_scanner.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {

Content read_content(const std::string& file, io::InputFile::Checkpoint checkpoint) {
  constexpr std::size_t kLeast = std::size_t{1} << 16;
  std::size_t capacity = static_cast<std::size_t>(io::InputFile::check(file).value_or(kLeast)) + 1;
  io::InputFile input = io::InputFile::open(file, checkpoint);
  auto bytes = std::make_unique_for_overwrite<char[]>(capacity);
  std::size_t size = 0;
  for (;;) {
    if (size == capacity) {
      auto larger = std::make_unique_for_overwrite<char[]>(2 * capacity);
      std::memcpy(larger.get(), bytes.get(), size);
      bytes = std::move(larger);
      capacity *= 2;
    }
    const std::size_t count = input.read(bytes.get() + size, capacity - size);
    if (count == 0) return {std::move(bytes), size};
    size += count;
  }
}

Format format_of(const std::string& file) {
  constexpr std::array<std::pair<std::string_view, Format>, 7> kEndings = {{{".obj", Format::obj},
                                                                            {".ply", Format::ply},
                                                                            {".stl", Format::stl},
                                                                            {".vtk", Format::vtk},
                                                                            {".npy", Format::npy},
                                                                            {".h5", Format::hdf5},
                                                                            {".hdf5", Format::hdf5}}};
  const std::string_view name = file;
  for (const auto& [ending, format] : kEndings) {
    if (name.size() >= ending.size() && equal_but_for_case(name.substr(name.size() - ending.size()), ending)) {
      return format;
    }
  }
  io::fail(file, "has an ending that is not known; right are .obj, .ply, .stl, .vtk, .npy, .h5 and .hdf5");
}

}  // namespace touchstone::frames
