// STL, of text and binary. A facet repeats the coordinates of its corners; equal coordinates are one vertex.
// SPDX-License-Identifier: MIT
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "frames/formats.hpp"
#include "frames/text_scanner.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"
#include "io/foreign_bytes.hpp"

namespace touchstone::frames {
namespace {

using Corner = std::array<double, 3>;

/// Numbers different points in the order in which they first appear. A hash table with open addressing.
class VertexNumbers {
 public:
  explicit VertexNumbers(std::vector<double>& positions) : positions_(positions), slots_(1024, kNone) {}

  void begin_solid() { ++solid_; }

  /// The number of vertices that are in several solids.
  std::size_t joined() const noexcept { return joined_; }

  MeshIndex number_of(const Corner& corner) {
    if (2 * positions_.size() >= 3 * slots_.size()) grow();
    std::size_t slot = slot_of(corner.data());
    for (; slots_[slot] != kNone; slot = (slot + 1) % slots_.size()) {
      const double* const other = &positions_[3 * std::size_t{slots_[slot]}];
      if (other[0] != corner[0] || other[1] != corner[1] || other[2] != corner[2]) continue;
      std::uint32_t& solid = solids_[slots_[slot]];
      if (solid != solid_ && solid != kSeveral) {
        solid = kSeveral;
        ++joined_;
      }
      return slots_[slot];
    }
    const auto number = static_cast<MeshIndex>(positions_.size() / 3);
    slots_[slot] = number;
    positions_.insert(positions_.end(), corner.begin(), corner.end());
    solids_.push_back(solid_);
    return number;
  }

 private:
  static constexpr MeshIndex kNone = std::numeric_limits<MeshIndex>::max();
  static constexpr std::uint32_t kSeveral = 0;

  std::size_t slot_of(const double* corner) const noexcept {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) {
      const auto bits = std::bit_cast<std::uint64_t>(corner[k] + 0.0);  // -0 + 0 is 0
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29;
    }
    return hash % slots_.size();
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kNone);
    for (std::size_t vertex = 0; vertex < positions_.size() / 3; ++vertex) {
      std::size_t slot = slot_of(&positions_[3 * vertex]);
      while (slots_[slot] != kNone) slot = (slot + 1) % slots_.size();
      slots_[slot] = static_cast<MeshIndex>(vertex);
    }
  }

  std::vector<double>& positions_;
  std::vector<MeshIndex> slots_;       ///< their number is a power of two
  std::vector<std::uint32_t> solids_;  ///< of each vertex, from 1; kSeveral
  std::uint32_t solid_ = 1;
  std::size_t joined_ = 0;
};

constexpr std::size_t kHeader = 84;
constexpr std::size_t kFacet = 50;

std::uint64_t binary_size(std::string_view content) {
  return kHeader + kFacet * std::uint64_t{io::unsigned_at<std::uint32_t>(content.data() + 80, std::endian::little)};
}

MeshFile read_binary(std::string_view file, std::string_view content) {
  MeshBuilder builder(false, 0);
  VertexNumbers numbers(builder.positions());
  const std::size_t facets = (content.size() - kHeader) / kFacet;
  if (facets == 0) io::fail(file, "is a binary STL file without a facet");
  builder.reserve_faces(facets);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    const char* at = content.data() + kHeader + kFacet * facet + 12;  // after the normal
    std::array<MeshIndex, 3> corners;
    for (MeshIndex& number : corners) {
      Corner corner;
      for (double& x : corner) {
        x = io::float_at(at, std::endian::little);
        at += 4;
        if (!std::isfinite(x)) io::fail(file, "facet " + std::to_string(facet) + " has a corner that is not finite");
      }
      number = numbers.number_of(corner);
    }
    builder.add_polygon(corners, facet, {file});
  }
  return builder.finish({file});
}

class TextReader {
 public:
  TextReader(std::string_view file, std::string_view content)
      : file_(file), scanner_(file, content), builder_(false, 0), numbers_(builder_.positions()) {}

  MeshFile read() {
    scanner_.skip_byte_order_mark();
    while (!scanner_.at_file_end()) {
      expect("solid");
      numbers_.begin_solid();
      builder_.set_part(std::string(scanner_.rest_of_line()));
      std::string_view keyword = scanner_.next_word();
      for (; equal_but_for_case(keyword, "facet"); keyword = scanner_.next_word()) read_facet();
      check(keyword, "endsolid", "'facet' or 'endsolid'");
      scanner_.rest_of_line();
    }
    if (facets_ == 0) io::fail(file_, "has no facet");
    MeshFile mesh = builder_.finish({file_});
    mesh.topology.joined_vertices = numbers_.joined();
    return mesh;
  }

 private:
  void read_facet() {
    expect("normal");
    scanner_.rest_of_line();  // the normal is not used, and is often not a number
    expect("outer");
    expect("loop");
    std::array<MeshIndex, 3> corners;
    for (MeshIndex& number : corners) {
      expect("vertex");
      Corner corner;
      for (double& x : corner) x = scanner_.next_number("a coordinate");
      number = numbers_.number_of(corner);
    }
    const std::string_view keyword = scanner_.next_word();
    if (equal_but_for_case(keyword, "vertex")) scanner_.fail("a facet has three vertices; this is a fourth");
    check(keyword, "endloop", "'endloop'");
    expect("endfacet");
    builder_.add_polygon(corners, facets_++, {file_, scanner_.line()});
  }

  void expect(std::string_view keyword) { check(scanner_.next_word(), keyword, io::in_quotes(keyword)); }

  void check(std::string_view found, std::string_view keyword, std::string_view expected) {
    if (equal_but_for_case(found, keyword)) return;
    scanner_.fail(
        (found.empty() ? std::string("the file ends") : io::in_quotes(found)).append(" where ").append(expected) +
        " should be");
  }

  std::string_view file_;
  TextScanner scanner_;
  MeshBuilder builder_;
  VertexNumbers numbers_;
  std::uint64_t facets_ = 0;
};

}  // namespace

// Many binary files start with "solid", too. So the size tells which it is.
MeshFile read_stl(std::string_view file, std::string_view content) {
  const bool has_count = content.size() >= kHeader;
  if (has_count && binary_size(content) == content.size()) return read_binary(file, content);
  io::refuse_foreign_bytes(file, content);
  const bool is_text = content.substr(0, kHeader).find('\0') == std::string_view::npos;
  if (!is_text && has_count) {
    io::fail(file, "is no STL file: it is not text, and a binary file of " +
                       std::to_string((binary_size(content) - kHeader) / kFacet) + " facets has " +
                       std::to_string(binary_size(content)) + " bytes, not " + std::to_string(content.size()));
  }
  if (!is_text) io::fail(file, "is no STL file: it is not text, and a binary file has at least 84 bytes");
  return TextReader(file, content).read();
}

}  // namespace touchstone::frames
