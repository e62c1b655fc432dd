// SPDX-License-Identifier: MIT
#include "frames/content.hpp"

#include <array>
#include <utility>

#include "frames/text_scanner.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {

namespace {

bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() && equal_but_for_case(name.substr(name.size() - ending.size()), ending);
}

}  // namespace

io::WholeFile read_content(const std::string& file, io::InputFile::Checkpoint checkpoint) {
  io::FileLimits limits = kMeshLimits;
  if (format_of(file) != Format::obj) limits.line = 0;  // bytes, or a list of numbers on one line
  return io::WholeFile::read(file, limits, checkpoint);
}

std::optional<Format> known_format_of(const std::string& file) {
  constexpr std::array<std::pair<std::string_view, Format>, 15> kEndings = {{{".obj", Format::obj},
                                                                             {".ply", Format::ply},
                                                                             {".stl", Format::stl},
                                                                             {".vtk", Format::vtk},
                                                                             {".vtu", Format::vtk_xml},
                                                                             {".vtp", Format::vtk_xml},
                                                                             {".off", Format::off},
                                                                             {".msh", Format::msh},
                                                                             {".gltf", Format::gltf},
                                                                             {".glb", Format::gltf},
                                                                             {".npy", Format::npy},
                                                                             {".h5", Format::hdf5},
                                                                             {".hdf5", Format::hdf5},
                                                                             {".pc2", Format::pc2},
                                                                             {".mdd", Format::mdd}}};
  for (const auto& [ending, format] : kEndings) {
    if (ends_with(file, ending)) return format;
  }
  return std::nullopt;
}

bool has_text_rows(const std::string& file) { return ends_with(file, ".csv") || ends_with(file, ".txt"); }

Format format_of(const std::string& file) {
  if (const auto format = known_format_of(file)) return *format;
  for (const std::string_view ending : {".abc", ".blend", ".dae", ".fbx", ".usd", ".usda", ".usdc", ".usdz"}) {
    if (!ends_with(file, ending)) continue;
    io::fail(file,
             "is a file of an animation program, which is not read; Blender writes its frames as .obj files (File > "
             "Export > Wavefront, with Animation)");
  }
  io::fail(file,
           "has an ending that is not known; right are .obj, .ply, .stl, .vtk, .vtu, .vtp, .off, .msh, .gltf, .glb, "
           ".npy, .h5, .hdf5, .pc2 and .mdd; meshio, a program of its own, makes one of another: meshio convert a.x "
           "a.ply");
}

}  // namespace touchstone::frames
