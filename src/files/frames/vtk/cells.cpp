// SPDX-License-Identifier: MIT
#include "frames/vtk/cells.hpp"

#include <string>

namespace touchstone::frames {
namespace {

enum CellType : std::int64_t {
  vertex = 1,
  poly_vertex = 2,
  line = 3,
  poly_line = 4,
  triangle = 5,
  triangle_strip = 6,
  polygon = 7,
  quad = 9,
  tetrahedron = 10
};

void add_grid_cell(MeshBuilder& builder, std::uint64_t number, std::span<const MeshIndex> corners, std::int64_t type,
                   const FilePosition& position) {
  const auto check_corners = [&](std::size_t right) {
    if (corners.size() == right) return;
    position.fail("cell " + std::to_string(number) + " of type " + std::to_string(type) + " has " +
                  std::to_string(corners.size()) + " corners; right are " + std::to_string(right));
  };
  switch (type) {
    case vertex: check_corners(1); [[fallthrough]];
    case poly_vertex:
      for (const MeshIndex point : corners) builder.add_point(point);
      break;
    case line: check_corners(2); [[fallthrough]];
    case poly_line: return builder.add_polyline(corners, position);
    case triangle: check_corners(3); return builder.add_polygon(corners, number, position);
    case triangle_strip: return builder.add_strip(corners, number, position);
    case quad: check_corners(4); [[fallthrough]];
    case polygon: return builder.add_polygon(corners, number, position);
    case tetrahedron:
      check_corners(4);
      return builder.add_tetrahedron({corners[0], corners[1], corners[2], corners[3]}, number);
    default:
      position.fail("cell " + std::to_string(number) + " has the type " + std::to_string(type) +
                    "; 1 to 7, 9 and 10 are read: points, lines, triangles, strips, polygons and tetrahedra");
  }
}

}  // namespace

void add_grid_cells(MeshBuilder& builder, const VtkCells& cells, std::span<const std::int64_t> types,
                    std::uint64_t first_number, const FilePosition& position) {
  for (std::size_t i = 0; i < cells.count(); ++i) {
    add_grid_cell(builder, first_number + i, cells[i], types[i], position);
  }
}

void add_poly_data(MeshBuilder& builder, const std::array<VtkCells, kPolyLists>& lists, std::uint64_t first_face,
                   const FilePosition& position) {
  const auto& [vertices, lines, polygons, strips] = lists;
  for (const MeshIndex point : vertices.corners) builder.add_point(point);
  for (std::size_t i = 0; i < lines.count(); ++i) builder.add_polyline(lines[i], position);
  builder.reserve_faces(polygons.count());
  for (std::size_t i = 0; i < polygons.count(); ++i) builder.add_polygon(polygons[i], first_face + i, position);
  for (std::size_t i = 0; i < strips.count(); ++i) {
    builder.add_strip(strips[i], first_face + polygons.count() + i, position);
  }
}

}  // namespace touchstone::frames
