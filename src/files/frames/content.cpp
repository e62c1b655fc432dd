// SPDX-License-Identifier: MIT
#include "frames/content.hpp"

#include <array>
#include <utility>

#include "frames/text_scanner.hpp"
#include "io/fail.hpp"
#include "io/foreign_bytes.hpp"

namespace touchstone::frames {

namespace {

bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() && equal_but_for_case(name.substr(name.size() - ending.size()), ending);
}

}  // namespace

io::WholeFile read_content(const std::string& file, io::InputFile::Checkpoint checkpoint) {
  io::FileLimits limits = kMeshLimits;
  const Format format = format_of(file);
  if (format != Format::obj) limits.line = 0;  // bytes, or a list of numbers on one line
  io::WholeFile content = io::WholeFile::read(file, limits, checkpoint);
  const bool may_start_so = format == Format::stl || format == Format::npy;  // a binary STL file has any 80 bytes first
  if (!may_start_so) io::refuse_foreign_bytes(file, content.bytes());
  return content;
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

std::string fault_of_unread_format(const std::string& file) {
  struct Unread {
    std::string_view ending, fault;
  };
  constexpr std::string_view kAnimation =
      "is a file of an animation program, which is not read; Blender writes its frames as .obj files (File > Export > "
      "Wavefront, with Animation)";
  constexpr std::string_view kDesign =
      "is a file of curved surfaces, which is not read; gmsh, a program of its own, makes triangles of them: gmsh -2 "
      "a.step -o a.stl";
  constexpr std::string_view kPrint =
      "is a file for printing, which is not read; trimesh, a package of Python, makes another of it: "
      "trimesh.load_mesh('a.3mf').export('a.ply')";
  constexpr std::string_view kHoudini = "is a file of Houdini, which is not read; save the geometry there as .obj";
  constexpr std::string_view kGrid =
      "is a file of meshes that is not read; meshio, a program of its own, makes another of it: meshio convert a.xdmf "
      "a.ply";
  constexpr Unread kUnread[] = {
      {".abc", kAnimation},  {".blend", kAnimation}, {".dae", kAnimation},  {".fbx", kAnimation}, {".usd", kAnimation},
      {".usda", kAnimation}, {".usdc", kAnimation},  {".usdz", kAnimation}, {".3ds", kAnimation}, {".x3d", kAnimation},
      {".step", kDesign},    {".stp", kDesign},      {".iges", kDesign},    {".igs", kDesign},    {".brep", kDesign},
      {".3mf", kPrint},      {".bgeo", kHoudini},    {".xdmf", kGrid}};
  for (const auto& [ending, fault] : kUnread) {
    if (ends_with(file, ending)) return std::string(fault);
  }
  return {};
}

Format format_of(const std::string& file) {
  if (const auto format = known_format_of(file)) return *format;
  const auto size = io::InputFile::check(file);  // a name that is misspelt has another fault than its ending
  if (const std::string fault = fault_of_unread_format(file); !fault.empty()) io::fail(file, fault);
  if (size) {  // a.obj.gz
    std::string start(io::kForeignStart, '\0');
    start.resize(io::InputFile::open(file).read(start.data(), start.size()));
    io::refuse_foreign_bytes(file, start);
  }
  io::fail(file,
           "has an ending that is not known; right are .obj, .ply, .stl, .vtk, .vtu, .vtp, .off, .msh, .gltf, .glb, "
           ".npy, .h5, .hdf5, .pc2 and .mdd; meshio, a program of its own, makes these of some others: meshio convert "
           "a.inp a.ply");
}

}  // namespace touchstone::frames
