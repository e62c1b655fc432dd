// The build without zlib.
// SPDX-License-Identifier: MIT
#include "frames/vtk/inflate.hpp"

namespace touchstone::frames {

std::string_view inflate(std::string_view, char*, std::size_t) {
  return "is compressed, and touchstone was built without zlib (Debian: zlib1g-dev); install it and build again, or "
         "write the file without a compressor";
}

}  // namespace touchstone::frames
