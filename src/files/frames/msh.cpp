// Gmsh's MSH 2.2 and 4.1, of text: points, lines, triangles, quadrangles and tetrahedra of the first order.
// SPDX-License-Identifier: MIT
#include <unordered_map>
#include <vector>

#include "frames/formats.hpp"
#include "frames/text_scanner.hpp"
#include "io/fail.hpp"

namespace touchstone::frames {
namespace {

class MshReader {
 public:
  MshReader(std::string_view file, std::string_view content, bool triangulate)
      : file_(file), scanner_(file, content), builder_(triangulate, 0) {}

  MeshFile read() {
    while (!scanner_.at_file_end()) {
      const std::string_view section = scanner_.word();
      scanner_.end_line("the name of a section");
      if (section.empty() || section.front() != '$') {
        scanner_.fail(io::in_quotes(section) + " where a section should be, such as $Nodes");
      }
      read_section(section.substr(1));
    }
    if (!has_elements_) io::fail(file_, "has no $Elements");
    return builder_.finish({file_});
  }

 private:
  void read_section(std::string_view name) {
    if (name == "MeshFormat") {
      read_format();
    } else if (!has_format_) {
      scanner_.fail("$MeshFormat is not the first section");
    } else if (name == "Nodes") {
      if (builder_.vertex_count() > 0) scanner_.fail("$Nodes are there twice, and can be once");
      is_new_ ? read_blocks_of_nodes() : read_nodes(read_count("the number of nodes"));
    } else if (name == "Elements") {
      if (builder_.vertex_count() == 0) scanner_.fail("$Elements before $Nodes");
      has_elements_ = true;
      if (counts_from_1_) builder_.set_first_number(1);
      is_new_ ? read_blocks_of_elements() : read_elements(read_count("the number of elements"));
    } else if (name == "PartitionedEntities" || name == "Periodic" || name == "Entities" || name == "PhysicalNames" ||
               name == "NodeData" || name == "ElementData" || name == "ElementNodeData" || name == "Comments" ||
               name == "InterpolationScheme" || name == "GhostElements" || name == "Parametrizations") {
      skip_section(name);
      return;
    } else {
      scanner_.fail("the section " + io::in_quotes(name) + " is not known");
    }
    const std::string_view end = scanner_.next_word();
    if (end.empty() || end != "$End" + std::string(name)) {
      scanner_.fail(io::in_quotes(end) + " where $End" + std::string(name) + " should be");
    }
  }

  void read_format() {
    const std::string_view version = scanner_.next_word();
    if (version != "2.2" && version != "4.1") {
      scanner_.fail("version " + io::in_quotes(version) + "; 2.2 and 4.1 are read (gmsh -save -format msh41)");
    }
    is_new_ = version == "4.1";
    if (scanner_.integer("0 for text") != 0) scanner_.fail("a binary file; those of text are read (gmsh -save -bin 0)");
    scanner_.integer("the size of a number");
    has_format_ = true;
  }

  void skip_section(std::string_view name) {
    const std::string end = "$End" + std::string(name);
    while (!scanner_.at_file_end()) {
      if (scanner_.rest_of_line() == end) return;
    }
    scanner_.fail("the file ends before " + end);
  }

  std::uint64_t read_count(std::string_view what) {
    const std::int64_t count = scanner_.next_integer(what);
    if (count < 0 || static_cast<std::uint64_t>(count) > scanner_.remaining()) {
      scanner_.fail("announces " + std::to_string(count) + " items, and is too short for them");
    }
    return static_cast<std::uint64_t>(count);
  }

  void add_node(std::int64_t tag) {
    const auto next = static_cast<MeshIndex>(builder_.vertex_count());
    counts_from_1_ &= tag == std::int64_t{next} + 1;
    if (!node_of_tag_.emplace(tag, next).second) scanner_.fail("node " + std::to_string(tag) + " is there twice");
  }
  void read_position() {
    const double x = scanner_.next_number("x of a node"), y = scanner_.next_number("y of a node"),
                 z = scanner_.next_number("z of a node");
    builder_.add_vertex(x, y, z);
  }

  void read_nodes(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      add_node(scanner_.next_integer("the number of a node"));
      read_position();
    }
  }

  void read_blocks_of_nodes() {
    const std::uint64_t blocks = read_count("the number of blocks");
    for (int i = 0; i < 3; ++i) scanner_.next_integer("a count of nodes, or the least or greatest of their numbers");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      scanner_.next_integer("the dimension of an entity");
      scanner_.next_integer("the number of an entity");
      const bool parametric = scanner_.next_integer("0, or 1 for parametric nodes") != 0;
      if (parametric) scanner_.fail("parametric nodes are not read");
      const std::uint64_t count = read_count("the number of nodes");
      std::vector<std::int64_t> tags;
      for (std::uint64_t i = 0; i < count; ++i) tags.push_back(scanner_.next_integer("the number of a node"));
      for (const std::int64_t tag : tags) {
        add_node(tag);
        read_position();
      }
    }
  }

  void read_elements(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::int64_t number = scanner_.next_integer("the number of an element");
      const std::int64_t type = scanner_.next_integer("the type of an element");
      const std::uint64_t tags = read_count("the number of tags");
      for (std::uint64_t k = 0; k < tags; ++k) scanner_.next_integer("a tag");
      add_element(number, type);
    }
  }

  void read_blocks_of_elements() {
    const std::uint64_t blocks = read_count("the number of blocks");
    for (int i = 0; i < 3; ++i) scanner_.next_integer("a count of elements, or the least or greatest of their numbers");
    for (std::uint64_t block = 0; block < blocks; ++block) {
      scanner_.next_integer("the dimension of an entity");
      scanner_.next_integer("the number of an entity");
      const std::int64_t type = scanner_.next_integer("the type of the elements");
      const std::uint64_t count = read_count("the number of elements");
      for (std::uint64_t i = 0; i < count; ++i) add_element(scanner_.next_integer("the number of an element"), type);
    }
  }

  void add_element(std::int64_t number, std::int64_t type) {
    constexpr std::uint64_t kMostNumber = 0xFFFFFFFF;
    if (number < 0 || static_cast<std::uint64_t>(number) > kMostNumber) {
      scanner_.fail("element " + std::to_string(number) + ": numbers are from 0 to 4294967295");
    }
    const std::size_t corners = type == 15 ? 1 : type == 1 ? 2 : type == 2 ? 3 : type == 3 || type == 4 ? 4 : 0;
    if (corners == 0) {
      scanner_.fail(
          "element " + std::to_string(number) + " has the type " + std::to_string(type) +
          "; 1 to 4 and 15 are read: lines, triangles, quadrangles, tetrahedra and points of the first order");
    }
    corners_.clear();
    for (std::size_t i = 0; i < corners; ++i) {
      const std::int64_t tag = scanner_.next_integer("a node of an element");
      const auto found = node_of_tag_.find(tag);
      if (found == node_of_tag_.end()) scanner_.fail("node " + std::to_string(tag) + " does not exist");
      corners_.push_back(found->second);
    }
    switch (type) {
      case 15: return builder_.add_point(corners_[0]);
      case 1: return builder_.add_edge(corners_[0], corners_[1]);
      case 4: return builder_.add_tetrahedron({corners_[0], corners_[1], corners_[2], corners_[3]}, number_of(number));
      default: return builder_.add_polygon(corners_, number_of(number), {file_, scanner_.line()});
    }
  }

  static std::uint64_t number_of(std::int64_t number) noexcept { return static_cast<std::uint64_t>(number); }

  std::string_view file_;
  TextScanner scanner_;
  MeshBuilder builder_;
  bool has_format_ = false;
  bool is_new_ = false;  // version 4.1
  bool has_elements_ = false;
  bool counts_from_1_ = true;  // the numbers of the nodes are 1, 2, ... in this order
  std::unordered_map<std::int64_t, MeshIndex> node_of_tag_;
  std::vector<MeshIndex> corners_;
};

}  // namespace

MeshFile read_msh(std::string_view file, std::string_view content, bool triangulate) {
  return MshReader(file, content, triangulate).read();
}

}  // namespace touchstone::frames
