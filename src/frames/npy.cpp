// NumPy's .npy: positions of frames, and the corners of faces or edges.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "frames/array.hpp"
#include "frames/bytes.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

struct Header {
  char kind = 'f';  ///< 'f', 'i' or 'u'
  std::size_t size = 8;
  std::endian order = std::endian::little;
  bool fortran = false;
  std::vector<std::uint64_t> extents;
  std::uint64_t values = 1;       ///< the product of the extents
  std::uint64_t header_size = 0;  ///< the number of bytes before the first value
};

/// Reads the header's text, the literal of a Python dictionary: {'descr': '<f8', 'fortran_order': False,
/// 'shape': (3, 4), }
class HeaderText {
 public:
  HeaderText(std::string_view file, std::string_view text) : file_(file), text_(text) {}

  void read(Header& header) {
    expect('{');
    std::array<bool, 3> seen{};
    while (!skip('}')) {
      const std::string_view key = quoted();
      expect(':');
      constexpr std::array<std::string_view, 3> kKeys = {"descr", "fortran_order", "shape"};
      const auto which = static_cast<std::size_t>(std::find(kKeys.begin(), kKeys.end(), key) - kKeys.begin());
      if (which == kKeys.size() || seen[which]) fail("has the key " + io::in_quotes(key));
      seen[which] = true;
      if (which == 0) read_type(header);
      if (which == 1) header.fortran = truth();
      if (which == 2) header.extents = tuple();
      if (!skip(',')) {
        expect('}');
        break;
      }
    }
    blanks();
    if (!text_.empty()) fail("goes on after '}' with " + io::in_quotes(text_));
    if (!seen[0] || !seen[1] || !seen[2]) fail("lacks one of 'descr', 'fortran_order' and 'shape'");
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    io::fail(file_, "the header of the .npy file " + reason + "; right is, for example, " +
                        "{'descr': '<f8', 'fortran_order': False, 'shape': (100, 3), }");
  }

  void blanks() {
    while (!text_.empty() && (text_.front() == ' ' || text_.front() == '\n' || text_.front() == '\t')) {
      text_.remove_prefix(1);
    }
  }
  bool skip(char c) {
    blanks();
    if (!text_.starts_with(c)) return false;
    text_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!skip(c)) fail("has " + io::in_quotes(text_) + " where " + io::in_quotes({&c, 1}) + " should be");
  }

  std::string_view quoted() {
    blanks();
    const char quote = text_.starts_with('"') ? '"' : '\'';
    expect(quote);
    const std::size_t end = text_.find(quote);
    if (end == std::string_view::npos) fail("has a text without an end");
    const std::string_view found = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    return found;
  }

  void read_type(Header& header) {
    blanks();
    if (text_.starts_with('[')) fail("describes records; an array of plain numbers is read");
    const std::string_view type = quoted();
    const bool is_known =
        type.size() == 3 && std::string_view("<>=|").find(type[0]) != std::string_view::npos &&
        ((type[1] == 'f' && (type[2] == '4' || type[2] == '8')) ||
         ((type[1] == 'i' || type[1] == 'u') && std::string_view("1248").find(type[2]) != std::string_view::npos));
    if (!is_known || (type[0] == '|' && type[2] != '1')) {
      fail("has the type " + io::in_quotes(type) + "; read are float64 and float32, and integers for topology");
    }
    header.kind = type[1];
    header.size = static_cast<std::size_t>(type[2] - '0');
    header.order = type[0] == '>' ? std::endian::big : type[0] == '<' ? std::endian::little : std::endian::native;
  }

  bool truth() {
    blanks();
    for (const bool value : {false, true}) {
      const std::string_view name = value ? "True" : "False";
      if (!text_.starts_with(name)) continue;
      text_.remove_prefix(name.size());
      return value;
    }
    fail("has " + io::in_quotes(text_) + " where True or False should be");
  }

  std::vector<std::uint64_t> tuple() {
    std::vector<std::uint64_t> values;
    expect('(');
    while (!skip(')')) {
      values.push_back(extent());
      if (!skip(',')) {
        expect(')');
        break;
      }
    }
    return values;
  }

  std::uint64_t extent() {
    blanks();
    std::uint64_t value = 0;
    std::size_t digits = 0;
    for (; digits < text_.size() && text_[digits] >= '0' && text_[digits] <= '9'; ++digits) {
      if (digits == 18) fail("has an extent of more than 18 digits");
      value = 10 * value + static_cast<std::uint64_t>(text_[digits] - '0');
    }
    if (digits == 0) fail("has " + io::in_quotes(text_) + " where an extent should be");
    text_.remove_prefix(digits);
    return value;
  }

  std::string_view file_;
  std::string_view text_;
};

constexpr std::string_view kMagic = "\x93NUMPY";

/// Reads exactly `count` bytes. @throws FileError  where the file ends before
void read_exactly(io::InputFile& file, char* to, std::size_t count) {
  while (count > 0) {
    const std::size_t got = file.read(to, count);
    if (got == 0) io::fail(file.name(), "ends too early: it is cut off, or no .npy file");
    to += got;
    count -= got;
  }
}

/// @param file_size  of the whole file
Header read_header(io::InputFile& file, std::uint64_t file_size) {
  std::array<char, 12> start;
  read_exactly(file, start.data(), 8);
  if (std::string_view(start.data(), kMagic.size()) != kMagic) {
    io::fail(file.name(), "is no .npy file: it does not start with \\x93NUMPY");
  }
  const int version = start[6];
  if (version < 1 || version > 3 || start[7] != 0) {
    io::fail(file.name(), "is an .npy file of version " + std::to_string(static_cast<unsigned char>(start[6])) + "." +
                              std::to_string(static_cast<unsigned char>(start[7])) + "; known are 1.0, 2.0 and 3.0");
  }
  const std::size_t length_size = version == 1 ? 2 : 4;
  read_exactly(file, start.data() + 8, length_size);
  const std::size_t length = version == 1 ? unsigned_at<std::uint16_t>(start.data() + 8, std::endian::little)
                                          : unsigned_at<std::uint32_t>(start.data() + 8, std::endian::little);
  constexpr std::size_t kLongest = 1 << 20;  // NumPy's own limit is 10,000
  if (length > kLongest) io::fail(file.name(), "has a header of more than a megabyte");
  std::string text(length, '\0');
  read_exactly(file, text.data(), length);

  Header header;
  header.header_size = 8 + length_size + length;
  HeaderText(file.name(), text).read(header);
  const std::uint64_t most = (file_size - header.header_size) / header.size;
  for (const std::uint64_t extent : header.extents) {
    if (extent != 0 && header.values > std::numeric_limits<std::uint64_t>::max() / extent) {
      header.values = std::numeric_limits<std::uint64_t>::max();
      break;
    }
    header.values *= extent;
  }
  if (header.values != most || (file_size - header.header_size) % header.size != 0) {
    const std::string values = header.values == std::numeric_limits<std::uint64_t>::max()
                                   ? std::string("more than 2^64")
                                   : std::to_string(header.values);
    io::fail(file.name(), "an array of shape " + shape_text(header.extents) + " has " + values + " values of " +
                              std::to_string(header.size) + " bytes, and the file has " +
                              std::to_string(file_size - header.header_size) + " bytes for them");
  }
  return header;
}

struct OpenArray {
  io::InputFile file;
  Header header;
  ArrayShape shape;
};

OpenArray open_positions(const std::string& name, const ReadOptions& options) {
  const auto size = io::InputFile::check(name);
  if (!size) io::fail(name, "is a pipe or device; an array of frames is read from a file");
  io::InputFile file = io::InputFile::open(name, options.checkpoint);
  const Header header = read_header(file, *size);
  if (header.kind != 'f') io::fail(name, "holds integers; positions have the type float64 or float32");
  const ArrayShape shape = shape_of_positions(name, {}, header.extents);
  return {std::move(file), header, shape};
}

double value_at(const char* at, const Header& header) {
  return header.size == 4 ? float_at(at, header.order) : double_at(at, header.order);
}

constexpr std::size_t kChunk = std::size_t{1} << 20;

/// Calls `use(i, value)` for the `count` values that come next in the file.
template <class Use>
void for_each_value(io::InputFile& file, const Header& header, std::uint64_t count, Use use) {
  std::vector<char> chunk(std::min<std::uint64_t>(count * header.size, kChunk));
  for (std::uint64_t i = 0; i < count;) {
    const std::uint64_t values = std::min<std::uint64_t>(count - i, chunk.size() / header.size);
    read_exactly(file, chunk.data(), values * header.size);
    for (std::uint64_t k = 0; k < values; ++k, ++i) use(i, value_at(chunk.data() + k * header.size, header));
  }
}

std::int64_t index_at(const char* at, const Header& header) {
  const bool is_signed = header.kind == 'i';
  switch (header.size) {
    case 1: return is_signed ? std::int64_t{static_cast<std::int8_t>(*at)} : static_cast<std::uint8_t>(*at);
    case 2: {
      const auto value = unsigned_at<std::uint16_t>(at, header.order);
      return is_signed ? std::int64_t{static_cast<std::int16_t>(value)} : value;
    }
    case 4: {
      const auto value = unsigned_at<std::uint32_t>(at, header.order);
      return is_signed ? std::int64_t{static_cast<std::int32_t>(value)} : value;
    }
    default: {
      const auto value = unsigned_at<std::uint64_t>(at, header.order);
      constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();
      return static_cast<std::int64_t>(is_signed ? value : std::min(value, kMost));
    }
  }
}

}  // namespace

std::string shape_text(const std::vector<std::uint64_t>& extents) {
  std::string text = "(";
  for (std::size_t i = 0; i < extents.size() && i < 5; ++i) text += (i == 0 ? "" : ", ") + std::to_string(extents[i]);
  if (extents.size() > 5) text += ", ...";
  return text + (extents.size() == 1 ? ",)" : ")");
}

ArrayShape shape_of_positions(const std::string& file, const std::string& name,
                              const std::vector<std::uint64_t>& extents) {
  const std::size_t n = extents.size();
  const bool fits = (n == 2 || n == 3) && (extents[n - 1] == 2 || extents[n - 1] == 3);
  if (!fits || extents[n - 2] == 0 || extents[0] == 0 || extents[n - 2] > std::numeric_limits<MeshIndex>::max()) {
    io::fail(file, name + "an array of shape " + shape_text(extents) +
                       "; positions have the shape (vertices, 3) or (frames, vertices, 3), or 2 in place of 3");
  }
  return {n == 3 ? extents[0] : 1, extents[n - 2], extents[n - 1]};
}

ArrayShape npy_shape(const std::string& file, const ReadOptions& options) {
  return open_positions(file, options).shape;
}

ArrayFrame read_npy_frame(const std::string& name, std::size_t index, const ReadOptions& options) {
  OpenArray array = open_positions(name, options);
  const ArrayShape& shape = array.shape;
  const Header& header = array.header;
  ArrayFrame frame{shape, {}};
  if (index >= shape.frames) {
    io::fail(name, "has no frame " + std::to_string(index) + "; the last is " + std::to_string(shape.frames - 1));
  }
  const std::uint64_t values = shape.vertices * shape.dimension;
  std::vector<double>& positions = frame.positions;
  positions.resize(values);
  if (!header.fortran) {
    array.file.skip(index * values * header.size);
    for_each_value(array.file, header, values, [&](std::uint64_t i, double x) { positions[i] = x; });
  } else {
    // The frame's number runs fastest, then the vertex', then the coordinate's: a frame is spread over the whole file.
    std::uint64_t next = index;
    std::uint64_t to = 0;
    const auto keep = [&](std::uint64_t i, double x) {
      if (i != next) return;
      next += shape.frames;
      positions[to % shape.vertices * shape.dimension + to / shape.vertices] = x;
      ++to;
    };
    for_each_value(array.file, header, shape.frames * values, keep);
  }
  return frame;
}

IndexRows read_npy_indices(std::string_view file, std::string_view content) {
  io::InputFile memory = io::InputFile::from_memory(std::string(file), content);
  const Header header = read_header(memory, content.size());
  const std::vector<std::uint64_t>& extents = header.extents;
  if (header.kind == 'f' || extents.size() != 2 || (extents[1] != 2 && extents[1] != 3)) {
    io::fail(file, std::string("an array of ") + (header.kind == 'f' ? "floating-point numbers" : "integers") +
                       " of shape " + shape_text(extents) +
                       "; a topology has integers of shape (faces, 3) or (edges, 2)");
  }
  IndexRows rows{extents[1], std::vector<std::int64_t>(header.values)};
  const char* at = content.data() + header.header_size;
  for (std::uint64_t i = 0; i < header.values; ++i, at += header.size) {
    const std::uint64_t to = header.fortran ? i % extents[0] * extents[1] + i / extents[0] : i;
    rows.values[to] = index_at(at, header);
  }
  return rows;
}

}  // namespace touchstone::frames
