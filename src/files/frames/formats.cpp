// SPDX-License-Identifier: MIT
#include "frames/formats.hpp"

#include <numeric>

#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

Topology topology_from_indices(const std::string& file, std::string_view content, const ArrayShape& shape) {
  const IndexRows rows = read_npy_indices(file, content);
  Topology topology;
  for (std::size_t i = 0; i < rows.values.size(); i += rows.width) {
    const auto vertex = [&](std::size_t k) {
      const std::int64_t index = rows.values[i + k];
      if (index >= 0 && static_cast<std::uint64_t>(index) < shape.vertices) return static_cast<MeshIndex>(index);
      io::fail(file, "row " + std::to_string(i / rows.width) + ": " + fault_of_index(index, shape.vertices, 0));
    };
    if (rows.width == 3) topology.faces.push_back({vertex(0), vertex(1), vertex(2)});
    if (rows.width == 2) topology.edges.push_back({vertex(0), vertex(1)});
  }
  if (rows.values.empty()) topology.points = loose_points(shape).points;
  return topology;
}

}  // namespace

MeshFile read_mesh(Format format, std::string_view file, std::string_view content, bool triangulate) {
  switch (format) {
    case Format::obj: return read_obj(file, content, triangulate);
    case Format::ply: return read_ply(file, content, triangulate);
    case Format::stl: return read_stl(file, content);
    case Format::vtk: return read_vtk(file, content, triangulate);
    case Format::vtk_xml: return read_vtk_xml(file, content, triangulate);
    case Format::off: return read_off(file, content, triangulate);
    case Format::msh: return read_msh(file, content, triangulate);
    case Format::gltf: return read_gltf(file, content);
    case Format::npy:
    case Format::hdf5:
    case Format::pc2:
    case Format::mdd: break;
  }
  io::fail(file, "is no mesh file; right are .obj, .ply, .stl, .vtk, .vtu, .vtp, .off, .msh, .gltf and .glb");
}

Topology topology_from(const std::string& file, std::string_view content, const ArrayShape& shape, bool triangulate) {
  const Format format = format_of(file);
  Topology topology = format == Format::npy ? topology_from_indices(file, content, shape)
                                            : read_mesh(format, file, content, triangulate).topology;
  if (format == Format::npy) topology.vertex_count = shape.vertices;
  if (topology.vertex_count != shape.vertices) {
    io::fail(file, "has " + std::to_string(topology.vertex_count) + " vertices, and the positions are of " +
                       std::to_string(shape.vertices));
  }
  if (shape.dimension == 2 && !topology.faces.empty()) {
    io::fail(file, "has faces, and the positions have two coordinates; a mesh in the plane has edges and points");
  }
  topology.dimension = static_cast<int>(shape.dimension);
  return topology;
}

Topology loose_points(const ArrayShape& shape) {
  Topology topology;
  topology.vertex_count = shape.vertices;
  topology.dimension = static_cast<int>(shape.dimension);
  topology.points.resize(shape.vertices);
  std::iota(topology.points.begin(), topology.points.end(), MeshIndex{0});
  return topology;
}

}  // namespace touchstone::frames
