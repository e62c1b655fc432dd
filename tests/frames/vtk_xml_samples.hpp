// VTK XML files, written here without the project's own code.
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include "frames/samples.hpp"

namespace touchstone::tests {

/// Whether the build has expat, and zlib too.
inline constexpr bool kReadsVtkXml = TOUCHSTONE_TESTS_EXPAT;
inline constexpr bool kInflates = TOUCHSTONE_TESTS_EXPAT && TOUCHSTONE_TESTS_ZLIB;

/// How a file is written.
struct XmlStyle {
  std::endian order = std::endian::little;
  std::size_t header_size = 4;  ///< of a number in the header of an array
  std::size_t block = 0;        ///< the size of compressed blocks; 0: not compressed
  bool appended = false, raw = false;
  bool joined = false;  ///< the header is in base64 together with the values
};

/// A file that is written array by array.
class XmlWriter {
 public:
  explicit XmlWriter(const XmlStyle& style) : style_(style) {}

  /// A DataArray of these bytes. @param attributes  its type, its name
  std::string array(const std::string& attributes, std::string_view bytes);

  /// The file. @param pieces  the content of UnstructuredGrid or PolyData
  std::string file(const std::string& data_set, const std::string& pieces) const;

  template <class Number, class Values>
  std::string numbers(const std::string& attributes, const Values& values) {
    std::string bytes;
    for (const auto value : values) bytes += bytes_of(static_cast<Number>(value), style_.order);
    return array(attributes, bytes);
  }

 private:
  std::string header(const std::vector<std::size_t>& numbers) const;
  std::string values(std::string_view bytes) const;

  XmlStyle style_;
  std::string appended_;
};

/// A zlib stream whose blocks are stored as they are.
std::string stored(std::string_view bytes);

/// The mesh in several files. None where the build does not read them.
std::vector<Sample> vtk_xml_samples();

}  // namespace touchstone::tests
