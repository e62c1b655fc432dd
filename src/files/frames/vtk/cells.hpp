// The cells of VTK's files, legacy and XML.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "frames/mesh_builder.hpp"

namespace touchstone::frames {

/// The corners of cell i are corners[starts[i]] to corners[starts[i + 1]], without the last.
struct VtkCells {
  std::vector<std::uint64_t> starts{0};
  std::vector<MeshIndex> corners;

  std::size_t count() const { return starts.size() - 1; }
  std::span<const MeshIndex> operator[](std::size_t cell) const {
    return std::span(corners).subspan(starts[cell], starts[cell + 1] - starts[cell]);
  }
};

/// Adds the cells of an unstructured grid.
/// @param types         VTK's number of the type of each cell, as many as cells
/// @param first_number  the number of the first cell
/// @throws FileError  for a type that is not read, and for a number of corners that the type does not have
void add_grid_cells(MeshBuilder& builder, const VtkCells& cells, std::span<const std::int64_t> types,
                    std::uint64_t first_number, const FilePosition& position);

/// The lists of cells that poly data has, in the order of their numbers.
enum class PolyList : std::uint8_t { vertices, lines, polygons, strips };
inline constexpr std::size_t kPolyLists = 4;

/// Adds the cells of poly data. Faces are numbered from `first_face` on, strips after polygons.
void add_poly_data(MeshBuilder& builder, const std::array<VtkCells, kPolyLists>& lists, std::uint64_t first_face,
                   const FilePosition& position);

}  // namespace touchstone::frames
