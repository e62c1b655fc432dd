// PLY 1.0: text, and binary of both byte orders.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "frames/formats.hpp"
#include "frames/text_scanner.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::array<std::string_view, 8> kNames = {"char", "uchar", "short", "ushort",
                                                    "int",  "uint",  "float", "double"};
constexpr std::array<std::string_view, 8> kNewNames = {"int8",  "uint8",  "int16",   "uint16",
                                                       "int32", "uint32", "float32", "float64"};
constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};

std::size_t size_of(Type type) { return kSizes[static_cast<std::size_t>(type)]; }
bool is_integer(Type type) { return type < Type::float32; }

double value_at(const char* at, Type type, std::endian order) {
  switch (type) {
    case Type::int8: return static_cast<std::int8_t>(*at);
    case Type::uint8: return static_cast<std::uint8_t>(*at);
    case Type::int16: return static_cast<std::int16_t>(io::unsigned_at<std::uint16_t>(at, order));
    case Type::uint16: return io::unsigned_at<std::uint16_t>(at, order);
    case Type::int32: return static_cast<std::int32_t>(io::unsigned_at<std::uint32_t>(at, order));
    case Type::uint32: return io::unsigned_at<std::uint32_t>(at, order);
    case Type::float32: return io::float_at(at, order);
    case Type::float64: return io::double_at(at, order);
  }
  return 0;
}

/// What a value of an element means.
enum class Meaning : std::uint8_t { ignored, x, y, z, corners, vertex1, vertex2 };

struct Property {
  std::string name;
  std::string shown;  ///< the name for messages
  Type type = Type::float64;
  std::optional<Type> count_type;  ///< of a list
  Meaning meaning = Meaning::ignored;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

/// The values of a binary file, with the interface that the rows of a text file have.
class BinaryValues {
 public:
  BinaryValues(std::string_view file, TextScanner& scanner, std::endian order)
      : file_(file), scanner_(scanner), order_(order) {}

  double number(const Property& property) { return next(property.type); }
  std::int64_t integer(const Property&, Type type) { return static_cast<std::int64_t>(next(type)); }
  void skip(const Property& property, std::uint64_t count) {
    if (scanner_.remaining() / size_of(property.type) < count) fail_at_end();
    at(count * size_of(property.type));
  }
  void end_row() {}
  std::uint64_t line() const { return 0; }
  void check_end() {
    if (scanner_.remaining() != 0) {
      io::fail(file_, std::to_string(scanner_.remaining()) + " bytes follow the last element of the header");
    }
  }
  [[noreturn]] void fail(const std::string& reason) const { io::fail(file_, reason); }

 private:
  double next(Type type) { return value_at(at(size_of(type)), type, order_); }

  const char* at(std::size_t size) {
    if (scanner_.remaining() < size) fail_at_end();
    return scanner_.raw_bytes(size).data();
  }
  [[noreturn]] void fail_at_end() const { io::fail(file_, "ends before the last element that its header announces"); }

  std::string_view file_;
  TextScanner& scanner_;
  std::endian order_;
};

class TextValues {
 public:
  explicit TextValues(TextScanner& scanner) : scanner_(scanner) {}

  double number(const Property& property) {
    start_row();
    return scanner_.number(property.shown);
  }
  std::int64_t integer(const Property& property, Type) {
    start_row();
    return scanner_.integer(property.shown);
  }
  void skip(const Property& property, std::uint64_t count) {
    start_row();
    for (; count > 0; --count) {
      if (scanner_.word().empty()) scanner_.fail("the line ends before " + property.shown);
    }
  }
  void end_row() {
    scanner_.end_line("an element");
    in_row_ = false;
  }
  std::uint64_t line() const { return scanner_.line(); }
  void check_end() {
    if (!scanner_.at_file_end())
      scanner_.fail(io::in_quotes(scanner_.word()) + " follows the last element of the header");
  }
  [[noreturn]] void fail(const std::string& reason) const { scanner_.fail(reason); }

 private:
  /// Skips empty lines.
  void start_row() {
    if (in_row_) return;
    if (scanner_.at_file_end()) scanner_.fail("the file ends before the last element that its header announces");
    in_row_ = true;
  }

  TextScanner& scanner_;
  bool in_row_ = false;
};

class PlyReader {
 public:
  PlyReader(std::string_view file, std::string_view content, bool triangulate)
      : file_(file), scanner_(file, content), builder_(triangulate, 0) {}

  MeshFile read() {
    read_header();
    if (order_) {
      BinaryValues values(file_, scanner_, *order_);
      read_elements(values);
    } else {
      TextValues values(scanner_);
      read_elements(values);
    }
    return builder_.finish({file_});
  }

 private:
  void read_header() {
    if (scanner_.word() != "ply") scanner_.fail("is no PLY file: its first line is not 'ply'");
    scanner_.end_line("'ply'");
    bool has_format = false;
    for (;;) {
      if (scanner_.at_file_end()) scanner_.fail("the file ends before 'end_header'");
      const std::string_view keyword = scanner_.word();
      if (keyword == "end_header") break;
      if (keyword == "comment" || keyword == "obj_info") {
        scanner_.skip_line();
      } else if (keyword == "format" && !has_format) {
        read_format();
        has_format = true;
      } else if (keyword == "element") {
        read_element();
      } else if (keyword == "property" && !elements_.empty()) {
        read_property();
      } else {
        scanner_.fail(io::in_quotes(keyword) +
                      " has no place here; a header has one 'format', then 'element' lines with 'property' lines");
      }
    }
    if (!has_format) scanner_.fail("the header has no 'format'");
    scanner_.end_line("'end_header'");
    find_meanings();
  }

  void read_format() {
    const std::string_view format = scanner_.word(), version = scanner_.word();
    if (format == "binary_little_endian") order_ = std::endian::little;
    if (format == "binary_big_endian") order_ = std::endian::big;
    if ((!order_ && format != "ascii") || version != "1.0") {
      scanner_.fail("format " + io::in_quotes(std::string(format) + ' ' + std::string(version)) +
                    "; known are ascii 1.0, binary_little_endian 1.0 and binary_big_endian 1.0");
    }
    scanner_.end_line("the format");
  }

  void read_element() {
    const std::string_view name = scanner_.word();
    const std::int64_t count = scanner_.integer("a number of elements");
    if (count < 0) scanner_.fail("a number of elements is negative");
    for (const Element& other : elements_) {
      if (other.name == name) scanner_.fail("element " + io::in_quotes(name) + " is there twice");
    }
    elements_.push_back({std::string(name), static_cast<std::uint64_t>(count), {}});
    scanner_.end_line("an element's number");
  }

  void read_property() {
    Property property;
    std::string_view type = scanner_.word();
    if (type == "list") {
      property.count_type = type_called(scanner_.word());
      if (!is_integer(*property.count_type)) scanner_.fail("the number of a list's items is of a type of integers");
      type = scanner_.word();
    }
    property.type = type_called(type);
    property.name = std::string(scanner_.word());
    property.shown = io::shortened(property.name);
    if (property.name.empty()) scanner_.fail("a property has a type and a name");
    std::vector<Property>& properties = elements_.back().properties;
    for (const Property& other : properties) {
      if (other.name == property.name) scanner_.fail("property " + io::in_quotes(other.name) + " is there twice");
    }
    properties.push_back(std::move(property));
    scanner_.end_line("a property's name");
  }

  Type type_called(std::string_view name) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (name == kNames[i] || name == kNewNames[i]) return static_cast<Type>(i);
    }
    scanner_.fail(io::in_quotes(name) + " is no type of PLY files, such as float, double, uchar or int");
  }

  void find_meanings() {
    for (Element& element : elements_) {
      if (element.name == "vertex") {
        vertex_count_ = element.count;
        require(element, "x", Meaning::x, false);
        require(element, "y", Meaning::y, false);
        require(element, "z", Meaning::z, false);
      } else if (element.name == "face" && element.count > 0) {
        const auto named = [](const Property& p) { return p.name == "vertex_indices"; };
        const bool plural = std::any_of(element.properties.begin(), element.properties.end(), named);
        require(element, plural ? "vertex_indices" : "vertex_index", Meaning::corners, true);
      } else if (element.name == "edge" && element.count > 0) {
        require(element, "vertex1", Meaning::vertex1, true);
        require(element, "vertex2", Meaning::vertex2, true);
      } else if (element.name == "tristrips" && element.count > 0) {
        io::fail(file_, "holds strips of triangles, which are not read; write faces");
      } else if (element.count > 0) {
        refuse_numbers_of_vertices(element);
      }
      check_count(element);
    }
  }

  /// Elements of other names may hold anything. Those that may name vertices, such as "faces", are not left out in
  /// silence: by a list of integers, or by two of them. A camera has the integers of its picture, and a material those
  /// of its colours.
  void refuse_numbers_of_vertices(const Element& element) {
    constexpr std::array<std::string_view, 4> kOfVertices = {"vertex_indices", "vertex_index", "vertex1", "vertex2"};
    const bool is_known = element.name == "camera" || element.name == "material";
    std::size_t integers = 0;
    for (const Property& property : element.properties) {
      const bool may_be = !is_known && is_integer(property.type) && (property.count_type || ++integers > 1);
      if (!may_be && std::find(kOfVertices.begin(), kOfVertices.end(), property.name) == kOfVertices.end()) continue;
      io::fail(file_, "element " + io::in_quotes(element.name) + " has the property " + io::in_quotes(property.name) +
                          ", which may be a number of a vertex; the elements that have vertices are called face and "
                          "edge, and without this one the file is read");
    }
  }

  void require(Element& element, std::string_view name, Meaning meaning, bool integers) {
    for (Property& property : element.properties) {
      if (property.name != name) continue;
      if (property.count_type.has_value() != (meaning == Meaning::corners)) {
        io::fail(file_, "property " + io::in_quotes(name) + " of element " + io::in_quotes(element.name) +
                            (property.count_type ? " is a list, and should be one number"
                                                 : " is one number, and should be a list"));
      }
      if (integers && !is_integer(property.type)) {
        io::fail(file_,
                 "property " + io::in_quotes(name) + " holds numbers of vertices, and should have a type of integers");
      }
      property.meaning = meaning;
      return;
    }
    io::fail(file_, "element " + io::in_quotes(element.name) + " has no property " + io::in_quotes(name));
  }

  /// A file of few bytes does not announce many elements.
  void check_count(const Element& element) {
    std::uint64_t size = 0;  // the least of an element; in a text file a digit for each value
    for (const Property& property : element.properties) {
      size += order_ ? size_of(property.count_type.value_or(property.type)) : 1;
    }
    if (element.count > 0 && element.properties.empty()) {
      io::fail(file_, "element " + io::in_quotes(element.name) + " has no property");
    }
    if (element.count > 0 && element.count > scanner_.remaining() / size) {
      io::fail(file_, "announces " + std::to_string(element.count) + " elements " + io::in_quotes(element.name) +
                          ", and is too short for them");
    }
  }

  template <class Values>
  void read_elements(Values& values) {
    for (const Element& element : elements_) {
      if (element.name == "vertex") builder_.positions().reserve(3 * element.count);
      if (element.name == "face") builder_.reserve_faces(element.count);
      for (std::uint64_t i = 0; i < element.count; ++i) read_row(element, i, values);
    }
    values.check_end();
  }

  template <class Values>
  void read_row(const Element& element, std::uint64_t number, Values& values) {
    std::array<double, 3> position{};
    std::array<MeshIndex, 2> ends{};
    corners_.clear();
    for (const Property& property : element.properties) {
      switch (property.meaning) {
        case Meaning::ignored: values.skip(property, property.count_type ? list_size(property, values) : 1); break;
        case Meaning::x:
        case Meaning::y:
        case Meaning::z:
          position[static_cast<std::size_t>(property.meaning) - 1] = coordinate(property, number, values);
          break;
        case Meaning::corners:
          for (std::uint64_t count = list_size(property, values); count > 0; --count) {
            corners_.push_back(vertex(property, values));
          }
          break;
        case Meaning::vertex1:
        case Meaning::vertex2: ends[property.meaning == Meaning::vertex2] = vertex(property, values); break;
      }
    }
    const FilePosition here{file_, values.line()};
    values.end_row();
    if (element.name == "vertex") builder_.add_vertex(position[0], position[1], position[2]);
    if (element.name == "face") builder_.add_polygon(corners_, number, here);
    if (element.name == "edge") builder_.add_edge(ends[0], ends[1]);
  }

  template <class Values>
  std::uint64_t list_size(const Property& property, Values& values) {
    const std::int64_t size = values.integer(property, *property.count_type);
    if (size < 0) values.fail("a list has " + std::to_string(size) + " items");
    return static_cast<std::uint64_t>(size);
  }

  template <class Values>
  MeshIndex vertex(const Property& property, Values& values) {
    return checked_vertex(values.integer(property, property.type), vertex_count_, {file_, values.line()});
  }

  template <class Values>
  double coordinate(const Property& property, std::uint64_t number, Values& values) {
    const double x = values.number(property);
    if (!std::isfinite(x)) values.fail(property.shown + " of vertex " + std::to_string(number) + " is not finite");
    return x;
  }

  std::string_view file_;
  TextScanner scanner_;
  MeshBuilder builder_;
  std::optional<std::endian> order_;  ///< of a binary file
  std::vector<Element> elements_;
  std::uint64_t vertex_count_ = 0;
  std::vector<MeshIndex> corners_;
};

}  // namespace

MeshFile read_ply(std::string_view file, std::string_view content, bool triangulate) {
  return PlyReader(file, content, triangulate).read();
}

}  // namespace touchstone::frames
