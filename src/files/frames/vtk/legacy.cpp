// Legacy VTK, of text and binary: POLYDATA and UNSTRUCTURED_GRID.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "frames/formats.hpp"
#include "frames/text_scanner.hpp"
#include "frames/vtk/cells.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

struct ScalarType {
  std::string_view name;
  std::size_t size;
};

/// The types of arrays that may come before or between the elements, with their sizes in binary files.
constexpr std::array<ScalarType, 17> kTypes = {{{"char", 1},
                                                {"signed_char", 1},
                                                {"unsigned_char", 1},
                                                {"vtktypeint8", 1},
                                                {"vtktypeuint8", 1},
                                                {"short", 2},
                                                {"unsigned_short", 2},
                                                {"vtktypeint16", 2},
                                                {"vtktypeuint16", 2},
                                                {"int", 4},
                                                {"vtkidtype", 4},
                                                {"unsigned_int", 4},
                                                {"float", 4},
                                                {"vtktypeint32", 4},
                                                {"vtktypeuint32", 4},
                                                {"double", 8},
                                                {"vtktypeint64", 8}}};

/// In the order of PolyList.
constexpr std::array<std::string_view, kPolyLists> kPolySections = {"VERTICES", "LINES", "POLYGONS", "TRIANGLE_STRIPS"};

class VtkReader {
 public:
  VtkReader(std::string_view file, std::string_view content, bool triangulate)
      : file_(file), scanner_(file, content), builder_(triangulate, 0) {}

  MeshFile read() {
    read_header();
    for (;;) {
      scanner_.at_file_end();
      const std::string_view keyword = scanner_.word();
      if (keyword.empty()) break;
      if (is(keyword, "POINT_DATA") || is(keyword, "CELL_DATA")) {
        skip_data();
        break;
      }
      read_section(keyword);
    }
    if (!has_points_) io::fail(file_, "has no POINTS");
    is_grid_ ? add_grid() : add_poly_data(builder_, lists_, 0, {file_});
    return builder_.finish({file_});
  }

 private:
  static bool is(std::string_view word, std::string_view keyword) { return equal_but_for_case(word, keyword); }

  void read_header() {
    const std::string_view first = scanner_.rest_of_line();
    constexpr std::string_view kStart = "# vtk DataFile Version ";
    if (!is(first.substr(0, kStart.size()), kStart)) {
      io::fail(file_, 1,
               "is no legacy VTK file: its first line is not '# vtk DataFile Version 3.0' or another version");
    }
    const std::string_view version = first.substr(kStart.size());
    const bool is_known = version.size() >= 2 && version[1] == '.' && version[0] >= '2' && version[0] <= '5';
    if (!is_known) io::fail(file_, 1, "version " + io::in_quotes(version) + "; known are 2.0 to 5.1");
    has_offsets_ = version[0] == '5';
    scanner_.skip_line();  // the title
    const std::string_view format = scanner_.next_word();
    is_binary_ = is(format, "BINARY");
    if (!is_binary_ && !is(format, "ASCII")) scanner_.fail(io::in_quotes(format) + " where ASCII or BINARY should be");
    const std::string_view keyword = scanner_.next_word();
    if (!is(keyword, "DATASET")) scanner_.fail(io::in_quotes(keyword) + " where DATASET should be");
    const std::string_view set = scanner_.word();
    is_grid_ = is(set, "UNSTRUCTURED_GRID");
    if (!is_grid_ && !is(set, "POLYDATA")) {
      scanner_.fail("DATASET " + io::in_quotes(set) + "; POLYDATA and UNSTRUCTURED_GRID are read");
    }
    scanner_.end_line("the data set");
  }

  void read_section(std::string_view keyword) {
    if (is(keyword, "POINTS")) {
      read_points();
    } else if (is(keyword, "METADATA")) {
      scanner_.skip_line();
      while (!scanner_.at_end() && !scanner_.at_line_end()) scanner_.skip_line();
    } else if (is(keyword, "FIELD")) {
      skip_field();
    } else if (!has_points_) {
      scanner_.fail(io::in_quotes(keyword) + " where POINTS should be");
    } else if (is_grid_ && is(keyword, "CELLS") && cells_.count() == 0) {
      cells_ = read_cells();
    } else if (is_grid_ && is(keyword, "CELL_TYPES") && cell_types_.empty()) {
      read_cell_types();
    } else if (const auto list = is_grid_ ? std::nullopt : poly_list(keyword); list && lists_[*list].count() == 0) {
      lists_[*list] = read_cells();
    } else {
      scanner_.fail(io::in_quotes(keyword) + (is_grid_ ? " where CELLS, CELL_TYPES, POINT_DATA or CELL_DATA should be"
                                                       : " where VERTICES, LINES, POLYGONS, TRIANGLE_STRIPS, "
                                                         "POINT_DATA or CELL_DATA should be, each at most once"));
    }
  }

  void read_points() {
    if (has_points_) scanner_.fail("POINTS are there twice");
    has_points_ = true;
    const std::uint64_t count = read_count("the number of points");
    const std::string_view type = scanner_.word();
    const bool is_double = is(type, "double");
    if (!is_double && !is(type, "float"))
      scanner_.fail("points of type " + io::in_quotes(type) + "; right are float and double");
    end_keyword("the type of the points");
    std::vector<double>& positions = builder_.positions();
    const std::size_t size = is_double ? 8 : 4;
    if (is_binary_) check_size(count, 3 * size);
    if (!is_binary_) check_size(count, 5);  // three digits, two blanks, and more
    positions.reserve(3 * count);
    for (std::uint64_t i = 0; i < 3 * count; ++i) {
      if (!is_binary_) {
        positions.push_back(scanner_.next_number("a coordinate"));
        continue;
      }
      const char* const at = scanner_.raw_bytes(size).data();
      positions.push_back(is_double ? io::double_at(at, std::endian::big) : io::float_at(at, std::endian::big));
      if (!std::isfinite(positions.back())) {
        io::fail(file_, "point " + std::to_string(i / 3) + " has a coordinate that is not finite");
      }
    }
  }

  /// "n size" and then n times a number of corners and the corners; or, from version 5 on, "n + 1 corners", OFFSETS and
  /// CONNECTIVITY.
  VtkCells read_cells() {
    const std::uint64_t first = read_count("a number of cells");
    const std::uint64_t second = read_count("a number of integers");
    end_keyword("the size of the cells");
    VtkCells cells;
    if (has_offsets_) {
      if (first > 0) read_offsets(cells, first, second);
      return cells;
    }
    if (second < first) scanner_.fail("cells of fewer integers than cells");
    check_size(second, is_binary_ ? 4 : 1);
    cells.starts.reserve(first + 1);
    cells.corners.reserve(second - first);
    std::uint64_t remaining = second;
    for (std::uint64_t cell = 0; cell < first; ++cell) {
      const std::int64_t corners = read_index(4);
      if (corners < 0 || static_cast<std::uint64_t>(corners) >= remaining) {
        position().fail("cell " + std::to_string(cell) + " has " + std::to_string(corners) +
                        " corners, which are more integers than the section announces");
      }
      remaining -= static_cast<std::uint64_t>(corners) + 1;
      for (std::int64_t i = 0; i < corners; ++i) cells.corners.push_back(read_corner(4));
      cells.starts.push_back(cells.corners.size());
    }
    if (remaining != 0) {
      position().fail("the cells have " + std::to_string(remaining) + " integers fewer than the section announces");
    }
    return cells;
  }

  void read_offsets(VtkCells& cells, std::uint64_t count, std::uint64_t corners) {
    const std::size_t offset_size = read_integer_type("OFFSETS");
    check_size(count, is_binary_ ? offset_size : 1);
    cells.starts.clear();
    cells.starts.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::int64_t offset = read_index(offset_size);
      const std::int64_t least = i == 0 ? 0 : static_cast<std::int64_t>(cells.starts.back());
      if (offset < least || static_cast<std::uint64_t>(offset) > corners || (i == 0 && offset != 0)) {
        position().fail("offset " + std::to_string(i) + " is " + std::to_string(offset) +
                        "; offsets start with 0, never fall, and end with the number of corners");
      }
      cells.starts.push_back(static_cast<std::uint64_t>(offset));
    }
    if (cells.starts.back() != corners) {
      position().fail("the last offset is " + std::to_string(cells.starts.back()) + " and not the number of corners, " +
                      std::to_string(corners));
    }
    const std::size_t corner_size = read_integer_type("CONNECTIVITY");
    check_size(corners, is_binary_ ? corner_size : 1);
    cells.corners.reserve(corners);
    for (std::uint64_t i = 0; i < corners; ++i) cells.corners.push_back(read_corner(corner_size));
  }

  std::size_t read_integer_type(std::string_view keyword) {
    const std::string_view found = scanner_.next_word();
    if (!is(found, keyword)) scanner_.fail(io::in_quotes(found) + " where " + std::string(keyword) + " should be");
    const std::string_view type = scanner_.word();
    std::size_t size = 0;
    if (is(type, "vtktypeint64")) size = 8;
    if (is(type, "vtktypeint32") || is(type, "int")) size = 4;
    if (size == 0) scanner_.fail("type " + io::in_quotes(type) + "; right are vtktypeint64, vtktypeint32 and int");
    end_keyword("the type");
    return size;
  }

  void read_cell_types() {
    const std::uint64_t count = read_count("a number of cells");
    end_keyword("the number of cells");
    check_size(count, is_binary_ ? 4 : 1);
    cell_types_.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) cell_types_.push_back(read_index(4));
  }

  void add_grid() {
    if (cell_types_.size() != cells_.count()) {
      io::fail(file_, "has " + std::to_string(cells_.count()) + " CELLS and " + std::to_string(cell_types_.size()) +
                          " CELL_TYPES, and should have as many");
    }
    add_grid_cells(builder_, cells_, cell_types_, 0, {file_});
  }

  /// The index in lists_ of the section of this name.
  static std::optional<std::size_t> poly_list(std::string_view keyword) {
    const auto found = std::find_if(kPolySections.begin(), kPolySections.end(),
                                    [&](std::string_view section) { return is(keyword, section); });
    if (found == kPolySections.end()) return std::nullopt;
    return static_cast<std::size_t>(found - kPolySections.begin());
  }

  /// Data of points and cells come after all elements. A section of elements among them is a line of a keyword and two
  /// numbers; the line of an array, which may have such a name, has a type too. No element is left out in silence.
  void skip_data() {
    const auto is_number = [](std::string_view word) {
      return !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
    };
    while (!scanner_.at_end()) {
      scanner_.skip_line();
      const std::string_view keyword = scanner_.word();
      if (!poly_list(keyword) && !is(keyword, "CELLS")) continue;
      if (!is_number(scanner_.word()) || !is_number(scanner_.word()) || !scanner_.at_line_end()) continue;
      position().fail(io::in_quotes(keyword) + " after the data of points or cells; all elements come before them");
    }
  }

  /// "FIELD name n", and n times "name components tuples type" with its values.
  void skip_field() {
    scanner_.word();
    const std::uint64_t arrays = read_count("a number of arrays");
    end_keyword("the number of arrays");
    for (std::uint64_t i = 0; i < arrays; ++i) {
      std::string_view name = scanner_.next_word();
      if (is(name, "METADATA")) {
        read_section(name);
        name = scanner_.next_word();
      }
      if (name.empty()) scanner_.fail("the file ends before an array of FIELD");
      const std::uint64_t components = read_count("a number of components");
      const std::uint64_t tuples = read_count("a number of tuples");
      const std::string_view type = scanner_.word();
      const auto found =
          std::find_if(kTypes.begin(), kTypes.end(), [&](const ScalarType& t) { return is(type, t.name); });
      if (found == kTypes.end())
        scanner_.fail("an array of FIELD has the type " + io::in_quotes(type) + ", which is not read");
      end_keyword("the type of an array");
      check_size(components, 1);
      check_size(tuples, std::max<std::uint64_t>(components, 1) * (is_binary_ ? found->size : 1));
      if (is_binary_) {
        scanner_.raw_bytes(components * tuples * found->size);
      } else {
        for (std::uint64_t k = 0; k < components * tuples; ++k) {
          if (scanner_.next_word().empty()) scanner_.fail("the file ends within an array of FIELD");
        }
      }
    }
  }

  /// In a binary file the values start after the end of the line. In a text file they may start on the same line.
  void end_keyword(std::string_view what) {
    if (is_binary_) scanner_.end_line(what);
  }

  std::uint64_t read_count(std::string_view what) {
    const std::int64_t count = scanner_.integer(what);
    if (count < 0) scanner_.fail(std::string(what) + " is negative");
    return static_cast<std::uint64_t>(count);
  }

  /// A file of few bytes does not announce much.
  void check_size(std::uint64_t count, std::uint64_t size) {
    if (count > scanner_.remaining() / size) {
      position().fail("announces " + std::to_string(count) + " items, and is too short for them");
    }
  }

  std::int64_t read_index(std::size_t size) {
    if (!is_binary_) return scanner_.next_integer("an integer");
    if (scanner_.remaining() < size) io::fail(file_, "ends within its cells");
    const char* const at = scanner_.raw_bytes(size).data();
    return size == 4 ? static_cast<std::int32_t>(io::unsigned_at<std::uint32_t>(at, std::endian::big))
                     : static_cast<std::int64_t>(io::unsigned_at<std::uint64_t>(at, std::endian::big));
  }

  MeshIndex read_corner(std::size_t size) {
    const std::int64_t index = read_index(size);
    return checked_vertex(index, builder_.vertex_count(), position());
  }

  FilePosition position() const { return {file_, is_binary_ ? 0 : scanner_.line()}; }

  std::string_view file_;
  TextScanner scanner_;
  MeshBuilder builder_;
  bool is_binary_ = false;
  bool has_offsets_ = false;
  bool is_grid_ = false;
  bool has_points_ = false;
  std::array<VtkCells, kPolyLists> lists_;
  VtkCells cells_;
  std::vector<std::int64_t> cell_types_;
};

}  // namespace

MeshFile read_vtk(std::string_view file, std::string_view content, bool triangulate) {
  return VtkReader(file, content, triangulate).read();
}

}  // namespace touchstone::frames
