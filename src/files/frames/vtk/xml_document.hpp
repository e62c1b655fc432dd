// The structure of a VTK XML file: its pieces and their arrays, and where in the file the values are.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frames/mesh_builder.hpp"

namespace touchstone::frames {

/// The types of numbers, in the order of their names in xml_document.cpp.
enum class XmlType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

enum class XmlFormat : std::uint8_t { ascii, binary, appended };

/// The elements of a piece that have arrays of a mesh. Those of poly data are in the order of PolyList.
enum class XmlSection : std::uint8_t { vertices, lines, polygons, strips, cells, points };
inline constexpr std::size_t kXmlSections = 6;

enum class XmlName : std::uint8_t { connectivity, offsets, types, other };

/// A DataArray.
struct XmlArray {
  XmlSection section;
  XmlName name;
  XmlType type;
  XmlFormat format;
  std::uint64_t line;        ///< of the end of its tag
  std::uint64_t components;  ///< numbers that belong together
  std::uint64_t offset;      ///< where its values are in the appended data
  std::string_view text;     ///< its values, where they are not appended
};

/// A Piece. Its vertices are numbered from 0.
struct XmlPiece {
  std::uint64_t line = 0;
  std::array<std::uint64_t, kXmlSections> counts{};  ///< of points and of cells, by their section
  std::vector<XmlArray> arrays;
};

struct XmlDocument {
  bool is_grid = false;  ///< an unstructured grid, and not poly data
  std::optional<std::endian> order;
  std::size_t header_size = 4;  ///< of a number in the header of an array
  std::string compressor;       ///< empty: none
  std::vector<XmlPiece> pieces;
  std::string_view appended;
  bool is_raw = false;  ///< the appended data are bytes, and not base64
};

/// @throws FileError  for anything but an UnstructuredGrid or PolyData
XmlDocument read_xml_document(std::string_view file, std::string_view content);

}  // namespace touchstone::frames
