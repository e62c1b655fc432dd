// OFF, of text: vertices, polygons and edges, with colours and normals that are skipped.
// SPDX-License-Identifier: MIT
#include <vector>

#include "frames/formats.hpp"
#include "frames/text_scanner.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

class OffReader {
 public:
  OffReader(std::string_view file, std::string_view content, bool triangulate)
      : file_(file), scanner_(file, content), builder_(triangulate, 0) {}

  MeshFile read() {
    scanner_.skip_byte_order_mark();
    read_keyword();
    begin_line("the number of vertices");
    const std::uint64_t vertices = read_count("the number of vertices", 6);  // three digits, two blanks, and an end
    const std::uint64_t faces = read_count("the number of faces", 2);
    skip_numbers("the number of edges");
    for (std::uint64_t v = 0; v < vertices; ++v) read_vertex();
    builder_.reserve_faces(faces);
    for (std::uint64_t f = 0; f < faces; ++f) read_face(f);
    if (more_lines())
      scanner_.fail("more lines than " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                    " faces, which the file announces");
    return builder_.finish({file_});
  }

 private:
  void read_keyword() {
    if (!more_lines()) io::fail(file_, "is empty; an OFF file begins with OFF");
    const std::string_view keyword = scanner_.word();
    constexpr std::string_view kRight = "; right are OFF, COFF, NOFF and CNOFF";
    if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF") {
      scanner_.fail("begins with " + io::in_quotes(keyword) + std::string(kRight));
    }
  }

  /// Skips comments and empty lines. @returns whether there is another line
  bool more_lines() {
    while (!scanner_.at_file_end()) {
      if (!scanner_.skip('#')) return true;
      scanner_.skip_line();
    }
    return false;
  }

  void begin_line(std::string_view what) {
    if (!more_lines()) scanner_.fail("the file ends before " + std::string(what));
  }

  /// A file of few bytes does not announce much.
  std::uint64_t read_count(std::string_view what, std::uint64_t least_size) {
    const std::int64_t count = scanner_.integer(what);
    if (count < 0) scanner_.fail(std::string(what) + " is negative");
    if (static_cast<std::uint64_t>(count) > scanner_.remaining() / least_size + 1) {
      scanner_.fail("announces " + std::to_string(count) + " items, and is too short for them");
    }
    return static_cast<std::uint64_t>(count);
  }

  /// The rest of the line: numbers, and perhaps a comment.
  void skip_numbers(std::string_view what) {
    while (!scanner_.at_line_end()) {
      if (scanner_.skip('#')) break;
      scanner_.number(what);
    }
    scanner_.skip_line();
  }

  void read_vertex() {
    begin_line("the last vertex");
    const double x = scanner_.number("x of a vertex");
    const double y = scanner_.number("y of a vertex");
    const double z = scanner_.number("z of a vertex");
    skip_numbers("a normal or colour of a vertex");
    builder_.add_vertex(x, y, z);
  }

  void read_face(std::uint64_t number) {
    begin_line("the last face");
    const std::int64_t count = scanner_.integer("the number of a face's corners");
    if (count < 1) scanner_.fail("a face of " + std::to_string(count) + " corners");
    corners_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t index = scanner_.integer("a corner of a face");
      corners_.push_back(checked_vertex(index, builder_.vertex_count(), {file_, scanner_.line()}));
    }
    if (count == 1) {
      builder_.add_point(corners_[0]);
    } else if (count == 2) {
      builder_.add_edge(corners_[0], corners_[1]);
    } else {
      builder_.add_polygon(corners_, number, {file_, scanner_.line()});
    }
    skip_numbers("a colour of a face");
  }

  std::string_view file_;
  TextScanner scanner_;
  MeshBuilder builder_;
  std::vector<MeshIndex> corners_;
};

}  // namespace

MeshFile read_off(std::string_view file, std::string_view content, bool triangulate) {
  return OffReader(file, content, triangulate).read();
}

}  // namespace touchstone::frames
