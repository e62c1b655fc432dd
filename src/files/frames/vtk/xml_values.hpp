// The values of the arrays of a VTK XML file: as text, as bytes, in base64, and compressed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frames/vtk/xml_document.hpp"

namespace touchstone::frames {

class XmlValues {
 public:
  /// Both are used as long as this object is.
  XmlValues(std::string_view file, const XmlDocument& document) : file_(file), document_(document) {}

  /// The integers of an array.
  /// @param count  how many there must be
  /// @throws FileError  for another number of values, and for an array of floats
  std::vector<std::int64_t> integers(const XmlArray& array, std::uint64_t count);

  /// Appends the numbers of an array of floats or doubles.
  /// @throws FileError  for another number of values, for one that is not finite, and for an array of integers
  void append_numbers(const XmlArray& array, std::uint64_t count, std::vector<double>& numbers);

 private:
  std::string_view bytes_of(const XmlArray& array, std::uint64_t size);
  template <class Source>
  std::string_view read_from(Source& source, const XmlArray& array, std::uint64_t size);
  template <class Source>
  void inflate_from(Source& source, const XmlArray& array, std::uint64_t size);
  template <class Source>
  std::uint64_t header_number(Source& source, const XmlArray& array) const;
  void count_appended(const XmlArray& array, std::uint64_t size);
  std::endian order(const XmlArray& array) const;
  [[noreturn]] void fail(const XmlArray& array, std::string_view reason) const;

  std::string_view file_;
  const XmlDocument& document_;
  std::string decoded_;         ///< of one array
  std::uint64_t appended_ = 0;  ///< bytes of the appended data that arrays have had
};

}  // namespace touchstone::frames
