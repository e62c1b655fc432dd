// SPDX-License-Identifier: MIT
#include "frames/vtk/xml_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "frames/base64.hpp"
#include "frames/text_scanner.hpp"
#include "frames/vtk/inflate.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

/// Bytes as they are. Base64Reader has the same functions.
class RawReader {
 public:
  explicit RawReader(std::string_view bytes) : bytes_(bytes) {}

  bool read(char* to, std::size_t count) noexcept {
    if (count > bytes_.size()) return false;
    std::memcpy(to, bytes_.data(), count);
    bytes_.remove_prefix(count);
    return true;
  }
  bool at_end() const noexcept { return bytes_.empty(); }
  std::size_t most_remaining() const noexcept { return bytes_.size(); }
  std::size_t characters_remaining() const noexcept { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

bool is_float(XmlType type) { return type >= XmlType::float32; }

std::size_t size_of(XmlType type) {
  switch (type) {
    case XmlType::int8:
    case XmlType::uint8: return 1;
    case XmlType::int16:
    case XmlType::uint16: return 2;
    case XmlType::int32:
    case XmlType::uint32:
    case XmlType::float32: return 4;
    case XmlType::int64:
    case XmlType::uint64:
    case XmlType::float64: return 8;
  }
  return 8;
}

/// An integer of 64 bits without a sign that is too great becomes a negative one, which no vertex has as its number.
std::int64_t integer_at(const char* at, XmlType type, std::endian order) {
  switch (type) {
    case XmlType::int8: return static_cast<std::int8_t>(*at);
    case XmlType::uint8: return static_cast<std::uint8_t>(*at);
    case XmlType::int16: return static_cast<std::int16_t>(io::unsigned_at<std::uint16_t>(at, order));
    case XmlType::uint16: return io::unsigned_at<std::uint16_t>(at, order);
    case XmlType::int32: return static_cast<std::int32_t>(io::unsigned_at<std::uint32_t>(at, order));
    case XmlType::uint32: return io::unsigned_at<std::uint32_t>(at, order);
    default: return static_cast<std::int64_t>(io::unsigned_at<std::uint64_t>(at, order));
  }
}

/// Calls `take` with a scanner, once for each value of an array of text.
template <class Take>
void scan(std::string_view file, const XmlArray& array, std::uint64_t count, Take take) {
  TextScanner scanner(file, array.text, false, array.line);
  if (count > array.text.size() / 2 + 1) {
    scanner.fail("a DataArray of " + std::to_string(count) + " values is too short for them");
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    if (scanner.at_file_end())
      scanner.fail("a DataArray ends before the last of its " + std::to_string(count) + " values");
    take(scanner);
  }
  if (!scanner.at_file_end()) scanner.fail(io::in_quotes(scanner.word()) + " after the last value of a DataArray");
}

}  // namespace

void XmlValues::fail(const XmlArray& array, std::string_view reason) const {
  io::fail(file_, array.line, "this DataArray " + std::string(reason));
}

std::endian XmlValues::order(const XmlArray& array) const {
  if (!document_.order) fail(array, "is of bytes, and VTKFile has no byte_order");
  return *document_.order;
}

std::vector<std::int64_t> XmlValues::integers(const XmlArray& array, std::uint64_t count) {
  if (is_float(array.type)) fail(array, "must have a type of integers");
  std::vector<std::int64_t> values;
  if (array.format == XmlFormat::ascii) {
    scan(file_, array, count,
         [&](TextScanner& scanner) { values.push_back(scanner.next_integer("a value of a DataArray")); });
    return values;
  }
  const std::size_t size = size_of(array.type);
  const std::string_view bytes = bytes_of(array, count * size);
  values.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    values.push_back(integer_at(bytes.data() + i * size, array.type, order(array)));
  }
  return values;
}

void XmlValues::append_numbers(const XmlArray& array, std::uint64_t count, std::vector<double>& numbers) {
  if (!is_float(array.type)) fail(array, "must have the type Float32 or Float64");
  if (array.format == XmlFormat::ascii) {
    return scan(file_, array, count,
                [&](TextScanner& scanner) { numbers.push_back(scanner.next_number("a coordinate")); });
  }
  const std::size_t size = size_of(array.type);
  const std::string_view bytes = bytes_of(array, count * size);
  numbers.reserve(numbers.size() + count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const char* const at = bytes.data() + i * size;
    numbers.push_back(size == 8 ? io::double_at(at, order(array)) : io::float_at(at, order(array)));
    if (!std::isfinite(numbers.back())) {
      fail(array, "has a coordinate that is not finite, of point " + std::to_string(i / 3));
    }
  }
}

/// The bytes of an array, of this size.
std::string_view XmlValues::bytes_of(const XmlArray& array, std::uint64_t size) {
  if (array.format == XmlFormat::binary) {
    Base64Reader source(array.text);
    const std::string_view bytes = read_from(source, array, size);
    if (!source.at_end()) fail(array, "has more in base64 than the bytes that it announces");
    return bytes;
  }
  const std::string_view appended = document_.appended;
  if (array.offset >= appended.size()) fail(array, "has an offset beyond the appended data");
  const auto read = [&](auto source) {
    const std::size_t before = source.characters_remaining();
    const std::string_view bytes = read_from(source, array, size);
    count_appended(array, before - source.characters_remaining());
    return bytes;
  };
  const std::string_view from = appended.substr(array.offset);
  return document_.is_raw ? read(RawReader(from)) : read(Base64Reader(from));
}

/// A short file whose arrays are all in one stretch of the appended data would stand for any number of vertices.
void XmlValues::count_appended(const XmlArray& array, std::uint64_t size) {
  appended_ += size;
  if (appended_ > document_.appended.size()) fail(array, "overlaps another one in the appended data");
}

template <class Source>
std::string_view XmlValues::read_from(Source& source, const XmlArray& array, std::uint64_t size) {
  if (!document_.compressor.empty()) {
    inflate_from(source, array, size);
    return decoded_;
  }
  const std::uint64_t announced = header_number(source, array);
  if (announced != size) {
    fail(array, "announces " + std::to_string(announced) + " bytes; its values are " + std::to_string(size) + " bytes");
  }
  if (size > source.most_remaining())
    fail(array, "is too short for the " + std::to_string(size) + " bytes of its values");
  decoded_.resize(size);
  if (!source.read(decoded_.data(), size)) fail(array, "is cut off, or no base64");
  return decoded_;
}

/// A header of three numbers, the number of blocks, the size of a block, and that of the last one or 0 where it has the
/// same size; then the compressed sizes of the blocks; then the blocks.
template <class Source>
void XmlValues::inflate_from(Source& source, const XmlArray& array, std::uint64_t size) {
  if (document_.compressor != "vtkZLibDataCompressor") {
    fail(array, "has the compressor " + io::in_quotes(document_.compressor) +
                    ", which is not read; write the file with the compressor ZLib or none");
  }
  const std::uint64_t blocks = header_number(source, array), block = header_number(source, array),
                      last = header_number(source, array);
  if (blocks > source.most_remaining() / document_.header_size) fail(array, "is too short for its blocks");
  std::vector<std::uint64_t> compressed;
  for (std::uint64_t i = 0; i < blocks; ++i) compressed.push_back(header_number(source, array));
  // blocks * block is computed only where it is not more than size and a block.
  const bool fits = blocks == 0 ? size == 0
                                : blocks - 1 <= size / std::max<std::uint64_t>(block, 1) && last <= block &&
                                      (blocks - 1) * block + (last == 0 ? block : last) == size;
  if (!fits) fail(array, "has blocks that do not make up the " + std::to_string(size) + " bytes of its values");
  if (size / kMostInflation > source.most_remaining()) {
    fail(array, "is too short for the " + std::to_string(size) + " bytes of its values");
  }
  decoded_.resize(size);
  std::string bytes;
  for (std::uint64_t i = 0, at = 0; i < blocks; at += block, ++i) {
    if (compressed[i] > source.most_remaining()) fail(array, "is too short for its blocks");
    bytes.resize(compressed[i]);
    if (!source.read(bytes.data(), bytes.size())) fail(array, "is cut off, or no base64");
    const std::string_view fault = inflate(bytes, decoded_.data() + at, std::min(block, size - at));
    if (!fault.empty()) fail(array, fault);
  }
}

template <class Source>
std::uint64_t XmlValues::header_number(Source& source, const XmlArray& array) const {
  std::array<char, 8> bytes{};
  if (!source.read(bytes.data(), document_.header_size)) fail(array, "ends within its header, or is no base64");
  if (document_.header_size == 8) return io::unsigned_at<std::uint64_t>(bytes.data(), order(array));
  return io::unsigned_at<std::uint32_t>(bytes.data(), order(array));
}

}  // namespace touchstone::frames
