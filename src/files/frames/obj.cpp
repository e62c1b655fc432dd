// Wavefront OBJ: the polygonal subset, with lines, points, objects and groups.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "frames/formats.hpp"
#include "frames/text_scanner.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

constexpr std::array<std::string_view, 7> kIgnoredNumbers = {"vt", "vn", "vp", "bevel", "c_interp", "d_interp", "lod"};
constexpr std::array<std::string_view, 9> kIgnoredNames = {"s",      "mg",         "usemtl",    "mtllib", "usemap",
                                                           "maplib", "shadow_obj", "trace_obj", "res"};
constexpr std::array<std::string_view, 15> kFreeForm = {"cstype", "deg",  "bmat", "step", "curv",
                                                        "curv2",  "surf", "parm", "trim", "hole",
                                                        "scrv",   "sp",   "end",  "con",  "call"};

template <std::size_t n>
bool contains(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
 public:
  ObjReader(std::string_view file, std::string_view content, bool triangulate)
      : file_(file), scanner_(file, content, true), builder_(triangulate, kFirst) {}

  MeshFile read() {
    scanner_.skip_byte_order_mark();
    while (!scanner_.at_file_end()) read_line(scanner_.word());
    if (greatest_ > static_cast<std::int64_t>(builder_.vertex_count())) {
      FilePosition{file_, line_of_greatest_}.fail(fault_of_index(greatest_, builder_.vertex_count(), kFirst));
    }
    if (builder_.vertex_count() == 0) io::fail(file_, "has no vertex; OBJ files have lines such as 'v 0.5 1 -2'");
    return builder_.finish({file_});
  }

 private:
  static constexpr MeshIndex kFirst = 1;

  void read_line(std::string_view keyword) {
    if (keyword.empty()) return;  // a backslash joined two empty lines
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f") {
      read_indices();
      builder_.add_polygon(indices_, ++polygons_, position());
    } else if (keyword.front() == '#') {
      scanner_.skip_line();
    } else if (keyword == "l") {
      read_indices();
      builder_.add_polyline(indices_, position());
    } else if (keyword == "p") {
      read_indices();
      if (indices_.empty()) scanner_.fail("a point has a vertex");
      for (const MeshIndex vertex : indices_) builder_.add_point(vertex);
    } else if (keyword == "o") {
      object_ = name();
      group_.clear();
      set_part();
    } else if (keyword == "g") {
      group_ = name();
      set_part();
    } else if (contains(kIgnoredNumbers, keyword)) {
      skip_numbers(keyword);
    } else if (contains(kIgnoredNames, keyword)) {
      name();
    } else if (contains(kFreeForm, keyword)) {
      scanner_.fail(io::in_quotes(keyword) + " is about free-form curves and surfaces, or other files; vertices 'v', " +
                    "faces 'f', lines 'l' and points 'p' are read");
    } else {
      scanner_.fail(io::in_quotes(keyword) + " is no keyword of OBJ files, such as v, f, l, p, o, g, vt or vn");
    }
  }

  /// Skips numbers, or words such as "on" and "nan". A letter alone is the keyword of a line that was joined to this.
  void skip_numbers(std::string_view keyword) {
    while (!scanner_.at_line_end()) {
      const std::string_view word = scanner_.word();
      if (word.size() != 1 || is_digit(word.front())) continue;
      scanner_.fail(io::in_quotes(word) + " after " + io::in_quotes(keyword) + ", where a number should be");
    }
  }

  void read_vertex() {
    const double x = scanner_.number("x of a vertex");
    const double y = scanner_.number("y of a vertex");
    const double z = scanner_.number("z of a vertex");
    if (!scanner_.at_line_end()) skip_weight_and_colour();
    builder_.add_vertex(x, y, z);
  }

  void skip_weight_and_colour() {
    int count = 3;
    for (; !scanner_.at_line_end(); ++count) scanner_.number("a weight or colour of a vertex");
    if (count == 5 || count > 7) {
      scanner_.fail("a vertex has " + std::to_string(count) +
                    " numbers; right are x y z, then a weight or not, then a colour of three numbers or not");
    }
  }

  /// The vertices of the line, counted from 0.
  void read_indices() {
    indices_.clear();
    while (!scanner_.at_line_end()) {
      const std::int64_t number = scanner_.leading_integer("a vertex");
      if (!scanner_.at_word_end()) skip_texture_and_normal();
      indices_.push_back(index_of(number));
    }
  }

  /// The rest of "v/vt", "v//vn" or "v/vt/vn".
  void skip_texture_and_normal() {
    if (!scanner_.skip('/')) scanner_.fail_integer("a vertex");
    if (!scanner_.skip('/')) {
      scanner_.leading_integer("the texture of a corner");
      if (scanner_.at_word_end()) return;
      if (!scanner_.skip('/')) scanner_.fail_integer("the texture of a corner");
    }
    scanner_.leading_integer("the normal of a corner");
    if (!scanner_.at_word_end()) scanner_.fail_integer("the normal of a corner");
  }

  MeshIndex index_of(std::int64_t number) {
    const auto count = static_cast<std::int64_t>(builder_.vertex_count());
    if (number > greatest_) {  // it may name a vertex that comes later
      constexpr std::int64_t kMost = 0xFFFFFFFF;
      if (number > kMost) scanner_.fail("vertex " + std::to_string(number) + " does not exist: 4294967295 is the last");
      greatest_ = number;
      line_of_greatest_ = scanner_.line();
    }
    if (number > 0) return static_cast<MeshIndex>(number - 1);
    if (number == 0) scanner_.fail("vertex 0 does not exist: OBJ files count from 1");
    if (-number > count) {
      scanner_.fail("vertex " + std::to_string(number) + " counts backwards from here, where there are " +
                    std::to_string(count) + " vertices");
    }
    return static_cast<MeshIndex>(count + number);
  }

  std::string name() {
    const FilePosition here = position();
    const std::string_view found = scanner_.rest_of_line();
    if (found.ends_with('\\')) here.fail("a name ends with a backslash, which could join the next line to this one");
    return std::string(found);
  }

  void set_part() { builder_.set_part(object_.empty() || group_.empty() ? object_ + group_ : object_ + "/" + group_); }

  FilePosition position() const { return {file_, scanner_.line()}; }

  std::string_view file_;
  TextScanner scanner_;
  MeshBuilder builder_;
  std::vector<MeshIndex> indices_;
  std::uint64_t polygons_ = 0;
  std::int64_t greatest_ = 0;
  std::uint64_t line_of_greatest_ = 0;
  std::string object_, group_;
};

}  // namespace

MeshFile read_obj(std::string_view file, std::string_view content, bool triangulate) {
  return ObjReader(file, content, triangulate).read();
}

}  // namespace touchstone::frames
