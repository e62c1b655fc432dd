// The build without expat.
// SPDX-License-Identifier: MIT
#include "frames/formats.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {

MeshFile read_vtk_xml(std::string_view file, std::string_view, bool) {
  io::fail(file,
           "cannot be read: touchstone was built without expat (Debian: libexpat1-dev); install it and build again, or "
           "save the mesh as .vtk or .ply: meshio convert a.vtu a.ply");
}

}  // namespace touchstone::frames
