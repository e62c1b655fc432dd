// Through zlib.
// SPDX-License-Identifier: MIT
#include "frames/vtk/inflate.hpp"

#include <zlib.h>

#include <limits>

namespace touchstone::frames {

std::string_view inflate(std::string_view compressed, char* to, std::size_t size) {
  constexpr std::string_view kFault = "has a block that zlib cannot read, or that is longer or shorter than it says";
  uLongf found = size;
  if (size > std::numeric_limits<uLong>::max() || compressed.size() > std::numeric_limits<uLong>::max()) return kFault;
  const int status = ::uncompress(reinterpret_cast<Bytef*>(to), &found,
                                  reinterpret_cast<const Bytef*>(compressed.data()), compressed.size());
  return status == Z_OK && found == size ? std::string_view() : kFault;
}

}  // namespace touchstone::frames
