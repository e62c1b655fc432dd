// The build without nlohmann-json, of the Python module.
// SPDX-License-Identifier: MIT
#include "frames/formats.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {

MeshFile read_gltf(std::string_view file, std::string_view) {
  io::fail(file,
           "cannot be read: touchstone was built without nlohmann-json (Debian: nlohmann-json3-dev); install it and "
           "build again, or save the mesh as .ply");
}

std::vector<std::string> files_beside(const std::string&) { return {}; }

}  // namespace touchstone::frames
