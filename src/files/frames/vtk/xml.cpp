// VTK's XML files of unstructured grids (.vtu) and poly data (.vtp).
// SPDX-License-Identifier: MIT
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "frames/formats.hpp"
#include "frames/vtk/cells.hpp"
#include "frames/vtk/xml_document.hpp"
#include "frames/vtk/xml_values.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

class XmlReader {
 public:
  XmlReader(std::string_view file, std::string_view content, bool triangulate)
      : file_(file),
        document_(read_xml_document(file, content)),
        values_(file, document_),
        builder_(triangulate, 0),
        most_(most_items(content.size())) {}

  MeshFile read() {
    for (const XmlPiece& piece : document_.pieces) {
      const MeshIndex first_vertex = static_cast<MeshIndex>(builder_.vertex_count());
      add_points(piece);
      document_.is_grid ? add_grid(piece, first_vertex) : add_lists(piece, first_vertex);
    }
    return builder_.finish({file_});
  }

 private:
  static std::uint64_t count_of(const XmlPiece& piece, XmlSection section) {
    return piece.counts[static_cast<std::size_t>(section)];
  }

  /// The only array of this name in a section; any name fits points.
  const XmlArray& array_of(const XmlPiece& piece, XmlSection section, XmlName name, const char* shown) const {
    const XmlArray* found = nullptr;
    for (const XmlArray& array : piece.arrays) {
      if (array.section != section || (section != XmlSection::points && array.name != name)) continue;
      if (found != nullptr) io::fail(file_, array.line, "a second DataArray of " + std::string(shown) + " in a Piece");
      found = &array;
    }
    if (found == nullptr) io::fail(file_, piece.line, "this Piece has no DataArray of " + std::string(shown));
    const std::uint64_t components = section == XmlSection::points ? 3 : 1;
    if (found->components != components) {
      io::fail(file_, found->line,
               "a DataArray of " + std::string(shown) + " has " + std::to_string(found->components) +
                   " components; right is " + std::to_string(components));
    }
    return *found;
  }

  /// Values that are compressed may be a thousand times as long.
  void count_items(const XmlPiece& piece, std::uint64_t count) {
    if (count > most_ - items_) {
      io::fail(
          file_, piece.line,
          "has more than " + std::to_string(most_) + " vertices, cells and corners, too many for a file of this size");
    }
    items_ += count;
  }

  void add_points(const XmlPiece& piece) {
    const std::uint64_t count = count_of(piece, XmlSection::points);
    if (count == 0) return;
    count_items(piece, count);
    const XmlArray& array = array_of(piece, XmlSection::points, XmlName::other, "points");
    values_.append_numbers(array, 3 * count, builder_.positions());
    constexpr std::uint64_t kMostVertices = std::uint64_t{1} << 32;
    if (builder_.vertex_count() >= kMostVertices) io::fail(file_, piece.line, "has 2^32 vertices, or more");
  }

  VtkCells cells_of(const XmlPiece& piece, XmlSection section, MeshIndex first_vertex) {
    VtkCells cells;
    const std::uint64_t count = count_of(piece, section);
    if (count == 0) return cells;
    const XmlArray& offsets = array_of(piece, section, XmlName::offsets, "offsets");
    count_items(piece, count);
    const std::vector<std::int64_t> ends = values_.integers(offsets, count);
    cells.starts.reserve(count + 1);
    for (const std::int64_t end : ends) {
      if (end < 0 || static_cast<std::uint64_t>(end) < cells.starts.back()) {
        io::fail(file_, offsets.line,
                 "the offset of cell " + std::to_string(cells.count()) + " is " + std::to_string(end) +
                     "; each is where a cell ends, and none is less than the one before");
      }
      cells.starts.push_back(static_cast<std::uint64_t>(end));
    }
    const std::uint64_t corners = cells.starts.back();
    if (corners == 0) return cells;
    count_items(piece, corners);
    const XmlArray& connectivity = array_of(piece, section, XmlName::connectivity, "connectivity");
    const FilePosition position{file_, connectivity.line};
    const std::vector<std::int64_t> indices = values_.integers(connectivity, corners);
    cells.corners.reserve(corners);
    for (const std::int64_t index : indices) {
      cells.corners.push_back(first_vertex + checked_vertex(index, count_of(piece, XmlSection::points), position));
    }
    return cells;
  }

  void add_grid(const XmlPiece& piece, MeshIndex first_vertex) {
    const VtkCells cells = cells_of(piece, XmlSection::cells, first_vertex);
    if (cells.count() == 0) return;
    const XmlArray& types = array_of(piece, XmlSection::cells, XmlName::types, "types");
    add_grid_cells(builder_, cells, values_.integers(types, cells.count()), cells_, {file_, piece.line});
    cells_ += cells.count();
  }

  void add_lists(const XmlPiece& piece, MeshIndex first_vertex) {
    std::array<VtkCells, kPolyLists> lists;
    for (std::size_t i = 0; i < kPolyLists; ++i) {
      lists[i] = cells_of(piece, static_cast<XmlSection>(i), first_vertex);
    }
    add_poly_data(builder_, lists, cells_, {file_, piece.line});
    cells_ += lists[static_cast<std::size_t>(PolyList::polygons)].count() +
              lists[static_cast<std::size_t>(PolyList::strips)].count();
  }

  std::string_view file_;
  XmlDocument document_;
  XmlValues values_;
  MeshBuilder builder_;
  std::uint64_t most_, items_ = 0;  ///< vertices, cells and corners
  std::uint64_t cells_ = 0;         ///< of a grid, or the faces of poly data, in the pieces before
};

}  // namespace

MeshFile read_vtk_xml(std::string_view file, std::string_view content, bool triangulate) {
  return XmlReader(file, content, triangulate).read();
}

}  // namespace touchstone::frames
