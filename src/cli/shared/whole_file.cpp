// SPDX-License-Identifier: MIT
#include "cli/shared/whole_file.hpp"

#include <array>
#include <cstddef>

#include "cli/shared/interrupt.hpp"
#include "io/input_file.hpp"

namespace touchstone::cli {

std::string whole_file(const std::string& path) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;
  auto file = io::InputFile::open(path, throw_if_interrupted);
  std::string text;
  std::array<char, 1 << 16> block;
  for (std::size_t count; (count = file.read(block.data(), block.size())) > 0;) {
    text.append(block.data(), count);
    if (text.size() > kMostBytes) io::fail(path, "is larger than 1 GiB");
  }
  return text;
}

}  // namespace touchstone::cli
