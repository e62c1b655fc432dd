// SPDX-License-Identifier: MIT
#include "io/queries/npy_header.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "io/bytes.hpp"
#include "io/fail.hpp"

namespace touchstone::io {
namespace {

/// Reads the header's text, the literal of a Python dictionary: {'descr': '<f8', 'fortran_order': False,
/// 'shape': (3, 4), }
class HeaderText {
 public:
  /// @param example  a shape that is right, for messages
  HeaderText(std::string_view file, std::string_view text, std::string_view example)
      : file_(file), text_(text), example_(example) {}

  void read(NpyHeader& header) {
    expect('{');
    std::array<bool, 3> seen{};
    while (!skip('}')) {
      const std::string_view key = quoted();
      expect(':');
      constexpr std::array<std::string_view, 3> kKeys = {"descr", "fortran_order", "shape"};
      const auto which = static_cast<std::size_t>(std::find(kKeys.begin(), kKeys.end(), key) - kKeys.begin());
      if (which == kKeys.size() || seen[which]) fail("has the key " + in_quotes(key));
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
    if (!text_.empty()) fail("goes on after '}' with " + in_quotes(text_));
    if (!seen[0] || !seen[1] || !seen[2]) fail("lacks one of 'descr', 'fortran_order' and 'shape'");
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    io::fail(file_, "the header of the .npy file " + reason +
                        "; right is, for example, {'descr': '<f8', 'fortran_order': False, 'shape': " +
                        std::string(example_) + ", }");
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
    if (!skip(c)) fail("has " + in_quotes(text_) + " where " + in_quotes({&c, 1}) + " should be");
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

  void read_type(NpyHeader& header) {
    blanks();
    if (text_.starts_with('[')) fail("describes records; an array of plain numbers is read");
    const std::string_view type = quoted();
    const bool is_known =
        type.size() == 3 && std::string_view("<>=|").find(type[0]) != std::string_view::npos &&
        ((type[1] == 'f' && (type[2] == '4' || type[2] == '8')) ||
         ((type[1] == 'i' || type[1] == 'u') && std::string_view("1248").find(type[2]) != std::string_view::npos) ||
         (type[1] == 'b' && type[2] == '1'));
    if (!is_known || (type[0] == '|' && type[2] != '1')) {
      fail("has the type " + in_quotes(type) + "; read are float64 and float32, and integers for topology");
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
    fail("has " + in_quotes(text_) + " where True or False should be");
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
    if (digits == 0) fail("has " + in_quotes(text_) + " where an extent should be");
    text_.remove_prefix(digits);
    return value;
  }

  std::string_view file_;
  std::string_view text_;
  std::string_view example_;
};

}  // namespace

std::string shape_text(const std::vector<std::uint64_t>& extents) {
  std::string text = "(";
  for (std::size_t i = 0; i < extents.size() && i < 5; ++i) text += (i == 0 ? "" : ", ") + std::to_string(extents[i]);
  if (extents.size() > 5) text += ", ...";
  return text + (extents.size() == 1 ? ",)" : ")");
}

void read_exactly(InputFile& file, char* to, std::size_t count) {
  while (count > 0) {
    const std::size_t got = file.read(to, count);
    if (got == 0) fail(file.name(), "ends too early: it is cut off, or no .npy file");
    to += got;
    count -= got;
  }
}

std::int64_t integer_at(const char* at, const NpyHeader& header) {
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

double number_at(const char* from, const NpyHeader& header) {
  if (header.kind != 'f') return static_cast<double>(integer_at(from, header));
  return header.size == 4 ? float_at(from, header.order) : double_at(from, header.order);
}

NpyHeader read_npy_header(InputFile& file, std::uint64_t file_size, std::string_view example_shape) {
  std::array<char, 12> start;
  read_exactly(file, start.data(), 8);
  if (std::string_view(start.data(), kNpyMagic.size()) != kNpyMagic) {
    fail(file.name(), "is no .npy file: it does not start with \\x93NUMPY");
  }
  const int version = start[6];
  if (version < 1 || version > 3 || start[7] != 0) {
    fail(file.name(), "is an .npy file of version " + std::to_string(static_cast<unsigned char>(start[6])) + "." +
                          std::to_string(static_cast<unsigned char>(start[7])) + "; known are 1.0, 2.0 and 3.0");
  }
  const std::size_t length_size = version == 1 ? 2 : 4;
  read_exactly(file, start.data() + 8, length_size);
  const std::size_t length = version == 1 ? unsigned_at<std::uint16_t>(start.data() + 8, std::endian::little)
                                          : unsigned_at<std::uint32_t>(start.data() + 8, std::endian::little);
  constexpr std::size_t kLongest = 1 << 20;  // NumPy's own limit is 10,000
  if (length > kLongest) fail(file.name(), "has a header of more than a megabyte");
  std::string text(length, '\0');
  read_exactly(file, text.data(), length);

  NpyHeader header;
  header.header_size = 8 + length_size + length;
  HeaderText(file.name(), text, example_shape).read(header);
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
    fail(file.name(), "an array of shape " + shape_text(header.extents) + " has " + values + " values of " +
                          std::to_string(header.size) + " bytes, and the file has " +
                          std::to_string(file_size - header.header_size) + " bytes for them");
  }
  return header;
}

}  // namespace touchstone::io
