// Mesh files of OBJ and binary PLY for touchstone-check: is a motion that of a person's frames?
// SPDX-License-Identifier: MIT
#pragma once

#include <glob.h>

#include <iterator>
#include <sstream>

#include "checker/curved_motion.hpp"

namespace checker {

/// A mesh file: three coordinates for each vertex, and the vertices of each triangle, line and point. A polygon of more
/// than three corners stands for the triangles that its first corner makes with the sides that it is no end of.
struct MeshFile {
  std::vector<Number> positions;
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::size_t> numbers;  ///< of each triangle, that of its polygon among those of the file, from 0
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> points;
};

/// The files that a pattern names. Digits in their names count as numbers: a-2 comes before a-10.
inline std::vector<std::string> files_of(const std::string& pattern) {
  for (const char* const with_class : {"[[:", "[[=", "[[."}) {
    if (pattern.find(with_class) != pattern.npos) throw BadInput(pattern + ": --frames takes sets such as [0-9] alone");
  }
  glob_t found{};
  const bool any = glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0;
  std::vector<std::string> files;
  if (any) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  if (files.empty()) throw BadInput(pattern + ": no file has such a name");
  const auto is_before = [](std::string_view a, std::string_view b) {
    const auto take = [](std::string_view& text) {  // a number without its leading zeros, or a character
      std::size_t size = 0;
      while (size < text.size() && is_digit(text[size])) ++size;
      std::string_view word = text.substr(0, std::max<std::size_t>(size, 1));
      text.remove_prefix(word.size());
      if (size > 0) word.remove_prefix(std::min(word.find_first_not_of('0'), size - 1));
      return word;
    };
    while (!a.empty() && !b.empty()) {
      const std::string_view one = take(a), other = take(b);
      const bool numbers = is_digit(one[0]) && is_digit(other[0]);
      if (numbers && one.size() != other.size()) return one.size() < other.size();
      if (one != other) return one < other;
    }
    return a.size() < b.size();
  };
  std::sort(files.begin(), files.end());
  std::stable_sort(files.begin(), files.end(), is_before);
  return files;
}

/// Lines "v X Y Z", "f V V V...", "l V V..." and "p V...". A vertex may have textures and normals behind slashes; a
/// negative number counts back. What another reader may take for such a line is refused: other keywords, backslashes,
/// controls.
inline MeshFile read_obj(const std::string& name) {
  static const std::vector<std::string_view> kIgnored = {"vt", "vn", "o", "g", "s", "usemtl", "mtllib"};
  Lines lines(name);
  Words words;
  MeshFile mesh;
  std::size_t polygons = 0;
  const auto vertex_of = [&](std::string_view word) {
    mpz_class number;
    const bool good = read_integer(word.substr(0, word.find('/')), number);
    const mpz_class count = mesh.positions.size() / 3;
    if (good && sgn(number) < 0) number += count + 1;
    if (!good || number < 1 || number > count) throw lines.bad(quoted(word) + " is no vertex above this line");
    return static_cast<std::uint32_t>(number.get_ui() - 1);
  };
  while (lines.next(words, " \t")) {
    for (const std::string_view word : words) {
      const auto is_hidden = [](char c) { return c == '\\' || (c >= 0 && c < ' ') || c == '\x7F'; };
      lines.require(std::none_of(word.begin(), word.end(), is_hidden),
                    "--frames reads no backslash and no control character");
    }
    const std::string_view sort = words[0];
    if (sort == "v") {
      lines.require(words.size() >= 4, "a vertex has three coordinates");
      for (std::size_t k = 1; k < 4; ++k) mesh.positions.push_back(read_double(words[k], lines));
    } else if (sort == "f") {
      lines.require(words.size() >= 4, "a face has three vertices, or more");
      for (std::size_t k = 3; k < words.size(); ++k)
        mesh.faces.push_back({vertex_of(words[1]), vertex_of(words[k - 1]), vertex_of(words[k])});
      mesh.numbers.resize(mesh.faces.size(), polygons++);
    } else if (sort == "l") {
      lines.require(words.size() >= 3, "a line has two vertices, or more");
      for (std::size_t k = 2; k < words.size(); ++k)
        mesh.edges.push_back({vertex_of(words[k - 1]), vertex_of(words[k])});
    } else if (sort == "p") {
      for (std::size_t k = 1; k < words.size(); ++k) mesh.points.push_back(vertex_of(words[k]));
    } else if (std::find(kIgnored.begin(), kIgnored.end(), sort) == kIgnored.end()) {
      throw lines.bad("--frames reads no lines " + quoted(sort));
    }
  }
  return mesh;
}

/// A binary PLY file, of either order of bytes, with the elements vertex, face and edge.
class PlyFile {
 public:
  explicit PlyFile(const std::string& name) : name_(name), file_(name, std::ios::binary) {
    if (!file_) throw BadInput(name_ + ": cannot be opened for reading: " + std::strerror(errno));
  }

  MeshFile read() {
    read_header();
    MeshFile mesh;
    for (const auto& [element, count, properties] : elements_) {
      for (std::uint32_t i = 0; i < count; ++i) {
        read_item(element, properties, mesh);
        mesh.numbers.resize(mesh.faces.size(), i);
      }
      require(element != "vertex" || mesh.positions.size() == 3 * std::size_t{count}, "vertices need x, y and z");
    }
    require(file_.peek() == std::ifstream::traits_type::eof(), "there are bytes after the last element");
    const auto check_all = [&](const auto& elements) {
      for (const auto& element : elements) {
        for (const std::uint32_t v : element) {
          require(v < mesh.positions.size() / 3, "an element names a vertex that is not there");
        }
      }
    };
    check_all(mesh.faces);
    check_all(mesh.edges);
    return mesh;
  }

 private:
  /// The bytes of a number, and whether it has a point.
  struct Type {
    std::size_t size = 0;
    bool is_float = false, is_signed = false;
  };
  struct Property {
    std::string name;
    Type type, count;  ///< count.size is 0 where it is no list
  };
  struct Element {
    std::string name;
    std::uint32_t count = 0;
    std::vector<Property> properties;
  };

  void require(bool good, const std::string& reason) const {
    if (!good) throw BadInput(name_ + ": " + reason);
  }

  Type type_of(const std::string& word) const {
    static const std::vector<std::pair<std::string, Type>> types = {{"char", {1, false, true}},
                                                                    {"int8", {1, false, true}},
                                                                    {"uchar", {1}},
                                                                    {"uint8", {1}},
                                                                    {"short", {2, false, true}},
                                                                    {"int16", {2, false, true}},
                                                                    {"ushort", {2}},
                                                                    {"uint16", {2}},
                                                                    {"int", {4, false, true}},
                                                                    {"int32", {4, false, true}},
                                                                    {"uint", {4}},
                                                                    {"uint32", {4}},
                                                                    {"float", {4, true, true}},
                                                                    {"float32", {4, true, true}},
                                                                    {"double", {8, true, true}},
                                                                    {"float64", {8, true, true}}};
    for (const auto& [name, type] : types) {
      if (name == word) return type;
    }
    throw BadInput(name_ + ": " + quoted(word) + " is no type of a property");
  }

  void read_header() {
    std::array<char, 1001> buffer{};
    for (std::size_t number = 0; file_.getline(buffer.data(), buffer.size()); ++number) {
      std::string line(buffer.data(), static_cast<std::size_t>(file_.gcount()) - (file_.eof() ? 0 : 1));
      require(number < 1000, "the header has too many lines");
      if (!line.empty() && line.back() == '\r') line.pop_back();
      std::istringstream text(line);
      const std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
      if (number == 0) require(line == "ply", "the first line must be \"ply\"");
      if (number == 0 || words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") {
        const auto is_empty = [](const Element& e) { return e.properties.empty() && e.count > 0; };
        require(std::none_of(elements_.begin(), elements_.end(), is_empty), "an element has no property");
        check_elements();
        return require(has_format_, "the header has no format");
      }
      if (words[0] == "format") {
        require(words.size() == 3 && (words[1] == "binary_little_endian" || words[1] == "binary_big_endian"),
                "--frames reads binary PLY alone, and OBJ");
        has_format_ = true;
        is_big_ = words[1] == "binary_big_endian";
      } else if (words[0] == "element") {
        Element element;
        require(words.size() == 3 && read_count(words[2], kMostVertices, element.count), "an element has a number");
        element.name = words[1];
        elements_.push_back(element);
      } else {
        const bool is_list = words.size() == 5 && words[1] == "list";
        require(words[0] == "property" && (is_list || words.size() == 3) && !elements_.empty(),
                quoted(line) + " is no line of a header");
        Property property{words.back(), type_of(words[words.size() - 2]), {}};
        if (is_list) property.count = type_of(words[2]);
        require(!property.count.is_float, "the size of a list is a whole number");
        elements_.back().properties.push_back(property);
      }
    }
    require(false, "the header has no end within 1,000 lines of 1,000 bytes");
  }

  /// Another reader must see no other elements: each property has its place, once, and is read.
  void check_elements() const {
    const auto count = [](const Element& element, const auto& fits) {
      return std::count_if(element.properties.begin(), element.properties.end(), fits);
    };
    for (const Element& element : elements_) {
      const bool is_face = element.name == "face";
      require(is_face || element.name == "vertex" || element.name == "edge",
              "--frames reads no element " + quoted(element.name));
      require(std::count_if(elements_.begin(), elements_.end(),
                            [&](const Element& other) { return other.name == element.name; }) == 1,
              "the element " + quoted(element.name) + " is there twice");
      require(count(element, [](const Property& p) { return p.count.size > 0; }) == (is_face ? 1 : 0),
              "faces have one list, of their vertices, and nothing else has one");
      require(!is_face || count(element, is_list_of_vertices) == 1, "faces have a list vertex_index or vertex_indices");
      for (const Property& one : element.properties) {
        require(count(element, [&](const Property& other) { return other.name == one.name; }) == 1,
                "the property " + quoted(one.name) + " is there twice");
      }
      for (const char* const end : {"vertex1", "vertex2"}) {
        const auto is_end = [&](const Property& p) { return p.name == end && !p.type.is_float; };
        require(element.name != "edge" || count(element, is_end) == 1, "edges have vertex1 and vertex2");
      }
    }
  }
  static bool is_list_of_vertices(const Property& p) {
    return p.count.size > 0 && !p.type.is_float && (p.name == "vertex_index" || p.name == "vertex_indices");
  }

  /// The bytes of a number, the most significant one first, in an integer.
  std::uint64_t read_bits(const Type& type) {
    std::array<char, 8> bytes{};
    file_.read(bytes.data(), static_cast<std::streamsize>(type.size));
    require(file_.gcount() == static_cast<std::streamsize>(type.size), "the file is cut off");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.size; ++i) {
      bits = bits << 8 | static_cast<unsigned char>(bytes[is_big_ ? i : type.size - 1 - i]);
    }
    return bits;
  }

  /// m 2^e of a float or double: a sign, an exponent, and digits behind a one, or behind a zero for the least exponent.
  Number number_of(std::uint64_t bits, const Type& type) const {
    const int digits = type.size == 4 ? 23 : 52, size = static_cast<int>(8 * type.size);
    const std::uint64_t exponents = (std::uint64_t{1} << (size - 1 - digits)) - 1;
    const std::uint64_t exponent = bits >> digits & exponents;
    std::uint64_t m = bits & ((std::uint64_t{1} << digits) - 1);
    require(exponent != exponents, "a coordinate is not finite");
    if (exponent > 0) m |= std::uint64_t{1} << digits;
    Number x;
    x.m = static_cast<unsigned long>(m);
    if ((bits >> (size - 1)) != 0) x.m = -x.m;
    const long least = type.size == 4 ? -149 : -1074;
    x.e = m == 0 ? 0 : least + static_cast<long>(exponent > 0 ? exponent - 1 : 0);
    return x;
  }

  /// A number of a vertex; one that is none becomes too great.
  static std::uint32_t index_of(std::uint64_t bits, const Type& type) {
    const bool is_negative = type.is_signed && (bits >> (8 * type.size - 1)) != 0;
    return is_negative ? kMostVertices : static_cast<std::uint32_t>(std::min<std::uint64_t>(bits, kMostVertices));
  }

  void read_item(const std::string& element, const std::vector<Property>& properties, MeshFile& mesh) {
    std::array<Number, 3> at;
    std::array<std::uint32_t, 2> ends{};
    unsigned found = 0;
    for (const Property& property : properties) {
      if (property.count.size > 0) {
        const std::uint32_t size = index_of(read_bits(property.count), property.count);
        require(size >= 3 && size < kMostVertices, "a face has three vertices, or more");
        std::array<std::uint32_t, 3> face{};  // the first corner, and the last two that were read
        for (std::uint32_t k = 0; k < size; ++k) {
          face[1] = face[2];
          face[k == 0 ? 0 : 2] = index_of(read_bits(property.type), property.type);
          if (k >= 2) mesh.faces.push_back(face);
        }
        continue;
      }
      const std::uint64_t bits = read_bits(property.type);
      const std::string& name = property.name;
      if (element == "edge" && (name == "vertex1" || name == "vertex2")) {
        ends[name == "vertex1" ? 0 : 1] = index_of(bits, property.type);
      } else if (element == "vertex" && (name == "x" || name == "y" || name == "z")) {
        require(property.type.is_float, "coordinates are floats or doubles");
        at[static_cast<std::size_t>(name[0] - 'x')] = number_of(bits, property.type);
        found |= 1U << (name[0] - 'x');
      }
    }
    if (element == "edge") mesh.edges.push_back(ends);
    if (element != "vertex") return;
    require(found == 7, "vertices need x, y and z");
    mesh.positions.insert(mesh.positions.end(), at.begin(), at.end());
  }

  std::string name_;
  std::ifstream file_;
  std::vector<Element> elements_;
  bool has_format_ = false, is_big_ = false;
};

inline MeshFile read_mesh(const std::string& name) {
  const auto ends_with = [&](std::string_view end) {
    return name.size() >= end.size() && std::string_view(name).substr(name.size() - end.size()) == end;
  };
  if (ends_with(".obj")) return read_obj(name);
  if (ends_with(".ply")) return PlyFile(name).read();
  throw BadInput(name + ": --frames reads .obj and binary .ply");
}

}  // namespace checker
